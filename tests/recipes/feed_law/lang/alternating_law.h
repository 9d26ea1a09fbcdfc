// The alternating feed law: dl at Smin, dl at Smax, and so on.
//
// Constants without state; any thread.
#pragma once

#include "lang/feed_law/law_type.h"

namespace stanok::lang {

void read_alternating_law(LawReader& reader);
[[nodiscard]] bool is_plausible_alternating_law(const FeedLaw& law);
[[nodiscard]] std::vector<LawValue> values_of_alternating_law(const FeedLaw& law);

inline constexpr std::array alternating_forms{
    law_form("alternating", "alternating", 0, LawAddress::feed_min, LawAddress::feed_max,
             LawAddress::path_step),
};

inline constexpr LawType alternating_law{.name = "alternating",
                                         .kind = FeedLaw::Kind::alternating,
                                         .forms = alternating_forms,
                                         .read = read_alternating_law,
                                         .is_plausible = is_plausible_alternating_law,
                                         .values = values_of_alternating_law,
                                         .takes_feed = {}};

}  // namespace stanok::lang

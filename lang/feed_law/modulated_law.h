// The modulated feed law: from Smin n_s steps of dS up, one after every dl, n_s down, and so on.
//
// Source: docs/programmer/feed-laws.md. Constants without state; any thread.
#pragma once

#include "lang/feed_law/law_type.h"

namespace stanok::lang {

void read_modulated_law(LawReader& reader);
[[nodiscard]] bool is_plausible_modulated_law(const FeedLaw& law);
[[nodiscard]] std::vector<LawValue> values_of_modulated_law(const FeedLaw& law);

inline constexpr std::array modulated_forms{
    law_form("modulated", "modulated", 0, LawAddress::feed_min, LawAddress::feed_step,
             LawAddress::path_step, LawAddress::steps),
    law_form("modulated", "", 0, LawAddress::feed_min, LawAddress::feed_max, LawAddress::feed_step,
             LawAddress::path_step),
};

inline constexpr LawType modulated_law{.name = "modulated",
                                       .kind = FeedLaw::Kind::modulated,
                                       .forms = modulated_forms,
                                       .read = read_modulated_law,
                                       .is_plausible = is_plausible_modulated_law,
                                       .values = values_of_modulated_law,
                                       .takes_feed = {}};

}  // namespace stanok::lang

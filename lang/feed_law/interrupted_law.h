// The interrupted feed law: L_B at the feed F, then the time that L_A would take, standing.
//
// Source: docs/programmer/feed-laws.md. Constants without state; any thread.
#pragma once

#include "lang/feed_law/law_type.h"

namespace stanok::lang {

void read_interrupted_law(LawReader& reader);
[[nodiscard]] bool is_plausible_interrupted_law(const FeedLaw& law);
[[nodiscard]] std::vector<LawValue> values_of_interrupted_law(const FeedLaw& law);

inline constexpr std::array interrupted_forms{
    law_form("interrupted", "interrupt", 0, LawAddress::stand, LawAddress::cut),
};

inline constexpr LawType interrupted_law{.name = "interrupted",
                                         .kind = FeedLaw::Kind::interrupted,
                                         .forms = interrupted_forms,
                                         .read = read_interrupted_law,
                                         .is_plausible = is_plausible_interrupted_law,
                                         .values = values_of_interrupted_law,
                                         .takes_feed = "it cuts and pauses at feed F"};

}  // namespace stanok::lang

// The linear feed law: S_n, and a step of dS after every |dl|. With S_k and without dl, |dl|
// follows from the length of the block; S_k beside dl ends the steps.
//
// Source: docs/programmer/feed-laws.md. Constants without state; any thread.
#pragma once

#include "lang/feed_law/law_type.h"

namespace stanok::lang {

void read_linear_law(LawReader& reader);
[[nodiscard]] bool is_plausible_linear_law(const FeedLaw& law);
[[nodiscard]] std::vector<LawValue> values_of_linear_law(const FeedLaw& law);

inline constexpr std::array linear_forms{
    law_form("linear", "linear", address_bit(LawAddress::feed_last), LawAddress::feed_first,
             LawAddress::feed_step, LawAddress::path_step),
    law_form("linear", "", 0, LawAddress::feed_first, LawAddress::feed_last, LawAddress::feed_step),
};

inline constexpr LawType linear_law{.name = "linear",
                                    .kind = FeedLaw::Kind::linear,
                                    .forms = linear_forms,
                                    .read = read_linear_law,
                                    .is_plausible = is_plausible_linear_law,
                                    .values = values_of_linear_law,
                                    .takes_feed = {}};

}  // namespace stanok::lang

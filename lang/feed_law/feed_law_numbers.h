// A feed law as a row of numbers, for the text of a saved state (lang/actions/saved_state.h).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lang/contract/command.h"

namespace stanok::lang {

// One number for no law; else the fields of the law in their order, then way, feed and speed of
// each point of its curve.
[[nodiscard]] std::vector<double> numbers_of(const FeedLaw& law);
// Nothing when the numbers are no law.
[[nodiscard]] std::optional<FeedLaw> law_of_numbers(std::span<const double> numbers);

}  // namespace stanok::lang

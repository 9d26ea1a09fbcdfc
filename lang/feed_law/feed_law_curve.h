// The feed law that is given as a curve: feeds, perhaps speeds of the spindle, over points of the
// path.
#pragma once

#include <span>

#include "lang/feed_law/feed_law_reader.h"

namespace stanok::lang {

// In program units, as the arrays of #feedlaw (curve, ...) have them.
struct CurveArrays {
  std::span<const double> ways;  // ascending from 0
  std::span<const double> feeds;
  std::span<const double> speeds;  // rev/min; empty: the law leaves the spindle alone
};

[[nodiscard]] bool is_plausible_curve_law(const FeedLaw& law);
[[nodiscard]] std::vector<LawValue> values_of_curve_law(const FeedLaw& law);

// It has no words of its own: #feedlaw (curve, ...) gives its arrays.
inline constexpr LawType curve_law{.name = "curve",
                                   .kind = FeedLaw::Kind::curve,
                                   .forms = {},
                                   .is_plausible = is_plausible_curve_law,
                                   .values = values_of_curve_law,
                                   .takes_feed = {}};

// The law in mm, or why the arrays are no curve.
[[nodiscard]] Expected<FeedLaw, BlockFault> read_feed_curve(const LawSurroundings& around,
                                                            const CurveArrays& arrays);

}  // namespace stanok::lang

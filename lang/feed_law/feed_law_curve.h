// The feed law that is given as a curve: feeds, perhaps speeds of the spindle, over points of the
// path.
#pragma once

#include <optional>
#include <span>

#include "lang/block/active_block.h"
#include "lang/tree/value.h"

namespace stanok::lang {

// In program units, as the arrays of #feedlaw (curve, ...) have them.
struct CurveArrays {
  std::span<const Value> ways;  // ascending from 0
  std::span<const Value> feeds;
  std::span<const Value> speeds;  // rev/min; empty: the law leaves the spindle alone
};

// The law in mm; nothing, with the block failed, when the arrays are no curve.
[[nodiscard]] std::optional<FeedLaw> read_feed_curve(ActiveBlock& block, const CurveArrays& arrays);

}  // namespace stanok::lang

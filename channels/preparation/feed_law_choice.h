// The modules of feed laws: one row per law, from its parameters in the program to the law itself.
#pragma once

#include <memory>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "lang/contract/command.h"
#include "motion/feed_laws/feed_law.h"

namespace stanok::channels {

// Where a law shall run.
struct LawPlace {
  double block_mm = 0.0;      // length of the block it holds for; 0: modal
  double increment_mm = 0.0;  // the finest linear resolution of the channel, Z0
};

// Fails where the parameters do not fit the place (E5105); `wanted` is not off.
[[nodiscard]] Expected<std::unique_ptr<const motion::FeedLaw>, Diagnostic> make_feed_law(
    const lang::FeedLaw& wanted, const LawPlace& place);

}  // namespace stanok::channels

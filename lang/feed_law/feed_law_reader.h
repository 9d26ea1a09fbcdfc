// From the words of a feed law to the law: units, signs, and what each value must be.
#pragma once

#include "base/expected.h"
#include "lang/feed_law/feed_law_words.h"

namespace stanok::lang {

// For which motion a law is: that of its block, or all from here on.
enum class LawScope : std::uint8_t { block, modal };

// What the values of a law depend on beside its words.
struct LawSurroundings {
  FeedMode feed_mode = FeedMode::per_minute;
  double length_unit = 1.0;         // mm per unit of programmed lengths
  double cutting_speed_unit = 1.0;  // m per unit of programmed cutting speeds
  double resolution_mm = 0.0;       // the finest of the channel; 0: not known
};

// The law that the words say, in mm, or which value is wrong.
[[nodiscard]] Expected<FeedLaw, BlockFault> read_feed_law(const LawSurroundings& around,
                                                          const LawForm& form,
                                                          const LawWords& words, LawScope scope);

}  // namespace stanok::lang

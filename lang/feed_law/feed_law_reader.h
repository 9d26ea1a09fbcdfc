// From the words of a feed law to the law: units, signs, and what each value must be.
#pragma once

#include <optional>

#include "lang/block/active_block.h"
#include "lang/feed_law/feed_law_words.h"

namespace stanok::lang {

// For which motion a law is: that of its block, or all from here on.
enum class LawScope : std::uint8_t { block, modal };

// The law that the words say, in mm; nothing, with the block failed, when a value is wrong.
[[nodiscard]] std::optional<FeedLaw> read_feed_law(ActiveBlock& block, const LawForm& form,
                                                   const LawWords& words, LawScope scope);

}  // namespace stanok::lang

// What holds for the feed law of a block, whatever the values of its words are.
#pragma once

#include <optional>
#include <string>

#include "lang/block/block_codes.h"

namespace stanok::lang {

[[nodiscard]] bool has_feed_law(const BlockWords& words);
// Why the block cannot have the law that its words say, nothing when it can or says none; `count`:
// of the axis words, which are for a motion or another code.
[[nodiscard]] std::optional<BlockFault> check_feed_law(const BlockWords& words,
                                                       const BlockCodes& codes,
                                                       AxisWordCount count);
// The first word of a law in a block; no name: there is none.
[[nodiscard]] WordName first_law_word(const BlockWords& words);
// A law that has no path it could be for; `where`: "in a block of `G28`".
[[nodiscard]] BlockFault law_without_path(const BlockWords& words, const std::string& where,
                                          std::string label);

}  // namespace stanok::lang

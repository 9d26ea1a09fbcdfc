// A record of a program after block preparation by its names: what `stanok interpret` and Python
// give.
#pragma once

#include <string>
#include <vector>

#include "base/fields.h"
#include "lang/contract/command.h"
#include "lang/run/block_search.h"
#include "motion/path/path.h"

namespace stanok::jobs {

// `words` are the axis words of the channel; `block` belongs to a Move and holds its end in the
// workpiece system.
[[nodiscard]] Fields record_fields(const lang::Command& command, const motion::PathBlock* block,
                                   const std::vector<std::string>& words);

// What a block search came to, before the first record behind its target.
[[nodiscard]] Fields search_fields(const lang::SearchState& state, const lang::Origin& target,
                                   const std::vector<std::string>& words);

}  // namespace stanok::jobs

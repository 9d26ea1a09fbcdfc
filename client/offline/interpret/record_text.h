// The JSON line of one prepared record, as `stanok interpret` prints it.
#pragma once

#include <string>
#include <vector>

#include "lang/contract/command.h"
#include "lang/run/block_search.h"
#include "motion/path/path.h"

namespace stanok::client {

// Appends the line with its end of line to `text`. `words` are the axis words of the channel;
// `block` belongs to a Move and holds its end in the workpiece system.
void append_record(std::string& text, const lang::Command& command, const motion::PathBlock* block,
                   const std::vector<std::string>& words);

// What a block search came to, before the first record behind its target.
void append_search(std::string& text, const lang::SearchState& state, const lang::Origin& target,
                   const std::vector<std::string>& words);

}  // namespace stanok::client

// The values of a row of the tool table by the names of its keys (config/files/tables_file.h).
#pragma once

#include <string>
#include <string_view>

#include "channels/contract/machine_config.h"
#include "config/files/tables_file.h"

namespace stanok::jobs {

using ToolKey = config::Key<channels::ToolEdge>;

// Must be one of them.
[[nodiscard]] const ToolKey& tool_key(std::string_view name);

[[nodiscard]] bool is_text(const ToolKey& key);
// In mm.
[[nodiscard]] bool is_length(const ToolKey& key);

// Of a key that is a number. False: a whole number is wanted.
[[nodiscard]] bool set_number(channels::ToolEdge& tool, const ToolKey& key, double value);
void set_text(channels::ToolEdge& tool, const ToolKey& key, std::string text);
[[nodiscard]] double number_of(const channels::ToolEdge& tool, const ToolKey& key);
// Of any key, as a person reads it.
[[nodiscard]] std::string text_of(const channels::ToolEdge& tool, const ToolKey& key);

// "0 or more", "1 to 99".
[[nodiscard]] std::string range_of(const ToolKey& key);

// Equal, lengths and angles to a nanometer and a billionth of a degree.
[[nodiscard]] bool are_equal(const channels::ToolEdge& a, const channels::ToolEdge& b,
                             const ToolKey& key);

}  // namespace stanok::jobs

// Where the axes stood last, as a text that reads back the same, to the bit.
#pragma once

#include <filesystem>
#include <string>

#include "channels/contract/machine_config.h"

namespace stanok::config {

// Positions of machine axes in M by their names, mm or deg.
[[nodiscard]] std::string to_positions_text(const channels::AxisRow& positions);

// Throws ConfigError; `file` is for its messages.
[[nodiscard]] channels::AxisRow read_positions_text(const std::string& text,
                                                    const std::filesystem::path& file);

}  // namespace stanok::config

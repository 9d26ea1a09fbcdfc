// Reader of the input of `stanok process lobes`: cut, tool, modes of vibration.
//
// One TOML table with [[mode_x]] and [[mode_y]]; strict as machine files are.
#pragma once

#include <filesystem>
#include <vector>

#include "config/text/key_table.h"
#include "process/chatter/cutting_process.h"

namespace stanok::config {

// Throws ConfigError with all faults.
[[nodiscard]] process::CuttingProcess read_chatter_file(const std::filesystem::path& file);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> chatter_key_rows();
[[nodiscard]] std::vector<KeyRow> vibration_mode_key_rows();

}  // namespace stanok::config

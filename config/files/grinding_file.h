// Reader of the process file of `stanok grind design`: part, wheel, elastic system, force law,
// limits.
//
// One flat TOML table. Strict as machine files are: every fault with file, line, column, key, value
// and the range that is expected; a number that fits another unit says so.
#pragma once

#include <filesystem>
#include <vector>

#include "config/text/key_table.h"
#include "process/grinding/cycle_design.h"

namespace stanok::config {

// Throws ConfigError with all faults.
[[nodiscard]] process::DesignRequest read_grinding_file(const std::filesystem::path& file);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> grinding_key_rows();
[[nodiscard]] std::vector<KeyRow> burn_key_rows();

}  // namespace stanok::config

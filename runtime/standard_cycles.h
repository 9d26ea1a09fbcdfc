// Where the standard cycles of the project stand: searched last, behind the programs' own folders.
#pragma once

#include <filesystem>
#include <vector>

namespace stanok::runtime {

// Folders that exist: beside the sources when run from a build, below share/ when installed.
[[nodiscard]] std::vector<std::filesystem::path> standard_cycle_folders();

}  // namespace stanok::runtime

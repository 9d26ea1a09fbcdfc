// The root of the repository whose files are read.
#pragma once

#include <filesystem>

#include "tests/support/project_folders.h"

namespace stanok::testing {

inline const std::filesystem::path repository = stanok::testing::source_folder();

}  // namespace stanok::testing

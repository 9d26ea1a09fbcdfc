// The root of the repository whose files are read.
#pragma once

#include <filesystem>

namespace stanok::testing {

inline const std::filesystem::path repository = STANOK_SOURCE_DIR;

}  // namespace stanok::testing

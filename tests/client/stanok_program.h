// The real `stanok` of the build and the example programs of the project, for tests that call it.
#pragma once

#include <string>

#include "tests/support/project_folders.h"

namespace stanok::client {

inline const std::string stanok_program = stanok::testing::build_folder() + "/bin/stanok";
inline const std::string example_folder = stanok::testing::source_folder() + "/programs/examples/";

}  // namespace stanok::client

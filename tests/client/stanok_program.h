// The real `stanok` of the build and the example programs of the project, for tests that call it.
#pragma once

#include <string>

namespace stanok::client {

inline const std::string stanok_program = STANOK_BINARY_DIR "/bin/stanok";
inline const std::string example_folder = STANOK_SOURCE_DIR "/programs/examples/";

}  // namespace stanok::client

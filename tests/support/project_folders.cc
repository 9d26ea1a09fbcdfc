#include "tests/support/project_folders.h"

namespace stanok::testing {

std::string source_folder() {
  return STANOK_SOURCE_FOLDER;
}

std::string build_folder() {
  return STANOK_BUILD_FOLDER;
}

}  // namespace stanok::testing

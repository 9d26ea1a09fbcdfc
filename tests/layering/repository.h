// The root of the repository whose files are read, and the libraries that its build makes of them.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "tests/support/project_folders.h"
#include "tests/support/source_tree.h"

namespace stanok::testing {

inline const std::filesystem::path repository = stanok::testing::source_folder();
inline const std::filesystem::path layering =
    std::filesystem::path(stanok::testing::build_folder()) / "layering.txt";

// Folders that hold programs of their own and may include any library; no library may include them.
inline const std::set<std::string> leaves{"tests", "benchmarks", "programs"};

// The library to which a file belongs: the innermost folder around it that is one, a module; or the
// first part of its path.
inline std::string library_of(const Layers& layers, const std::string& file) {
  std::string folder = file.substr(0, file.find('/'));
  if (folder == "stanok_messages") return "messages";
  for (std::size_t end = file.rfind('/'); end != std::string::npos && end > 0;
       end = file.rfind('/', end - 1)) {
    if (layers.contains(file.substr(0, end))) return file.substr(0, end);
  }
  return folder;
}

}  // namespace stanok::testing

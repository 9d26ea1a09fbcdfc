// The repository as the layering tests see it: its C++ files line by line, and the folder arrows of
// the build.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace stanok::testing {

struct SourceFile {
  std::string path;    // from the root: "motion/ring.h"
  std::string folder;  // first part of the path
  std::vector<std::string> lines;

  [[nodiscard]] bool is_header() const { return path.ends_with(".h"); }
};

// Every .h and .cc below `root` but those of build folders, sorted by path.
[[nodiscard]] std::vector<SourceFile> source_files(const std::filesystem::path& root);

// For every folder the folders it may include: itself, its DEPENDS and theirs. `file` holds one
// line a folder, its name and its DEPENDS, as the build wrote it from the top CMakeLists.txt.
using Layers = std::map<std::string, std::set<std::string>>;
[[nodiscard]] Layers read_layers(const std::filesystem::path& file);

// The DEPENDS as written, without the indirect ones.
[[nodiscard]] Layers read_arrows(const std::filesystem::path& file);

}  // namespace stanok::testing

#include "tests/support/source_tree.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace stanok::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Hidden folders and build output are no part of the project.
bool is_foreign(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.starts_with(".") || name == "build" || name == "out";
}

void reach(const Layers& arrows, const std::string& folder, std::set<std::string>& reached) {
  if (!reached.insert(folder).second) return;
  const auto next = arrows.find(folder);
  if (next == arrows.end()) return;
  for (const std::string& dependency : next->second) reach(arrows, dependency, reached);
}

}  // namespace

std::vector<SourceFile> source_files(const fs::path& root) {
  std::vector<SourceFile> files;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::end(entry); ++entry) {
    if (entry->is_directory()) {
      if (is_foreign(entry->path())) entry.disable_recursion_pending();
      continue;
    }
    const fs::path path = fs::relative(entry->path(), root);
    if (path.extension() != ".h" && path.extension() != ".cc") continue;
    files.push_back({path.generic_string(), path.begin()->string(), lines_of(entry->path())});
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

Layers read_arrows(const fs::path& file) {
  Layers arrows;
  for (const std::string& line : lines_of(file)) {
    std::istringstream words(line);
    std::string folder;
    if (!(words >> folder)) continue;
    std::set<std::string>& dependencies = arrows[folder];
    for (std::string dependency; words >> dependency;) dependencies.insert(dependency);
  }
  return arrows;
}

Layers read_layers(const fs::path& file) {
  const Layers arrows = read_arrows(file);
  Layers layers;
  for (const auto& [folder, dependencies] : arrows) reach(arrows, folder, layers[folder]);
  return layers;
}

}  // namespace stanok::testing

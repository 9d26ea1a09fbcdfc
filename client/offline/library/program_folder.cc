#include "client/offline/library/program_folder.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

// Name ends of part programs, as CAM systems and editors write them.
constexpr std::array<std::string_view, 7> program_extensions{".nc",  ".ngc", ".cnc", ".gcode",
                                                             ".tap", ".mpf", ".spf"};

bool is_program(const fs::directory_entry& entry) {
  std::string extension = entry.path().extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return entry.is_regular_file() && std::find(program_extensions.begin(), program_extensions.end(),
                                              extension) != program_extensions.end();
}

std::vector<Candidate> programs_below(const std::string& folder) {
  std::vector<Candidate> found;
  const auto options = fs::directory_options::skip_permission_denied;
  for (const auto& entry : fs::recursive_directory_iterator(folder, options)) {
    if (is_program(entry)) found.push_back({entry.path().lexically_normal().string(), folder});
  }
  if (found.empty()) {
    throw CLI::ValidationError("PROGRAM", "no part program (.nc, .ngc, ...) in " + folder);
  }
  std::sort(found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b) { return a.path < b.path; });
  return found;
}

}  // namespace

Candidates candidates_of(const std::vector<std::string>& names) {
  Candidates candidates;
  for (const std::string& name : names) {
    if (!fs::is_directory(name)) {
      candidates.programs.push_back({name, {}});
      continue;
    }
    candidates.named = ProgramsNamed::by_folders;
    const auto found = programs_below(name);
    candidates.programs.insert(candidates.programs.end(), found.begin(), found.end());
  }
  return candidates;
}

}  // namespace stanok::client

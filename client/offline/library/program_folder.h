// Part programs that the operator named: files, and what lies below folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stanok::client {

// A program and the folder in which it was found; none where the program itself was named.
struct Candidate {
  std::string path;
  std::filesystem::path folder;
};

// Whether programs were named one by one, or folders of them: their results are shown otherwise.
enum class ProgramsNamed { by_files, by_folders };

struct Candidates {
  std::vector<Candidate> programs;  // as they were named; those of a folder by their names
  ProgramsNamed named = ProgramsNamed::by_files;
};

// Throws CLI::ValidationError where a folder has no part program (.nc, .ngc, ...).
[[nodiscard]] Candidates candidates_of(const std::vector<std::string>& names);

}  // namespace stanok::client

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

struct Candidates {
  std::vector<Candidate> programs;  // as they were named; those of a folder by their names
  bool has_folders = false;
};

// Throws CLI::ValidationError where a folder has no part program (.nc, .ngc, ...).
[[nodiscard]] Candidates candidates_of(const std::vector<std::string>& names);

}  // namespace stanok::client

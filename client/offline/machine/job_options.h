// What the off-line commands have in common: machine file, program, channel, schemes, search roots.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "config/files/machine_file.h"

namespace stanok::client {

struct JobOptions {
  std::string machine_file;
  int channel = 1;
  std::vector<std::string> schemes;  // "CH=ID"
  std::string program_root;
  int steps = 0;            // million; 0: as the machine file says
  std::uint64_t limit = 0;  // blocks that are followed; 0: any
  bool json = false;
};

void add_job_options(CLI::App& command, JobOptions& options);
// --steps, of the commands that follow a program without running it.
void add_steps_option(CLI::App& command, JobOptions& options);
// The machine file of the job, with what its options say instead.
[[nodiscard]] config::MachineFile machine_file_of(const JobOptions& options);

// "CH=TEXT" -> channel and text; throws CLI::ValidationError when it is not of this form.
[[nodiscard]] std::pair<int, std::string> channel_assignment(const std::string& text,
                                                             const std::string& option);
[[nodiscard]] std::vector<std::pair<int, int>> scheme_choices(const JobOptions& options);
// The scheme chosen for the channel of the job; -1: the one of the machine file.
[[nodiscard]] int scheme_of(const JobOptions& options);

// A program named on the command line: its folder becomes the first search root, its name what is
// left.
struct LocatedProgram {
  std::string name;
  std::filesystem::path folder;
};
[[nodiscard]] LocatedProgram locate(const std::string& program);

// Search roots: folders of the programs, --program-root, standard cycles beside the program or
// installed.
[[nodiscard]] std::vector<std::filesystem::path> search_roots(
    const std::vector<LocatedProgram>& programs, const JobOptions& options);

}  // namespace stanok::client

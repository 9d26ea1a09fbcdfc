// What a command does with the programs of a library: several at a time, and from the cache where
// the result is there.
//
// Results come in the order of the programs whichever way they are made, and are the same bytes.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "client/offline/library/program_folder.h"
#include "config/files/machine_file.h"
#include "lang/contract/environment.h"
#include "runtime/text_book.h"

namespace stanok::client {

struct LibraryOptions {
  int jobs = 1;       // processes; 0: as many as there are processors
  std::string cache;  // folder; empty: none
  // One process at a time is one beside this one, too, so that a program takes no other with it.
  bool is_isolated = false;
};

void add_library_options(CLI::App& command, LibraryOptions& options);

struct LibraryWork {
  // The result for a program, as bytes. What it reads stands in `book`.
  std::function<std::string(const Candidate& program, runtime::TextBook& book)> result;
  // Gives texts as the work would read them.
  std::function<std::unique_ptr<lang::Files>(const Candidate& program)> files;
  // A digest of all but texts of programs that a result depends on.
  std::function<std::string()> context;
};

// What becomes of the results.
struct LibraryOutput {
  // Called with every program, in their order. `death`: why there is no result; empty: there is.
  std::function<void(const Candidate& program, const std::string& result, const std::string& death)>
      take;
  // Called behind the last one: prints what belongs to all; the exit code.
  std::function<int()> finish;
};

// The exit code. Says on the standard error how many results came from the cache.
[[nodiscard]] int run_library(const Candidates& candidates, const LibraryOptions& options,
                              const LibraryWork& work, const LibraryOutput& output);

// A digest of what a result depends on besides texts of programs: stanok itself, to the bit, the
// files of the machine, and what the command was asked for.
[[nodiscard]] std::string context_of(const config::MachineFile& machine,
                                     const std::vector<std::string>& asked);

}  // namespace stanok::client

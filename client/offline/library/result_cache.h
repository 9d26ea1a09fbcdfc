// ResultCache: what was found out about a program, kept in a folder for the next time.
//
// A result depends on the program's text, on those that it calls and includes, on the machine and
// on stanok itself. The last two, and the options of the command, are the context; the texts are
// noted with the result and asked for again before it is taken: a result is never told of other
// texts than those it was made from. The folder may be shared by several processes and computers,
// and deleted at any time. docs/developer/adr/0029-results-by-digest.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/contract/environment.h"
#include "recording/format/encode_inputs.h"

namespace stanok::client {

class ResultCache {
 public:
  // `context`: a digest of all but the texts of programs.
  ResultCache(std::filesystem::path folder, std::string context);

  // The result kept for the program of that name, when all texts that `files` gives are those that
  // it was made from; else nothing. What is damaged is nothing.
  [[nodiscard]] std::optional<std::string> find(std::string_view program,
                                                const lang::Files& files) const;
  // Keeps a result and the texts that were asked for, and what was not found. False: the folder
  // cannot be written.
  [[nodiscard]] bool keep(std::string_view program,
                          const std::vector<recording::ProgramRead>& reads,
                          std::string_view result) const;

 private:
  [[nodiscard]] std::filesystem::path place_of(std::string_view program) const;

  std::filesystem::path folder_;
  std::string context_;
};

}  // namespace stanok::client

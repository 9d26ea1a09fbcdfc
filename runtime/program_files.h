// ProgramFiles: finds and reads program texts beneath a list of root folders
// (docs/reference/language.md#files-and-numbered-programs).
//
// Names are relative and stay beneath the root that they are found in, through symbolic links too
// (openat2, RESOLVE_BENEATH). A text is read once and whole, and is UTF-8 from here on as far as
// its encoding is known (config/text/text_encoding.h); only regular files are read. What is read of
// an STL file is checked and becomes a short text (lang/contract/blank_file.h). Any thread; holds
// no state but the roots.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "lang/contract/environment.h"
#include "runtime/text_book.h"

namespace stanok::runtime {

// What a program file may be.
struct ProgramFormat {
  std::size_t bytes_max = 0;  // longer files are refused before they are read
  std::string encoding;       // of files that are not UTF-8; empty: unknown
};

class ProgramFiles final : public lang::Files {
 public:
  // Searched in order after the folder of the text that names the file; each with its programs/,
  // subprograms/ and cycles/.
  // What was asked for is noted in `book`, which outlives this; nullptr: nowhere.
  ProgramFiles(std::vector<std::filesystem::path> roots, ProgramFormat format,
               TextBook* book = nullptr);

  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override;

 private:
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> find(
      std::string_view name, std::string_view from) const;
  [[nodiscard]] std::vector<std::filesystem::path> folders_for(std::string_view from) const;

  std::vector<std::filesystem::path> roots_;
  ProgramFormat format_;
  TextBook* book_;
};

[[nodiscard]] ProgramFormat program_format(const channels::MachineConfig& machine);

}  // namespace stanok::runtime

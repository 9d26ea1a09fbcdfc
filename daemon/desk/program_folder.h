// Programs beneath the program root: read, written and removed so that nobody loses what somebody
// else has written.
//
// A text has a version, made of its content. Who replaces or removes a text says which version it
// knows; another one is a conflict (E9019). A text is written beside, brought to the disk and put
// in its place at once: there is the old one or the new one, never half of either. Names stay
// beneath the root, through symbolic links too (runtime/program_files.h). May wait for the disk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "base/expected.h"
#include "protocol/contract/failure.h"
#include "runtime/program_files.h"

namespace stanok::daemon {

struct StoredProgram {
  std::string text;
  std::string version;
  std::filesystem::path path;
};

// What a change expects to find.
struct ExpectedVersion {
  // Nothing: no such program; "any": whatever there is.
  std::optional<std::string> version;
};

class ProgramFolder {
 public:
  ProgramFolder(std::filesystem::path root, runtime::ProgramFormat format)
      : root_(std::move(root)), format_(std::move(format)) {}

  [[nodiscard]] Expected<StoredProgram, protocol::Failure> read(const std::string& name) const;
  // The version that is there now.
  [[nodiscard]] Expected<std::string, protocol::Failure> write(
      const std::string& name, const std::string& text, const ExpectedVersion& expected) const;
  // Nothing: it is removed.
  [[nodiscard]] std::optional<protocol::Failure> remove(const std::string& name,
                                                        const ExpectedVersion& expected) const;

 private:
  [[nodiscard]] std::optional<protocol::Failure> conflict(const std::string& name,
                                                          const std::optional<StoredProgram>& there,
                                                          const ExpectedVersion& expected) const;
  // What there is; nothing: there is no such program. The error: the name or file cannot be used.
  [[nodiscard]] Expected<std::optional<StoredProgram>, protocol::Failure> look(
      const std::string& name) const;

  std::filesystem::path root_;
  runtime::ProgramFormat format_;
};

[[nodiscard]] std::string version_of(const std::string& text);
// A diagnostic of a file as an answer.
[[nodiscard]] protocol::Failure failure_of_diagnostic(const Diagnostic& diagnostic);

}  // namespace stanok::daemon

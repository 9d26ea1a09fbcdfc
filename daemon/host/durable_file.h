// Files that survive a power failure: whole or not there, never half.
//
// The first line says kind, version and checksum of what follows. A new text is written to a
// temporary beside the file, every byte counted, then fsync, the current file becomes the previous
// copy, rename, fsync of the directory. So at any instant the file, or its previous copy, is good.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/expected.h"

namespace stanok::daemon {

struct DurableKind {
  std::string_view name;  // "tables"
  int version = 1;
};

// Nothing, or why it could not be written; the file is then as it was.
[[nodiscard]] std::optional<std::string> write_durably(const std::filesystem::path& file,
                                                       const DurableKind& kind,
                                                       std::string_view text);

struct DurableText {
  std::string text;
  std::string warning;  // not empty: the file is damaged, this is its previous copy
};

// Nothing: there is no such file, nor a previous copy. The error: what there is cannot be used, and
// what to do about it.
[[nodiscard]] Expected<std::optional<DurableText>, std::string> read_durably(
    const std::filesystem::path& file, const DurableKind& kind);

// "FILE.previous"
[[nodiscard]] std::filesystem::path previous_copy(const std::filesystem::path& file);

}  // namespace stanok::daemon

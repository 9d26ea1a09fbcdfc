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
  int version = 0;      // of the kind; no later one
  std::string warning;  // not empty: the file is damaged, this is its previous copy
};

// Nothing: there is no such file, nor a previous copy. The error: what there is cannot be used, and
// what to do about it.
[[nodiscard]] Expected<std::optional<DurableText>, std::string> read_durably(
    const std::filesystem::path& file, const DurableKind& kind);

// Every byte. 0, or the error.
[[nodiscard]] int write_bytes(int file, std::string_view bytes);

// What a new file in it needs to be found after a power failure. 0, or the error.
[[nodiscard]] int sync_folder(const std::filesystem::path& folder);

// A folder, and those above it, that is there after a power failure. 0, or the error.
[[nodiscard]] int make_folder_durably(const std::filesystem::path& folder);

// 16 digits.
[[nodiscard]] std::string text_checksum(std::string_view text);

// "FILE.previous"
[[nodiscard]] std::filesystem::path previous_copy(const std::filesystem::path& file);

}  // namespace stanok::daemon

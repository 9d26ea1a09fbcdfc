// Files that nobody but their owner should read or change: users, sessions.
//
// Written whole or not at all: a new file beside, fsync, rename.
#pragma once

#include <filesystem>
#include <string_view>

namespace stanok::web {

// Throws std::runtime_error where it belongs to somebody else than who runs this, or root; where
// the group may write it, or others may do anything with it.
void refuse_open_file(const std::filesystem::path& file);

// With mode 0600. Throws std::runtime_error; the file is then as it was.
void write_private_file(const std::filesystem::path& file, std::string_view text);

}  // namespace stanok::web

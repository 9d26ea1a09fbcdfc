// Lines at the end of a text file that stays below a bound: reports of programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace stanok::recording {

struct BoundedText {
  std::filesystem::path file;
  std::string_view head;  // of a new file, with its line end
  std::int64_t size_max_bytes = 5'000'000;
};

// Adds a line, with its line end. A file that would become larger than its bound is put aside
// first, as NAME.1.ENDING in place of an older one. Folder and file are made. What a full disk
// leaves of the line is taken back. Returns why nothing was written; empty: it was.
[[nodiscard]] std::string append_line(const BoundedText& text, std::string_view line);

}  // namespace stanok::recording

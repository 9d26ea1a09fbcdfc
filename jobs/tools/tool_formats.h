// The formats of foreign tool libraries: one row each.
//
// Help texts, the table of docs/operator/tool-libraries.md and the tests that read back what was
// written come from these rows. A new format is a pair of files with a reader and a writer, and a
// row.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

// A key of the tables file that a format has, and comes back from it.
struct CarriedKey {
  std::string_view key;
  // Of which kinds of tools, in words of the key `kind`, with blanks between them; empty: of all.
  std::string_view kinds{};
};

// What tells the tools of a file apart.
enum class ToolNumbers : std::uint8_t { number, number_and_edge };

// Decimals of lengths in mm and in inches; all: as many as a length has.
struct Decimals {
  int mm = 0;
  int inch = 0;
};
inline constexpr Decimals all_decimals{};

using ReadTools = ForeignTools (*)(const ForeignSource&);
using WriteTools = std::vector<ForeignFile> (*)(std::span<const channels::ToolEdge>,
                                                const WriteChoice&);

struct ToolFormat {
  std::string_view name;
  std::string_view title;
  std::vector<std::string_view> suffixes;  // in lower case, with the dot
  ReadTools read = nullptr;
  WriteTools write = nullptr;  // null: it is only read
  std::vector<CarriedKey> carried;
  std::vector<std::string_view> kinds;  // of which the kind itself comes back; empty: of none
  ToolNumbers numbers = ToolNumbers::number;
  Decimals decimals = all_decimals;
};

[[nodiscard]] const std::vector<ToolFormat>& tool_formats();

// Null when there is none of this name.
[[nodiscard]] const ToolFormat* tool_format_named(std::string_view name);
// By the end of the file's name; null when no format or several have it.
[[nodiscard]] const ToolFormat* tool_format_of(const std::filesystem::path& file);

// "linuxcnc, csv", for help texts and messages.
[[nodiscard]] std::string names_of_readable_formats();
[[nodiscard]] std::string names_of_writable_formats();

// The rows as a table of the documentation.
[[nodiscard]] std::string table_of_tool_formats();

}  // namespace stanok::jobs

// Import and export of tool libraries: from a foreign file to rows of the tables file and back.
//
// A file is written, read back by the reader of its format, and compared: whatever does not come
// back is reported as not carried. The list can therefore not be forgotten by the writer of a
// format. Faults of a file are thrown as config::ConfigError, all of them.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jobs/tools/foreign_tools.h"
#include "jobs/tools/tool_formats.h"

namespace stanok::jobs {

// No more of a file is read: libraries have some megabytes.
inline constexpr std::size_t library_bytes_max = 64UL << 20;

struct ImportRequest {
  std::filesystem::path file;
  const ToolFormat* format = nullptr;
  std::optional<LengthUnit> unit;
  std::optional<CutterSize> cutter;
};
[[nodiscard]] ForeignTools import_tools(const ImportRequest& request);

struct ExportRequest {
  std::span<const channels::ToolEdge> tools;
  const ToolFormat* format = nullptr;
  WriteChoice choice;
};
struct ExportedTools {
  std::vector<ForeignFile> files;  // the last one is the library, others are named by it
  int tools = 0;                   // how many are in them
  std::vector<NotCarried> not_carried;
};
[[nodiscard]] ExportedTools export_tools(const ExportRequest& request);

// The bytes of a file; throws ConfigError when it cannot be read or is too long.
[[nodiscard]] std::string bytes_of_library(const std::filesystem::path& file);

}  // namespace stanok::jobs

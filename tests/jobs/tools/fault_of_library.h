// A text read in a format: its tools, or the faults of all its lines.
#pragma once

#include <optional>
#include <string>

#include "config/text/config_error.h"
#include "jobs/tools/tool_formats.h"

namespace stanok::jobs {

[[nodiscard]] inline ForeignTools read_as(const char* format, const std::string& bytes,
                                          std::optional<LengthUnit> unit = {},
                                          std::optional<CutterSize> cutter = {},
                                          FileBytes other_file = {}) {
  return tool_format_named(format)->read({.file = "library",
                                          .bytes = bytes,
                                          .unit = unit,
                                          .cutter = cutter,
                                          .other_file = std::move(other_file)});
}

[[nodiscard]] inline std::string fault_as(const char* format, const std::string& bytes) {
  try {
    static_cast<void>(read_as(format, bytes));
  } catch (const config::ConfigError& error) {
    return error.what();
  }
  return "";
}

// "tool 3 A 1.5"; of all that is not carried.
[[nodiscard]] inline std::vector<std::string> lost_in(const ForeignTools& found) {
  std::vector<std::string> lost;
  for (const NotCarried& one : found.not_carried) {
    lost.push_back("tool " + std::to_string(one.tool) + " " + one.field + " " + one.value);
  }
  return lost;
}

}  // namespace stanok::jobs

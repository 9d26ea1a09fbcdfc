// The tool table of LinuxCNC, tool.tbl: a line for each tool.
//
//   T3 P12 Z+77.125 D+6.0 ;end mill 6 mm
//
// T number, P pocket, X to W offsets along the axes, D diameter, I and J front and back angle,
// Q orientation, and a comment. The file does not state its unit, which is that of the machine.
// Source: LinuxCNC, User Manual, "Tool Table Format".
#pragma once

#include <span>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

[[nodiscard]] ForeignTools read_linuxcnc_table(const ForeignSource& source);
[[nodiscard]] std::vector<ForeignFile> write_linuxcnc_table(
    std::span<const channels::ToolEdge> tools, const WriteChoice& choice);

}  // namespace stanok::jobs

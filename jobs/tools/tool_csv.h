// Tools as a table of comma-separated values, for spreadsheets.
//
//   number,edge,name,kind,length_mm,radius_mm,point_angle
//   4,1,drill 8.5,drill,92.4,4.25,140
//
// The first row names keys of the tables file in any order; `number` must be one of them, and
// `diameter` may be written instead of `radius`. A length may have its unit at its end, _mm or
// _inch. An empty cell gives no value.
#pragma once

#include <span>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

[[nodiscard]] ForeignTools read_tool_csv(const ForeignSource& source);
[[nodiscard]] std::vector<ForeignFile> write_tool_csv(std::span<const channels::ToolEdge> tools,
                                                      const WriteChoice& choice);

}  // namespace stanok::jobs

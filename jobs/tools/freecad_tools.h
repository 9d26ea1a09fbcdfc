// Tool bits and libraries of FreeCAD: JSON.
//
// A tool bit (.fctb) has a shape, as endmill.fcstd, and parameters with their units, as "6.0000
// mm". A library (.fctl) gives tool bits their numbers:
//
//   {"version": 1, "tools": [{"nr": 3, "path": "6mm_endmill.fctb"}]}
//
// The bits lie beside the library, or in Bit beside its folder Library. FreeCAD does not know the
// length of a tool in its holder, which is measured on the machine.
// Source: FreeCAD 0.20, Mod/Path/Tools; FreeCAD wiki, "Path ToolBit".
#pragma once

#include <span>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

[[nodiscard]] ForeignTools read_freecad_tools(const ForeignSource& source);
// A library and its bits. Throws ConfigError for a file that ends in .fctb.
[[nodiscard]] std::vector<ForeignFile> write_freecad_tools(
    std::span<const channels::ToolEdge> tools, const WriteChoice& choice);

}  // namespace stanok::jobs

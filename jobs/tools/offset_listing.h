// Offset listings of controls: a program of G10 lines, as Fanuc controls punch it and as Haas
// controls read it.
//
//   G10 L10 P4 R92.400 (DRILL 8.5)      length
//   G10 L11 P4                  wear of the length
//   G10 L12 P4 R4.250                   size of the cutter: its radius or its diameter
//   G10 L13 P4 R0.                      wear of that size
//
// P is the number of the offset, which is taken as that of the tool. G20 and G21 state the unit; a
// setting of the control decides between radius and diameter. Source: Fanuc 16i/18i, Operator's
// Manual, "Changing of tool compensation values (G10)"; Haas, Mill Operator's Manual, "G10".
#pragma once

#include <span>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

// Cutters are radii unless the source says otherwise.
[[nodiscard]] ForeignTools read_fanuc_offsets(const ForeignSource& source);
[[nodiscard]] std::vector<ForeignFile> write_fanuc_offsets(
    std::span<const channels::ToolEdge> tools, const WriteChoice& choice);

// Cutters are diameters unless the source says otherwise (Setting 40).
[[nodiscard]] ForeignTools read_haas_offsets(const ForeignSource& source);
[[nodiscard]] std::vector<ForeignFile> write_haas_offsets(std::span<const channels::ToolEdge> tools,
                                                          const WriteChoice& choice);

}  // namespace stanok::jobs

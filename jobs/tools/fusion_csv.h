// Tables of comma-separated values that Fusion and HSMWorks export. It is only read: Fusion makes a
// library of them again by its own JSON.
//
// A heading has the name of a parameter in parentheses, as "Diameter (tool_diameter)"; there are
// some 170 of them. A tool has a row for each of its presets, with the same tool_index.
#pragma once

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

[[nodiscard]] ForeignTools read_fusion_csv(const ForeignSource& source);

}  // namespace stanok::jobs

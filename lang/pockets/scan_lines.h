// Ways to and fro over a region, on parallel lines, once its edges have been gone around.
#pragma once

#include "lang/pockets/pocket_plan.h"

namespace stanok::lang {

// Appends ways on lines `step_mm` apart to `ways`, which have gone along all `edges`. Where a way
// ends and the next line begins on the same edge, and along it not much farther than straight, the
// tool goes along the edge; else another way begins.
void add_scan_lines(const std::vector<ClosedLine>& edges, ScanLines direction, double step_mm,
                    std::vector<PocketWay>& ways);

}  // namespace stanok::lang

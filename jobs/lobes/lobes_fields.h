// Stability lobes by their names: limits as rows, the whole study as fields.
#pragma once

#include "base/fields.h"
#include "jobs/columns/columns.h"
#include "process/chatter/lobes_study.h"

namespace stanok::jobs {

// speed_rev_per_min, depth_mm (not finite: any depth is stable), chatter_hz (0: not known).
[[nodiscard]] const Columns<process::LimitAt>& lobes_columns();

// Depths that are not limited are none; better speeds and frequencies that are not known are left
// out.
[[nodiscard]] Fields lobes_fields(const process::LobesStudy& study);

}  // namespace stanok::jobs

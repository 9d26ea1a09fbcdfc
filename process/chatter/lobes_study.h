// LobesStudy: stability lobes over a range of speeds, and what to make of them.
//
// Of grinding the speed is that of the part, and the depth is the width of the ground surface.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "process/chatter/semi_discretisation.h"
#include "process/chatter/stability_lobes.h"

namespace stanok::process {

enum class LobesMethod : std::uint8_t { zeroth_order, semi_discretisation };

struct LobesRequest {
  CuttingProcess process;
  LobesMethod method = LobesMethod::zeroth_order;
  double speed_from = 0.0;  // rev/min
  double speed_to = 0.0;
  int count = 0;                      // of speeds
  std::vector<LobePoint> programmed;  // speed and depth of cuts that are planned
};

// A speed and the least depth that is not stable there.
struct LimitAt {
  double speed_rev_per_min = 0.0;
  double depth_mm = 0.0;    // unlimited: every depth is stable
  double chatter_hz = 0.0;  // 0: not known (semi-discretisation)
};

// A planned cut: how much of the limit it takes, and the nearest speed at which it is safe.
struct PlannedCut {
  double speed_rev_per_min = 0.0;
  double depth_mm = 0.0;
  double limit_mm = 0.0;
  double better_speed = 0.0;  // 0: none in the range, or it is safe as it is

  [[nodiscard]] bool is_stable() const { return depth_mm < limit_mm; }
};

struct LobesStudy {
  CutKind kind = CutKind::milling;
  std::vector<LimitAt> limits;  // by speed
  double always_mm = 0.0;       // stable at every speed of the range
  std::vector<LimitAt> best;    // the highest of each lobe, the highest first
  std::vector<PlannedCut> cuts;
};

// `gives_up` is asked at each speed; true ends the study with those that it has come to.
[[nodiscard]] LobesStudy study_lobes(
    const LobesRequest& request, const std::function<bool()>& gives_up = [] { return false; });

}  // namespace stanok::process

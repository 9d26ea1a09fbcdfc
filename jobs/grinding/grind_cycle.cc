#include "jobs/grinding/grind_cycle.h"

namespace stanok::jobs {
namespace {

constexpr double assessed_time_max_s = 3600.0;

}  // namespace

Expected<GrindCycle, process::Findings> designed_cycle(const process::DesignRequest& request,
                                                       const process::Spread& spread) {
  if (spread.is_none()) {
    return process::design_cycle(request).map([&](process::CycleDesign design) {
      return GrindCycle{.request = request, .design = std::move(design), .corners = {}};
    });
  }
  return process::design_robust(request, spread).map([&](process::RobustDesign robust) {
    return GrindCycle{.request = request,
                      .design = std::move(robust.design),
                      .corners = std::move(robust.corners)};
  });
}

GrindCycle assessed_cycle(process::DesignRequest request, const process::InfeedLaw& law) {
  request.simulation.time_max_s = assessed_time_max_s;
  process::CycleDesign design = process::assessed_cycle(request, law);
  return {.request = std::move(request), .design = std::move(design), .corners = {}};
}

std::string control_text(const GrindInput& input, const GrindCycle& cycle) {
  process::ControlFile file =
      input.control.value_or(process::ControlFile{input.request.process, {}, {}});
  file.law = cycle.design.law;
  return process::control_text(file);
}

std::optional<double> three_step_time_s(const process::CycleDesign& design) {
  if (design.three_step_time_s <= 0.0) return std::nullopt;
  return design.three_step_time_s;
}

std::optional<double> continuous_time_s(const process::CycleDesign& design) {
  return design.continuous.run.size_reached_s;
}

}  // namespace stanok::jobs

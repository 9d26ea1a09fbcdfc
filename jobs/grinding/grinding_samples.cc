#include "jobs/grinding/grinding_samples.h"

namespace stanok::jobs {

std::vector<GrindingSample> grinding_samples(const process::GrindingProcess& process,
                                             const process::PlungeRun& run) {
  const process::Boundary boundary(process);
  std::vector<GrindingSample> samples;
  samples.reserve(run.samples.size());
  for (const process::PlungeSample& plunge : run.samples)
    samples.push_back({plunge, plunge.removal_mm2_per_rad / boundary.at(plunge.allowance_mm)});
  return samples;
}

const Columns<GrindingSample>& grinding_columns() {
  using S = GrindingSample;
  constexpr Together first = Together::first;
  constexpr Together peak = Together::peak;
  static const Columns<S> columns{
      {"time_s", 3, first, [](const S& s) { return s.plunge.time_s; }},
      {"x_mm", 5, first, [](const S& s) { return s.plunge.x_mm; }},
      {"allowance_mm", 5, first, [](const S& s) { return s.plunge.allowance_mm; }},
      {"feed_mm_per_s", 5, peak, [](const S& s) { return s.plunge.feed_mm_per_s; }},
      {"removal_mm2_per_rad", 5, peak, [](const S& s) { return s.plunge.removal_mm2_per_rad; }},
      {"removal_ratio", 4, peak, [](const S& s) { return s.removal_ratio; }},
      {"deflection_mm", 5, peak, [](const S& s) { return s.plunge.deflection_mm; }},
  };
  return columns;
}

Columns<GrindingSample> grinding_overview() {
  return columns_named(grinding_columns(), {"time_s", "x_mm", "allowance_mm", "feed_mm_per_s",
                                            "removal_mm2_per_rad", "removal_ratio"});
}

}  // namespace stanok::jobs

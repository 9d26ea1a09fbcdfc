#include "jobs/cutting/cut_columns.h"

namespace stanok::jobs {
namespace {

// Feed in mm per turn as one in mm/min.
double per_minute(double feed_mm, double rev_per_min) {
  return feed_mm * rev_per_min;
}

}  // namespace

const Columns<ForcePlace>& turning_columns() {
  using P = ForcePlace;
  constexpr Together first = Together::first;
  constexpr Together peak = Together::peak;
  static const Columns<P> columns{
      {"line", 0, first, [](const P& p) { return static_cast<double>(p.line); }},
      {"path_mm", 3, first, [](const P& p) { return p.path_mm; }},
      {"x_mm", 4, first, [](const P& p) { return p.x_mm; }},
      {"z_mm", 4, first, [](const P& p) { return p.z_mm; }},
      {"depth_mm", 4, peak, [](const P& p) { return p.depth_mm; }},
      {"feed_programmed_mm", 4, peak, [](const P& p) { return p.feed_programmed; }},
      {"force_programmed_n", 1, peak, [](const P& p) { return p.force_programmed_n; }},
      {"feed_mm", 4, peak, [](const P& p) { return p.feed; }},
      {"force_n", 1, peak, [](const P& p) { return p.force_n; }},
      {"power_w", 1, peak, [](const P& p) { return p.power_w; }},
      {"deflection_um", 2, peak, [](const P& p) { return p.deflection_um; }},
      {"feed_programmed_mm_min", 1, peak,
       [](const P& p) { return per_minute(p.feed_programmed, p.rev_per_min); }},
      {"feed_mm_min", 1, peak, [](const P& p) { return per_minute(p.feed, p.rev_per_min); }},
  };
  return columns;
}

const Columns<MillingPlace>& milling_columns() {
  using P = MillingPlace;
  constexpr Together first = Together::first;
  constexpr Together peak = Together::peak;
  static const Columns<P> columns{
      {"line", 0, first, [](const P& p) { return static_cast<double>(p.line); }},
      {"path_mm", 3, first, [](const P& p) { return p.path_mm; }},
      {"x_mm", 4, first, [](const P& p) { return p.x_mm; }},
      {"y_mm", 4, first, [](const P& p) { return p.y_mm; }},
      {"z_mm", 4, first, [](const P& p) { return p.z_mm; }},
      {"rev_per_min", 0, first, [](const P& p) { return p.rev_per_min; }},
      {"feed_programmed", 1, peak, [](const P& p) { return p.feed_programmed; }},
      {"feed_run", 1, peak, [](const P& p) { return p.feed_run; }},
      {"area_mm2", 4, peak, [](const P& p) { return p.area_mm2; }},
      {"force_mean_n", 1, peak, [](const P& p) { return p.force_mean_n; }},
      {"force_peak_n", 1, peak, [](const P& p) { return p.force_peak_n; }},
      {"power_w", 1, peak, [](const P& p) { return p.power_w; }},
      {"deflection_um", 2, peak, [](const P& p) { return p.deflection_um; }},
      {"feed_planned", 1, peak, [](const P& p) { return p.feed_planned; }},
      {"force_planned_n", 1, peak, [](const P& p) { return p.force_planned_n; }},
      // The same under the names of a turning cut.
      {"force_programmed_n", 1, peak, [](const P& p) { return p.force_peak_n; }},
      {"force_n", 1, peak, [](const P& p) { return p.force_planned_n; }},
      {"feed_programmed_mm_min", 1, peak, [](const P& p) { return p.feed_programmed; }},
      {"feed_mm_min", 1, peak, [](const P& p) { return p.feed_planned; }},
  };
  return columns;
}

Columns<ForcePlace> turning_overview() {
  return columns_named(turning_columns(),
                       {"path_mm", "force_programmed_n", "force_n", "feed_programmed_mm_min",
                        "feed_mm_min", "power_w", "depth_mm", "deflection_um"});
}

Columns<MillingPlace> milling_overview() {
  return columns_named(milling_columns(),
                       {"path_mm", "force_programmed_n", "force_n", "feed_programmed_mm_min",
                        "feed_mm_min", "power_w", "area_mm2", "deflection_um"});
}

}  // namespace stanok::jobs

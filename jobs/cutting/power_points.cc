#include "jobs/cutting/power_points.h"

namespace stanok::jobs {

const Columns<PowerPoint>& power_columns() {
  static const Columns<PowerPoint> columns{
      {"time_s", 3, Together::first, [](const PowerPoint& p) { return p.time_s; }},
      {"recorded_w", 1, Together::peak, [](const PowerPoint& p) { return p.recorded_w; }},
      {"model_w", 1, Together::peak, [](const PowerPoint& p) { return p.model_w; }},
      {"residual_w", 1, Together::peak,
       [](const PowerPoint& p) { return p.recorded_w - p.model_w; }},
  };
  return columns;
}

}  // namespace stanok::jobs

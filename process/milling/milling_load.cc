#include "process/milling/milling_load.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr double rad_per_rev = 2.0 * std::numbers::pi;
constexpr int steps_of_turn = 360;
constexpr int steps_of_pitch_least = 36;

double compliance(const std::vector<VibrationMode>& modes) {
  double sum = 0.0;
  for (const VibrationMode& mode : modes) sum += 1.0 / mode.stiffness_n_per_mm;
  return sum;
}

}  // namespace

MillingLoad::MillingLoad(const CuttingProcess& process, const std::vector<EngagedSlice>& slices,
                         const FeedDirection& feed)
    : compliance_x_(compliance(process.modes_x)), compliance_y_(compliance(process.modes_y)) {
  double tool_radius = 0.0;
  for (const EngagedSlice& slice : slices) tool_radius = std::max(tool_radius, slice.radius_mm);
  const double pitch = rad_per_rev / process.teeth;
  const int steps = std::max(steps_of_turn / process.teeth, steps_of_pitch_least);
  const auto add = [&](const EngagedSlice& slice, double angle, Step& step) {
    const double turned = angle / rad_per_rev - std::floor(angle / rad_per_rev);
    const auto places = slice.meets.size();
    const std::size_t place =
        std::min(checked_size(turned * static_cast<double>(places)), places - 1);
    if (slice.meets[place] == 0) return;
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    // h db for a unit of feed, and db.
    const double chip = slice.width_mm * (feed.across * s - slice.slope * feed.along);
    if (chip <= 0.0) return;
    const double lean = 1.0 / std::hypot(1.0, slice.slope);  // radial part of the normal
    const double edge = slice.width_mm / lean;
    const double tangential = process.force_n_per_mm2 * chip;
    const double radial = process.radial_ratio * tangential * lean;
    const double edge_tangential = process.edge_n_per_mm * edge;
    const double edge_radial = process.edge_radial_n_per_mm * edge * lean;
    step.x -= tangential * c + radial * s;
    step.y += tangential * s - radial * c;
    step.torque += tangential * slice.radius_mm;
    step.edge_x -= edge_tangential * c + edge_radial * s;
    step.edge_y += edge_tangential * s - edge_radial * c;
    step.edge_torque += edge_tangential * slice.radius_mm;
    area_mm2_ += chip * slice.radius_mm * pitch / steps;
  };
  if (slices.empty()) return;
  for (int k = 0; k < steps; ++k) {
    Step step;
    for (int tooth = 0; tooth < process.teeth; ++tooth) {
      for (const EngagedSlice& slice : slices) {
        const double lag = slice.height_mm * std::tan(process.helix_rad) / tool_radius;
        add(slice, pitch * (tooth + (k + 0.5) / steps) - lag, step);
      }
    }
    steps_.push_back(step);
  }
}

MillingForces MillingLoad::at(double feed_per_tooth_mm) const {
  MillingForces forces;
  for (const Step& step : steps_) {
    const double x = step.x * feed_per_tooth_mm + step.edge_x;
    const double y = step.y * feed_per_tooth_mm + step.edge_y;
    forces.mean_x_n += x;
    forces.mean_y_n += y;
    forces.torque_n_mm += step.torque * feed_per_tooth_mm + step.edge_torque;
    forces.peak_n = std::max(forces.peak_n, std::hypot(x, y));
    forces.deflection_mm =
        std::max(forces.deflection_mm, std::hypot(x * compliance_x_, y * compliance_y_));
  }
  if (steps_.empty()) return forces;
  const auto count = static_cast<double>(steps_.size());
  forces.mean_x_n /= count;
  forces.mean_y_n /= count;
  forces.torque_n_mm /= count;
  return forces;
}

// Of each step |f a + e| = P, a quadratic in f; the least of their greater roots.
double MillingLoad::feed_of_peak(double peak_n) const {
  double feed = std::numeric_limits<double>::infinity();
  for (const Step& step : steps_) {
    const double a2 = step.x * step.x + step.y * step.y;
    const double ae = step.x * step.edge_x + step.y * step.edge_y;
    const double e2 = step.edge_x * step.edge_x + step.edge_y * step.edge_y;
    const double rest = e2 - peak_n * peak_n;
    if (rest > 0.0) return 0.0;
    if (a2 <= 0.0) continue;
    feed = std::min(feed, (-ae + std::sqrt(ae * ae - a2 * rest)) / a2);
  }
  return feed;
}

}  // namespace stanok::process

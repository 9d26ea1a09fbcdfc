#include "simulation/engagement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/place.h"

namespace stanok::simulation {
namespace {

constexpr int fine_parts = 4;    // of a slice beside which the engagement is another one
constexpr double inside = 0.05;  // of a cell: how far behind the envelope material is looked for
constexpr double least_radius = 1e-6;

class Envelope {
 public:
  Envelope(const Material& material, const Body& cutting, const ToolPlace& place,
           const Vector& feed_K, SpindleSense sense)
      : material_(material),
        place_(place),
        feed_(feed_K),
        sections_{{BodySection(cutting, place, 0), BodySection(cutting, place, 1),
                   BodySection(cutting, place, 2)}} {
    const Vector across = feed_K - feed_K.dot(place.axis) * place.axis;
    forward_ = across.norm() > parallel ? Vector(across.normalized())
                                        : Vector(place.axis.unitOrthogonal());
    left_ = place.axis.cross(forward_);
    if (sense == SpindleSense::counter_clockwise) left_ = -left_;
  }

  // Nothing: the slice does not meet any material.
  [[nodiscard]] std::optional<EngagementSlice> slice(const ProfileSegment& segment, double from,
                                                     double to) const {
    EngagementSlice slice{.height = 0.5 * (from + to), .width = to - from, .meets = {}};
    slice.radius = segment.radius_at(slice.height);
    if (slice.radius < least_radius) return std::nullopt;
    slice.slope = (segment.c1 + 2.0 * segment.c2 * slice.height) / (2.0 * slice.radius);
    const Vector centre = place_.at(slice.height);
    const Vector reach = Vector::Constant(slice.radius);
    if (!Bounds{centre - reach, centre + reach}.meets(material_.bounds())) return std::nullopt;
    slice.meets.assign(engagement_angles, 0);
    bool is_any = false;
    const double lean = 1.0 / std::hypot(1.0, slice.slope);
    for (int n = 0; n < engagement_angles; ++n) {
      const double angle = 2.0 * std::numbers::pi * (n + 0.5) / engagement_angles;
      const Vector out = std::cos(angle) * left_ + std::sin(angle) * forward_;
      const Vector normal = lean * (out - slice.slope * place_.axis);
      if (normal.dot(feed_) <= 0.0 || !has_material(centre + slice.radius * out, normal)) continue;
      slice.meets[checked_size(n)] = 1;
      is_any = true;
    }
    if (!is_any) return std::nullopt;
    return slice;
  }

 private:
  static constexpr double parallel = 1e-9;

  [[nodiscard]] bool has_material(const Vector& point, const Vector& normal) const {
    const Grid& grid = material_.grid();
    Eigen::Index along = 0;
    normal.cwiseAbs().maxCoeff(&along);
    const int axis = static_cast<int>(along);
    const int first_axis = (axis + 1) % 3;
    const int second_axis = (axis + 2) % 3;
    const int first =
        grid.first_behind(first_axis, point[first_axis] - 0.5 * grid.cell[first_axis]);
    const int second =
        grid.first_behind(second_axis, point[second_axis] - 0.5 * grid.cell[second_axis]);
    if (first < 0 || second < 0 || first >= grid.count[first_axis] ||
        second >= grid.count[second_axis])
      return false;
    double from = 0.0;
    double to = 0.0;
    const BodySection& section = sections_[axis];
    if (!section.meet(grid.middle(first_axis, first), grid.middle(second_axis, second), from, to))
      return false;
    const double step = inside * grid.cell[axis];
    const double position = normal[axis] > 0.0 ? to - step : from + step;
    return material_.family(axis).contains(material_.ray(axis, first, second), position);
  }

  const Material& material_;
  ToolPlace place_;
  Vector feed_;
  Vector forward_;
  Vector left_;
  PerAxis<BodySection> sections_;
};

using Slices = std::vector<std::optional<EngagementSlice>>;

bool are_alike(const std::optional<EngagementSlice>& one,
               const std::optional<EngagementSlice>& other) {
  if (!one || !other) return !one && !other;
  return one->meets == other->meets;
}

void add_segment(const Envelope& envelope, const ProfileSegment& segment, double width,
                 std::vector<EngagementSlice>& all) {
  const double length = segment.to - segment.from;
  const int count = std::max(1, static_cast<int>(std::ceil(length / width - 1e-9)));
  const auto height = [&](double part) { return segment.from + length * part / count; };
  Slices coarse;
  for (int k = 0; k < count; ++k)
    coarse.push_back(envelope.slice(segment, height(k), height(k + 1)));
  for (int k = 0; k < count; ++k) {
    const auto& here = coarse[checked_size(k)];
    const bool is_border = (k > 0 && !are_alike(here, coarse[checked_size(k - 1)])) ||
                           (k + 1 < count && !are_alike(here, coarse[checked_size(k + 1)]));
    if (!is_border) {
      if (here) all.push_back(*here);
      continue;
    }
    for (int n = 0; n < fine_parts; ++n) {
      const double from = k + static_cast<double>(n) / fine_parts;
      if (auto fine = envelope.slice(segment, height(from), height(from + 1.0 / fine_parts)))
        all.push_back(std::move(*fine));
    }
  }
}

}  // namespace

std::vector<EngagementSlice> engagement_of(const Material& material, const ToolSolid& tool,
                                           const ToolPlace& ahead, const Vector& feed_K,
                                           SpindleSense sense) {
  std::vector<EngagementSlice> all;
  const Body& cutting = tool.bodies.front();
  if (!bounds_of(cutting, ahead).meets(material.bounds())) return all;
  const Envelope envelope(material, cutting, ahead, feed_K, sense);
  const double width = material.grid().cell.minCoeff();
  for (const ProfileSegment& segment : cutting.segments) add_segment(envelope, segment, width, all);
  return all;
}

}  // namespace stanok::simulation

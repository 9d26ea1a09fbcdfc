#include "lang/orientation/great_circle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/vector3.h"

namespace stanok::lang {
namespace {

// How far the tool may be off the circle within a part. Shorter parts meet at flatter corners,
// which are passed faster.
constexpr double tolerance_rad = 0.0005 * std::numbers::pi / 180.0;
// How long the first and the last of several parts may be, which are rounded as the program says.
constexpr double end_part_max = 1.0 / 16.0;
// The shortest part of a move. Directions at both of its ends differ by less than 0.001 deg: beside
// a pole the free axis makes half a turn within it.
constexpr double shortest_part = 1.0 / 262144.0;
// Vectors nearer to each other than this, or to being opposite, have no plane.
constexpr double plane_least_rad = 1e-9;

double angle_between(const Vector3<double>& one, const Vector3<double>& other) {
  return std::atan2(one.cross(other).norm(), stanok::dot(one, other));
}

// The great circle between two directions, at a part of the way.
class Circle {
 public:
  Circle(const Direction& from, const Direction& to)
      : from_(vector3(from)), to_(vector3(to)), angle_(angle_between(from_, to_)) {}

  [[nodiscard]] bool has_plane() const {
    return angle_ > plane_least_rad && angle_ < std::numbers::pi - plane_least_rad;
  }
  // Both ends are one direction, which the tool keeps.
  [[nodiscard]] bool is_point() const { return angle_ <= plane_least_rad; }
  [[nodiscard]] Vector3<double> at(double part) const {
    if (part >= 1.0 || is_point()) return to_;
    return (from_ * std::sin((1.0 - part) * angle_) + to_ * std::sin(part * angle_)) /
           std::sin(angle_);
  }

 private:
  Vector3<double> from_;
  Vector3<double> to_;
  double angle_;
};

Vector3<double> tool_at(const ActiveBlock& block, const AxisValues& position_B) {
  return vector3(block.tables.spindle_axes(position_B)[2]);
}

// How far the tool leaves the circle between two parts when the axes move evenly, rad.
double farthest(const ActiveBlock& block, const Circle& circle, double part0,
                const AxisValues& from_B, double part1, const AxisValues& to_B) {
  double most = 0.0;
  for (const double way : {0.25, 0.5, 0.75}) {
    AxisValues between = from_B;
    for (std::size_t k = 0; k < between.size(); ++k) between[k] += way * (to_B[k] - from_B[k]);
    const double off =
        angle_between(tool_at(block, between), circle.at(part0 + way * (part1 - part0)));
    most = std::max(most, off);
  }
  return most;
}

// Of several parts the last one is short.
double end_of_part(double done, double step) {
  const double last = 1.0 - end_part_max;
  const double part = std::min(1.0, done + step);
  return done > 0.0 && done < last ? std::min(part, last) : part;
}

void fail_on_the_way(ActiveBlock& block, const OrientationWish& wish) {
  BlockFault& fault = block.fail("E4354", wish.word,
                                 "on the way to " + std::string(wish.end) +
                                     " the rotary axes would have to turn to their other position",
                                 "out of reach on the way");
  fault.notes.push_back(block.modal.origin_of(wish.said_by));
  fault.help.emplace_back(
      "retract the tool and turn it with a G0 move, or clamp the workpiece differently");
}

// The parts of a way along the circle, from where the block begins; at `end_B`, where it is given,
// the last one ends.
std::optional<std::vector<TurnedPart>> parts_of_circle(ActiveBlock& block,
                                                       const OrientationWish& wish,
                                                       const AxisValues* end_B) {
  AxisValues from_B = block.modal.frame().base_from_work(block.modal.position_W);
  const Circle circle(block.tables.spindle_axes(from_B)[2], wish.tool_B);
  const bool is_followed = circle.has_plane() || (circle.is_point() && end_B != nullptr);
  std::vector<TurnedPart> parts;
  double done = 0.0;
  double step = 1.0;
  while (done < 1.0) {
    const double part = end_of_part(done, step);
    OrientationWish there = wish;
    if (circle.has_plane()) there.tool_B = components(circle.at(part));
    auto found = reachable_angles(block, there, from_B);
    if (!found) return std::nullopt;
    if (part >= 1.0 && end_B != nullptr) found->angles_B = *end_B;
    const double off =
        is_followed ? farthest(block, circle, done, from_B, part, found->angles_B) : 0.0;
    if (off > tolerance_rad) {
      step = done == 0.0 ? std::min(0.5 * step, end_part_max) : 0.5 * (part - done);
      if (step >= shortest_part) continue;
      fail_on_the_way(block, wish);
      return std::nullopt;
    }
    parts.push_back({part, *found});
    from_B = found->angles_B;
    step = 2.0 * (part - done);
    done = part;
  }
  return parts;
}

}  // namespace

std::optional<std::vector<TurnedPart>> great_circle(ActiveBlock& block,
                                                    const OrientationWish& wish) {
  return parts_of_circle(block, wish, nullptr);
}

std::optional<std::vector<TurnedPart>> great_circle(ActiveBlock& block, const OrientationWish& wish,
                                                    const AxisValues& end_B) {
  return parts_of_circle(block, wish, &end_B);
}

}  // namespace stanok::lang

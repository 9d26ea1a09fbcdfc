#include "channels/preparation/face_transformation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/cylinder.h"

namespace stanok::channels {
namespace {

double mm_per_deg(const lang::TransformationChange& change) {
  return change.radius_mm * std::numbers::pi / 180.0;
}

struct Place {
  double x = 0.0;
  double y = 0.0;
};

double distance_of_line(Place from, Place to) {
  const Place way{to.x - from.x, to.y - from.y};
  const double squared = way.x * way.x + way.y * way.y;
  const double share =
      squared == 0.0 ? 0.0 : std::clamp(-(from.x * way.x + from.y * way.y) / squared, 0.0, 1.0);
  return std::hypot(from.x + share * way.x, from.y + share * way.y);
}

// Whether the sweep from `begin` passes `angle`.
bool passes(double begin, double sweep, double angle) {
  const double turn = 2.0 * std::numbers::pi;
  const double ahead = std::remainder(angle - begin, turn);
  const double way = sweep >= 0.0 ? ahead : -ahead;
  return (way < 0.0 ? way + turn : way) <= std::abs(sweep);
}

double distance_of_arc(Place from, Place centre, double sweep) {
  const double radius = std::hypot(from.x - centre.x, from.y - centre.y);
  const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
  const double nearest = std::atan2(-centre.y, -centre.x);
  if (passes(begin, sweep, nearest)) return std::abs(std::hypot(centre.x, centre.y) - radius);
  const Place to{centre.x + radius * std::cos(begin + sweep),
                 centre.y + radius * std::sin(begin + sweep)};
  return std::min(std::hypot(from.x, from.y), std::hypot(to.x, to.y));
}

// Of X, Y and Z the one across the axis of a face; the rotary axis stands for the one behind it.
std::size_t radial_of(const lang::TransformationChange& change) {
  return (AxisIndex(change.replaced).place() + 2) % 3;
}

kinematics::SchemeConfig scheme_of(const lang::TransformationChange& change,
                                   const kinematics::SchemeConfig& active,
                                   kinematics::FaceSide side) {
  return change.kind == lang::Transformation::polar_face
             ? kinematics::face_scheme(active, change.rotary_axis, side, radial_of(change))
             : kinematics::cylinder_scheme(active, change.rotary_axis, change.radius_mm);
}

std::string name_of_change(const lang::TransformationChange& change) {
  return change.kind == lang::Transformation::polar_face ? "face" : "cylinder";
}

Diagnostic refused(std::string message, std::string help) {
  Diagnostic d;
  d.code = "E5104";
  d.message = std::move(message);
  d.help.push_back(std::move(help));
  return d;
}

}  // namespace

std::optional<Diagnostic> FaceTransformation::refusal(const lang::TransformationChange& change,
                                                      const kinematics::Scheme& active) const {
  if (change.kind == lang::Transformation::off) return std::nullopt;
  const std::string defect =
      kinematics::scheme_defect(scheme_of(change, active.config(), kinematics::FaceSide::positive));
  if (!defect.empty()) {
    return refused("no " + name_of_change(change) + " transformation here: " + defect,
                   "change to a scheme of type lathe or cartesian that has the rotary axis first");
  }
  const motion::AxisLimits& limits = motion_.axes[change.rotary_axis];
  const bool is_endless = std::isinf(limits.position_min) && std::isinf(limits.position_max);
  if (change.kind == lang::Transformation::polar_face && !is_endless) {
    return refused("the rotary axis of a face must turn without limits",
                   "remove `min` and `max` from its [[axis]] in the machine file");
  }
  return std::nullopt;
}

void FaceTransformation::begin(const lang::TransformationChange& change,
                               const kinematics::Scheme& active, const motion::Point& axes_M) {
  change_ = change;
  active_ = &active;
  motion::Point point_B{};
  active.forward(kinematics::PointMode::axes, {}, axes_M, point_B);
  const int radial = motion_.geometry[is_on_face() ? radial_of(change) : 0];
  side_ = motion::at(point_B, radial) < 0.0 ? kinematics::FaceSide::negative
                                            : kinematics::FaceSide::positive;
}

kinematics::Transform FaceTransformation::applied_to(const kinematics::Transform& programmed) {
  if (!is_on()) return programmed;
  const AxisIndex rotary = change_.rotary_axis;
  kinematics::SchemeConfig config =
      is_on_face()
          ? kinematics::face_scheme(active_->config(), change_.rotary_axis, side_,
                                    radial_of(change_))
          : kinematics::cylinder_scheme(active_->config(), change_.rotary_axis, change_.radius_mm);
  config.zero[rotary] += programmed.frame.offset[rotary];
  made_.push_back(kinematics::make_scheme(config));
  kinematics::Transform transform = programmed;
  transform.scheme = made_.back().get();
  transform.frame.offset[rotary] = 0.0;
  transform.frame.geometry = geometry();
  return transform;
}

motion::Point FaceTransformation::to_path(motion::Point programmed) const {
  if (change_.kind == lang::Transformation::cylinder)
    programmed[change_.rotary_axis] *= mm_per_deg(change_);
  return programmed;
}

motion::Point FaceTransformation::to_program(motion::Point path) const {
  if (change_.kind == lang::Transformation::cylinder)
    path[change_.rotary_axis] /= mm_per_deg(change_);
  return path;
}

std::array<int, 3> FaceTransformation::geometry() const {
  std::array<int, 3> axes = motion_.geometry;
  if (is_on()) axes[AxisIndex(change_.replaced).place()] = change_.rotary_axis;
  return axes;
}

double FaceTransformation::distance_to_pole(const motion::Point& start,
                                            const motion::PathBlock& block) const {
  const int radial = motion_.geometry[radial_of(change_)];
  const double offset = block.transform->frame.offset[radial];
  const auto place = [&](const motion::Point& point) {
    return Place{motion::at(point, radial) + offset, motion::at(point, change_.rotary_axis)};
  };
  const bool is_arc = block.kind == motion::BlockKind::arc &&
                      block.plane == std::array{radial, change_.rotary_axis};
  if (!is_arc) return distance_of_line(place(start), place(block.end));
  return distance_of_arc(place(start), {block.centre[0] + offset, block.centre[1]},
                         block.sweep_rad);
}

}  // namespace stanok::channels

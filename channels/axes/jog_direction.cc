#include "channels/axes/jog_direction.h"

#include <algorithm>
#include <cmath>

#include "kinematics/linear_axes.h"

namespace stanok::channels {
namespace {

using kinematics::AxisVector;
using kinematics::Jet;

// Where the tool is in the base of the scheme, as it is led by its tip.
kinematics::Transform tip_in_base(const kinematics::Transform& frame) RT_SAFE {
  kinematics::Transform base;
  base.scheme = frame.scheme;
  base.mode = kinematics::PointMode::tip;
  base.tool = frame.tool;
  base.frame.geometry = frame.scheme->config().linear;
  return base;
}

}  // namespace

std::optional<AxisArray<double>> jog_direction(JogFrame kind, int coordinate,
                                               const kinematics::Transform& frame,
                                               const AxisArray<double>& axes_M) RT_SAFE {
  constexpr double nothing = 1e-9;  // of 1 mm: rounding
  if (frame.scheme == nullptr) return std::nullopt;
  const bool is_tool = kind == JogFrame::tool;
  const kinematics::Transform space = is_tool ? tip_in_base(frame) : frame;
  const kinematics::LinearAxes linear(space.frame.geometry);
  AxisVector<double> point{};
  forward(space, axes_M, point);
  const auto along =
      is_tool ? space.scheme->spindle_axes(point)
              : std::array<Vector3<double>, 3>{Vector3<double>::UnitX(), Vector3<double>::UnitY(),
                                               Vector3<double>::UnitZ()};
  const Vector3<double>& unit = along[static_cast<std::size_t>(coordinate)];
  AxisVector<Jet> line{};
  std::ranges::copy(point, line.begin());
  const Vector3<double> at = linear.of(point);
  linear.set<Jet>({Jet(at.x(), unit.x(), 0.0, 0.0), Jet(at.y(), unit.y(), 0.0, 0.0),
                   Jet(at.z(), unit.z(), 0.0, 0.0)},
                  line);
  AxisVector<Jet> axes{};
  inverse(space, line, axes);
  AxisArray<double> direction{};
  const auto& movable = frame.scheme->config().linear;
  for (std::size_t k = 0; k < axes_max; ++k) {
    if (std::abs(axes[k].second) > nothing || std::abs(axes[k].third) > nothing)
      return std::nullopt;
    if (std::abs(axes[k].first) <= nothing) continue;
    if (std::ranges::find(movable, static_cast<int>(k)) == movable.end()) return std::nullopt;
    direction[k] = axes[k].first;
  }
  // An axis that the line wants and the channel lacks is not told by the inverse.
  AxisVector<double> beyond{};
  for (std::size_t k = 0; k < axes_max; ++k) beyond[k] = axes_M[k] + direction[k];
  forward(space, beyond, beyond);
  constexpr double off_max_mm = 1e-6;
  if ((linear.of(beyond) - at - unit).norm() > off_max_mm) return std::nullopt;
  return direction;
}

}  // namespace stanok::channels

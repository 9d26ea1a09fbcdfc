// The frame of the workpiece system W in the base B of the scheme: p_B = rotation * p_W + offset.
//
// The rotation turns the channel's X, Y and Z; other axes are only shifted. mm and deg, in the
// order of the channel's axes.
#pragma once

#include <array>

#include "base/rotation.h"
#include "lang/contract/command.h"

namespace stanok::lang {

// The channel's X, Y and Z, as far as it has them.
using GeometryAxes = std::array<AxisIndex, 3>;

// `values` with its X, Y and Z turned, as a direction; back with `turned_back`.
[[nodiscard]] AxisValues turned(const Rotation& rotation, const GeometryAxes& axes,
                                AxisValues values);
[[nodiscard]] AxisValues turned_back(const Rotation& rotation, const GeometryAxes& axes,
                                     AxisValues values);

struct WorkFrame {
  AxisValues offset{};
  Rotation rotation;
  GeometryAxes geometry{};

  [[nodiscard]] AxisValues base_from_work(const AxisValues& point_W) const;
  [[nodiscard]] AxisValues work_from_base(const AxisValues& point_B) const;
  [[nodiscard]] bool operator==(const WorkFrame&) const = default;
};

}  // namespace stanok::lang

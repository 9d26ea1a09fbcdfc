// A kinematic scheme: the map between the programmed point and the machine axes.
//
// It stands between two levels of abstraction: it knows nothing of the type of path above it and
// nothing of drives below it (seed of the architecture: docs/integrator/kinematics.md). Frames: B
// base of the scheme (zero at the scheme's `zero`, turning with the table), M machine axes, W
// workpiece (work offset, rotation). Axis values stand in the order of the channel's axes, mm and
// deg.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/rotation.h"
#include "base/rt_safe.h"
#include "kinematics/jet.h"
#include "kinematics/length_changes.h"
#include "kinematics/scheme_interface.h"
#include "kinematics/scheme_types.h"

namespace stanok::kinematics {

// One parking move of an axis that does not take part.
struct Parking {
  int axis = 0;           // index in the channel
  double position = 0.0;  // mm or deg
  double velocity = 0.0;  // mm/s or deg/s; 0 = the axis' rapid
  bool brake = true;
  bool drive_off = true;
};

// What stands in a scheme file, resolved to axis indices; made by config. Geometry in mm.
struct SchemeConfig {
  int id = 0;
  std::string type;                             // "cartesian", "head_table", ...
  std::string file;                             // for messages
  std::vector<int> axes;                        // that take part
  AxisVector<double> zero{};                    // of B in M; rotary types: see rotary_scheme.h
  std::vector<Parking> parking;                 // in order
  std::vector<std::pair<int, double>> retract;  // axis, machine position; before parking
  // X, Y, Z of the workpiece space by index in the channel; -1: the channel has none.
  std::array<int, 3> linear{-1, -1, -1};
  SchemeGeometry geometry;  // of `type`
};

// Whether axis `axis` (-1: the channel has no such axis) takes part in the scheme.
[[nodiscard]] bool takes_part(const SchemeConfig& config, int axis);

// A scheme of the type named in the config; nullptr when the type is unknown or the config has a
// defect.
[[nodiscard]] std::unique_ptr<const Scheme> make_scheme(const SchemeConfig& config);
// What the config lacks for its type, in words for the installer; empty: nothing.
[[nodiscard]] std::string scheme_defect(const SchemeConfig& config);
// The zero that a scheme of this type and geometry has when its file gives none.
[[nodiscard]] AxisVector<double> zero_default(const SchemeConfig& config);

// What each machine axis counts per mm or deg of B: 1, -1 where it points the other way, twice that
// where it counts diameters.
[[nodiscard]] AxisVector<double> reading_per_mm(const SchemeConfig& config);

// A type as the reader of scheme files knows it, with the geometry that a file without keys has.
struct TypeOfScheme {
  std::string_view name;
  ChosenBy chosen_by;
  SchemeGeometry geometry;
};
[[nodiscard]] const std::vector<TypeOfScheme>& scheme_types();
// nullptr: no such type.
[[nodiscard]] const TypeOfScheme* find_scheme_type(std::string_view name);
// The keys of a geometry, which refer to its members.
[[nodiscard]] std::vector<SchemeKey> keys_of(SchemeGeometry& geometry);

// Frame of the workpiece: p_B = rotation * p_W + offset. The rotation (G68) turns X, Y and Z; other
// axes are only shifted.
struct Frame {
  AxisVector<double> offset{};
  Rotation rotation;
  std::array<int, 3> geometry{0, 1, 2};  // X, Y, Z by index in the channel; -1: it has none

  [[nodiscard]] bool operator==(const Frame&) const = default;
};

// p_B of a point in W.
[[nodiscard]] AxisVector<double> base_from_workpiece(const Frame& frame,
                                                     const AxisVector<double>& point_W) RT_SAFE;

// What path segments carry: frame, scheme, tool and mode together, fixed for a run of blocks. Owned
// by the channel. The path itself is kept in W, so that a programmed end is reached to the last
// bit.
struct Transform {
  // nullptr: identity, `frame` and `tool` unused (parking and retract moves in M).
  const Scheme* scheme = nullptr;
  Frame frame;
  PointMode mode = PointMode::axes;
  ToolVector tool;
  ToolRow row{};  // from which `tool` was read
};

// Whether they map every point alike, whatever lengths of tools change: the version of the row does
// not count.
[[nodiscard]] bool operator==(const Transform& a, const Transform& b) RT_SAFE;
// With the lengths that count now.
[[nodiscard]] Transform with_changes(const Transform& transform, const LengthChanges& changes)
    RT_SAFE;

void inverse(const Transform& transform, const AxisVector<Jet>& point_W, AxisVector<Jet>& axes_M)
    RT_SAFE;
void inverse(const Transform& transform, const AxisVector<double>& point_W,
             AxisVector<double>& axes_M) RT_SAFE;
void forward(const Transform& transform, const AxisVector<double>& axes_M,
             AxisVector<double>& point_W) RT_SAFE;

}  // namespace stanok::kinematics

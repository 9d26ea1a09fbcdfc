// A kinematic scheme: the map between the programmed point and the machine axes.
//
// It stands between two levels of abstraction: it knows nothing of the type of path above it and
// nothing of drives below it (seed of the architecture: docs/integrator/kinematics.md). Frames: B
// base of the scheme (zero at the scheme's `zero`, turning with the table), M machine axes, W
// workpiece (work offset, rotation). Axis values stand in the order of the channel's axes, mm and
// deg.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/rotation.h"
#include "base/rt_safe.h"
#include "kinematics/jet.h"

namespace stanok::kinematics {

inline constexpr int axes_max = 8;

template <class Scalar>
using AxisVector = std::array<Scalar, axes_max>;

// Geometry of the tool as the transformation needs it: vector from the spindle nose to the tip when
// the head stands at 0, mm.
struct ToolVector {
  std::array<double, 3> nose_to_tip_mm{};
};

// Whether the programmed point is the tool tip led through the rotary axes (RTCP, G43.4) or rides
// on the linear axes (G43, G49).
enum class PointMode : unsigned char { axes, tip };

// One parking move of an axis that does not take part.
struct Parking {
  int axis = 0;           // index in the channel
  double position = 0.0;  // mm or deg
  double velocity = 0.0;  // mm/s or deg/s; 0 = the axis' rapid
  bool brake = true;
  bool drive_off = true;
};

// What the X axis of a lathe counts, and on which side of the workpiece its turret stands
// (lathe.h).
enum class XReading : unsigned char { radius, diameter };
enum class Turret : unsigned char { rear, front };

// What stands in a scheme file, resolved to axis indices; made by config. What only some types have
// is described with them; vectors of rotary axes have the length 1, geometry is in mm.
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
  // head_table: its rotary axes by index in the channel.
  int head_axis = -1;   // on the spindle
  int table_axis = -1;  // under the workpiece
  std::array<double, 3> head_vector{0.0, 1.0, 0.0};
  std::array<double, 3> table_vector{0.0, 0.0, 1.0};
  // head_head, table_table: outer = nearest to the bed or the slides.
  int outer_axis = -1;
  int inner_axis = -1;
  std::array<double, 3> outer_vector{0.0, 0.0, 1.0};
  std::array<double, 3> inner_vector{0.0, 1.0, 0.0};
  std::array<double, 3> pivot_to_pivot{};    // from the outer pivot of a head to the inner
  std::array<double, 3> pivot_to_spindle{};  // from the (inner) pivot to the spindle nose, upright
  std::array<double, 3> table_centre{};      // X, Y, Z with pivot or nose on the (outer) table axis
  std::array<double, 3> centre_to_centre{};  // from the outer centre of a table to the inner
  // lathe, and what rides on it.
  XReading x_reading = XReading::radius;
  Turret turret = Turret::rear;
  // polar_face, cylinder: made from the active scheme, whose type is base_type.
  std::string base_type;
  int rotary_axis = -1;        // whose place in B holds a length in mm
  bool negative_side = false;  // polar_face: the tool works beyond the centre
  double radius_mm = 0.0;      // cylinder
};

// Whether axis `axis` (-1: the channel has no such axis) takes part in the scheme.
[[nodiscard]] bool takes_part(const SchemeConfig& config, int axis);

// Immutable after construction; used by preparation and cycle at the same time.
class Scheme {
 public:
  virtual ~Scheme() = default;
  [[nodiscard]] const SchemeConfig& config() const RT_SAFE { return config_; }
  // Axes that take part, as bits.
  [[nodiscard]] unsigned participants() const RT_SAFE { return participants_; }
  // Whether axis `index` takes part; the others stand parked and are left as they are.
  [[nodiscard]] bool takes_part(int index) const RT_SAFE {
    return (participants_ >> index & 1U) != 0;
  }

  // M from B. Components of axes that do not take part pass through unchanged.
  virtual void inverse(PointMode mode, const ToolVector& tool, const AxisVector<Jet>& point_B,
                       AxisVector<Jet>& axes_M) const RT_SAFE = 0;
  virtual void inverse(PointMode mode, const ToolVector& tool, const AxisVector<double>& point_B,
                       AxisVector<double>& axes_M) const RT_SAFE = 0;
  // B from M.
  virtual void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
                       AxisVector<double>& point_B) const RT_SAFE = 0;

  // Whether lines of B stay lines of M, one parameter for all: second derivatives then come from
  // the path alone.
  [[nodiscard]] virtual bool is_affine(PointMode mode) const RT_SAFE {
    return mode == PointMode::axes;
  }
  // Axes whose position the inverse gives only up to whole turns of 360 deg: bit k for axis k. The
  // caller unwinds them.
  [[nodiscard]] virtual unsigned winding_axes() const RT_SAFE { return 0; }
  // How far the point is from where axes would have to jump, mm; infinite where they never do.
  [[nodiscard]] virtual double distance_to_singularity(const AxisVector<double>&) const RT_SAFE {
    return std::numeric_limits<double>::infinity();
  }

 protected:
  explicit Scheme(SchemeConfig config);

 private:
  SchemeConfig config_;
  unsigned participants_ = 0;
};

// A scheme of the type named in the config; nullptr when the type is unknown or the config has a
// defect. Types are listed once, in scheme.cc.
[[nodiscard]] std::unique_ptr<const Scheme> make_scheme(const SchemeConfig& config);
// What the config lacks for its type, in words for the installer; empty: nothing.
[[nodiscard]] std::string scheme_defect(const SchemeConfig& config);
// The zero that a scheme of this type and geometry has when its file gives none.
[[nodiscard]] AxisVector<double> zero_default(const SchemeConfig& config);
// All types, and those that a file may name; the others are made from the active scheme.
[[nodiscard]] std::vector<std::string> scheme_types();
[[nodiscard]] std::vector<std::string> scheme_types_of_files();

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

// What path pieces carry: frame, scheme, tool and mode together, fixed for a run of blocks. Owned
// by the channel. The path itself is kept in W, so that a programmed end is reached to the last
// bit.
struct Transform {
  // nullptr: identity, `frame` and `tool` unused (parking and retract moves in M).
  const Scheme* scheme = nullptr;
  Frame frame;
  PointMode mode = PointMode::axes;
  ToolVector tool;
};

void inverse(const Transform& transform, const AxisVector<Jet>& point_W, AxisVector<Jet>& axes_M)
    RT_SAFE;
void inverse(const Transform& transform, const AxisVector<double>& point_W,
             AxisVector<double>& axes_M) RT_SAFE;
void forward(const Transform& transform, const AxisVector<double>& axes_M,
             AxisVector<double>& point_W) RT_SAFE;

}  // namespace stanok::kinematics

// Lathe scheme: X across, Z along the spindle, Y where there is one; points always in radius.
//
//   X: M = f_x (B - nose_to_tip) + zero     f_x = 1, 2 where the machine's X counts the diameter
//   Y: M = f_y (B - nose_to_tip) + zero     f_y = 1
//   Z and all others that take part: as cartesian.h
// With the turret in front, X and Y of the machine point against X and Y of the workpiece: f_x and
// f_y change their sign, so that a program (and the tool vector, which is in workpiece directions)
// is the same for both turrets. Diameter programming (G7) is the interpreter's affair: it hands on
// radii. Both point modes are the same. Units mm and deg.
#pragma once

#include "kinematics/cartesian.h"

namespace stanok::kinematics {

// What the X axis counts, and on which side of the workpiece the turret stands.
enum class XReading : unsigned char { radius, diameter };
enum class Turret : unsigned char { rear, front };

struct LatheGeometry {
  XReading x_reading = XReading::radius;
  Turret turret = Turret::rear;

  [[nodiscard]] std::vector<SchemeKey> keys();
};

// What the machine's X, Y and Z count per mm of B: f_x, f_y, f_z.
[[nodiscard]] Vector3<double> reading_per_mm(const LatheGeometry& geometry);

// The map as a value, for schemes that ride on a lathe.
class LatheShift {
 public:
  LatheShift(const SchemeConfig& config, const LatheGeometry& geometry);

  template <class Scalar>
  void inverse(const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    axes_M = point_B;
    linear_.set<Scalar>(factor_.cwiseProduct(linear_.of(axes_M)), axes_M);
    shift_.inverse(as_read(tool), axes_M, axes_M);
  }
  void forward(const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE;

 private:
  // The tool vector in readings of the machine axes.
  [[nodiscard]] ToolVector as_read(const ToolVector& tool) const RT_SAFE;

  AxisShift shift_;
  LinearAxes linear_;
  Vector3<double> factor_;  // machine reading per mm of B, for X, Y, Z: +-1 or +-2, exact
};

class Lathe final : public FormulaScheme<Lathe> {
 public:
  static constexpr std::string_view type_name = "lathe";
  using Geometry = LatheGeometry;

  explicit Lathe(const SchemeConfig& config);
  // X and Z must take part.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);

  template <class Scalar>
  void to_axes(PointMode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    shift_.inverse(tool, point_B, axes_M);
  }
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;

 private:
  LatheShift shift_;
};

// What the schemes of the turned workpiece (polar_face, cylinder) take over from the active scheme,
// on which they ride: one of type cartesian or lathe.
struct TurnedWorkpiece {
  std::string base_type;  // of the active scheme
  LatheGeometry lathe;
  int rotary_axis = -1;  // whose place in B holds a length in mm
};

[[nodiscard]] TurnedWorkpiece turned_workpiece(const SchemeConfig& active, int rotary_axis);

// "" or what is missing: X, or another `radial` of X, Y and Z, and `rotary_axis` must take part.
[[nodiscard]] std::string turned_workpiece_defect(const SchemeConfig& config,
                                                  const TurnedWorkpiece& workpiece,
                                                  std::size_t radial = 0);

}  // namespace stanok::kinematics

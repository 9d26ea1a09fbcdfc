// Cartesian scheme: programmed point and machine axes differ by a shift of every axis.
//
// X, Y, Z: M = B + zero - nose_to_tip. The tip of a tool of length L hangs below the spindle nose,
// nose_to_tip = (0, 0, -L), so the nose stands higher: M_Z = B_Z + zero_Z + L. All other axes that
// take part: M = B + zero. Both point modes are the same: no rotary axis turns tool or workpiece
// in this scheme's eyes. Units mm and deg; bits of the values are kept where the shift is zero.
#pragma once

#include <string>
#include <vector>

#include "kinematics/formula_scheme.h"
#include "kinematics/linear_axes.h"
#include "kinematics/scheme_key.h"

namespace stanok::kinematics {

// X, Y and Z; none for those that do not take part.
[[nodiscard]] LinearAxes linear_axes(const SchemeConfig& config);

// The shift as a value, for schemes that ride on the linear axes in PointMode::axes.
class AxisShift {
 public:
  explicit AxisShift(const SchemeConfig& config);

  template <class Scalar>
  void inverse(const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    for (std::size_t axis = 0; axis < axes_max; ++axis) {
      axes_M[axis] = point_B[axis] + zero_[axis];
    }
    linear_.subtract(tool.nose_to_tip_mm, axes_M);
  }
  void forward(const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE;

 private:
  AxisVector<double> zero_{};  // 0 for axes that do not take part
  LinearAxes linear_;          // none for axes that do not take part
};

class Cartesian final : public FormulaScheme<Cartesian> {
 public:
  static constexpr std::string_view type_name = "cartesian";

  struct Geometry {
    [[nodiscard]] std::vector<SchemeKey> keys() { return {}; }
  };

  explicit Cartesian(const SchemeConfig& config);
  // At least one axis must take part.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);

  template <class Scalar>
  void to_axes(PointMode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    shift_.inverse(tool, point_B, axes_M);
  }
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;

 private:
  AxisShift shift_;
};

}  // namespace stanok::kinematics

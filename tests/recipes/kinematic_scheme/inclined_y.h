// Inclined Y: a turning center whose Y slide runs at an angle to Y and carries along X.
//
// With a the angle from Y towards X, and X, Y the readings less their zeros:
//   tip  x = X + Y sin a    y = Y cos a      so     Y = y / cos a    X = x - y tan a
// Z and all others that take part: as cartesian.h. Both point modes are the same. Units mm and deg.
#pragma once

#include "kinematics/cartesian.h"

namespace stanok::kinematics {

class InclinedY final : public FormulaScheme<InclinedY> {
 public:
  static constexpr std::string_view type_name = "inclined_y";

  struct Geometry {
    double angle_deg = 30.0;

    [[nodiscard]] std::vector<SchemeKey> keys();
  };

  explicit InclinedY(const SchemeConfig& config);
  // X and Y must take part.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);

  template <class Scalar>
  void to_axes(PointMode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    axes_M = point_B;
    linear_.subtract(tool.nose_to_tip_mm, axes_M);
    axes_M[linear_.x] = axes_M[linear_.x] - (sine_ / cosine_) * axes_M[linear_.y];
    axes_M[linear_.y] = (1.0 / cosine_) * axes_M[linear_.y];
    shift_.inverse({}, axes_M, axes_M);
  }
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;

 private:
  AxisShift shift_;
  LinearAxes linear_;
  double sine_;
  double cosine_;
};

}  // namespace stanok::kinematics

// Cylinder scheme (G7.1): milling on the side of a turned workpiece as if it were rolled out flat.
//
// In the point B the developed length u along the circumference of radius R, in mm, stands in the
// place of the rotary axis:
//   C: M = u / R + zero   in deg, without wrapping: the length may go round many times
// All other axes, X (the depth) among them: as lathe.h. There is no singularity.
#pragma once

#include "kinematics/lathe.h"

namespace stanok::kinematics {

class Cylinder final : public FormulaScheme<Cylinder> {
 public:
  static constexpr std::string_view type_name = "cylinder";
  static constexpr ChosenBy chosen_by = ChosenBy::program;

  struct Geometry : TurnedWorkpiece {
    double radius_mm = 0.0;

    [[nodiscard]] std::vector<SchemeKey> keys() { return {}; }
  };

  explicit Cylinder(const SchemeConfig& config);
  // The radius must be positive, besides turned_workpiece_defect.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);

  template <class Scalar>
  void to_axes(PointMode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    axes_M = point_B;
    axes_M[rotary_] = (1.0 / mm_per_deg_) * point_B[rotary_];
    shift_.inverse(tool, axes_M, axes_M);
  }
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;

 private:
  Cylinder(const SchemeConfig& config, const Geometry& geometry);

  LatheShift shift_;
  AxisIndex rotary_;
  double mm_per_deg_ = 1.0;  // of the circumference
};

// The scheme of a channel while G7.1 is on: `active` (cartesian or lathe) with the side of the
// cylinder of `radius_mm` about `rotary_axis`, index in the channel.
[[nodiscard]] SchemeConfig cylinder_scheme(const SchemeConfig& active, int rotary_axis,
                                           double radius_mm);

}  // namespace stanok::kinematics

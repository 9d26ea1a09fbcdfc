// Polar face scheme (G12.1): milling on the end face of a turned workpiece with X and C alone (or Y
// and A, Z and B).
//
// The program thinks in a plane (x, y) that is fixed to the workpiece. In the point B, x stands in
// the place of X and y, in mm, in the place of the rotary axis; the machine goes there by radius
// and angle:
//   X: B' = +-hypot(x, y)            then as lathe.h: x_reading, turret, zero, tool vector
//   C: M  = atan2(+-y, +-x) + zero   in deg, a positive angle turns the tool round the workpiece
//                                    counter-clockwise, seen against Z (ISO 841)
// The lower signs are the negative side: the tool works beyond the centre of the workpiece. All
// other axes: as lathe.h. C is given in (-180, 180] before the zero; whole turns are the caller's
// (winding_axes). About X the radius is that of Y, about Y that of Z, in the same way. The pole x =
// y = 0 is singular: within 1e-9 mm of it the angle is taken as 0 and all derivatives of radius and
// angle as 0, callers keep away from it (distance_to_singularity).
#pragma once

#include "kinematics/angle_units.h"
#include "kinematics/lathe.h"

namespace stanok::kinematics {

// Radius in mm and angle in rad of a plane point; both 0 within the pole radius. The derivatives of
// a moving point are exact.
template <class Scalar>
struct Polar {
  Scalar radius;
  Scalar angle;
};
[[nodiscard]] Polar<double> polar(double x, double y) RT_SAFE;
[[nodiscard]] Polar<Jet> polar(const Jet& x, const Jet& y) RT_SAFE;

class PolarFace final : public FormulaScheme<PolarFace> {
 public:
  static constexpr std::string_view type_name = "polar_face";
  static constexpr ChosenBy chosen_by = ChosenBy::program;

  struct Geometry : TurnedWorkpiece {
    bool negative_side = false;  // the tool works beyond the centre
    std::size_t radial = 0;      // of X, Y and Z the one that goes across the axis of rotation

    [[nodiscard]] std::vector<SchemeKey> keys() { return {}; }
  };

  explicit PolarFace(const SchemeConfig& config);
  [[nodiscard]] static std::string defect(const SchemeConfig& config);

  template <class Scalar>
  void to_axes(PointMode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    const Polar<Scalar> at = polar(side_ * point_B[x_], side_ * point_B[rotary_]);
    axes_M = point_B;
    axes_M[x_] = side_ * at.radius;
    axes_M[rotary_] = deg_per_rad * at.angle;
    shift_.inverse(tool, axes_M, axes_M);
  }
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;
  [[nodiscard]] bool is_affine(PointMode) const RT_SAFE override { return false; }
  [[nodiscard]] unsigned winding_axes() const RT_SAFE override { return rotary_.bit(); }
  [[nodiscard]] double distance_to_singularity(const AxisVector<double>& point_B) const
      RT_SAFE override;

 private:
  PolarFace(const SchemeConfig& config, const Geometry& geometry);

  LatheShift shift_;
  AxisIndex x_;
  AxisIndex rotary_;
  double side_ = 1.0;  // -1: the negative side
};

// Of the centre, on which the tool works.
enum class FaceSide : std::uint8_t { positive, negative };

// The scheme of a channel while G12.1 is on: `active` (cartesian or lathe) with the plane of its X,
// or another `radial` of X, Y and Z, and `rotary_axis`, index in the channel.
[[nodiscard]] SchemeConfig face_scheme(const SchemeConfig& active, int rotary_axis, FaceSide side,
                                       std::size_t radial = 0);

}  // namespace stanok::kinematics

// Head-table scheme: head B turns the spindle about Y, table C turns the workpiece about Z.
//
// With B, C the programmed angles, t = pivot_to_spindle + nose_to_tip the vector from the pivot of
// the head to the tool tip at B = 0, c0 = table_centre, X the machine axes X, Y, Z (the pivot's
// position), p the tip in the base frame:
//   X = c0 + Rz(C) p - Ry(B) t        p = Rz(C)^T (X + Ry(B) t - c0)
// The base frame has its origin at c0 and turns with the table; it lies along M at C = 0. The tool
// then points along o = (sin B cos C, -sin B sin C, cos B) in it (from tip to nose).
//
// PointMode::axes rides on the linear axes as cartesian.h does, M = B + zero - nose_to_tip. Both
// modes name the same point at B = C = 0 when zero = c0 - pivot_to_spindle, which is what config
// fills in when the scheme file leaves the linear zeros out. Rotary axes: M = B + zero in both
// modes: `zero` is the reading at which the head is upright and the base lies along M. Lengths mm;
// angles deg outside, rad inside. Derivation and pictures: docs/kinematics.md.
#pragma once

#include "kinematics/cartesian.h"

namespace stanok::kinematics {

class HeadTable final : public Scheme {
 public:
  explicit HeadTable(const SchemeConfig& config);

  void inverse(PointMode mode, const ToolVector& tool, const AxisVector<Jet>& point_B,
               AxisVector<Jet>& axes_M) const RT_SAFE override;
  void inverse(PointMode mode, const ToolVector& tool, const AxisVector<double>& point_B,
               AxisVector<double>& axes_M) const RT_SAFE override;
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;

 private:
  template <class Scalar>
  void lead_tip(const ToolVector& tool, const AxisVector<Scalar>& point_B,
                AxisVector<Scalar>& axes_M) const RT_SAFE;

  // Pivot to tip at B = 0.
  [[nodiscard]] std::array<double, 3> pivot_to_tip(const ToolVector& tool) const RT_SAFE;

  AxisShift shift_;
  std::array<std::size_t, 3> linear_{};  // X, Y, Z
  std::size_t head_ = 0;                 // B
  std::size_t table_ = 0;                // C
  std::array<double, 3> pivot_to_spindle_;
  std::array<double, 3> table_centre_;
};

// "" or what is missing: X, Y, Z, the head axis and the table axis must take part.
[[nodiscard]] std::string head_table_defect(const SchemeConfig& config);

}  // namespace stanok::kinematics

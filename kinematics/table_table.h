// Table-table scheme: both rotary axes turn the workpiece, the spindle stands upright (trunnions:
// the outer axis rocks, the inner one turns the plate).
//
// With R1 the turn of the outer axis (nearest to the bed), R2 of the inner one (nearest to the
// workpiece), c1 = table_centre, d = centre_to_centre from the outer centre to the inner, X the
// machine axes X, Y, Z (the spindle nose's position), p the tip in the base frame:
//   X = c1 + R1 (d + R2 p) - nose_to_tip
// table_centre is the position of X, Y, Z with the nose at a point of the outer axis, the outer
// centre. The base frame has its origin at the inner centre and turns with both axes; it lies along
// M at zero angles. Both point modes name the same point there when zero = c1 + d, which is the
// default of the linear zeros.
#pragma once

#include "kinematics/rotary_scheme.h"

namespace stanok::kinematics {

class TableTable final : public RotaryScheme {
 public:
  static constexpr std::string_view type_name = "table_table";

  struct Geometry {
    int outer_axis = -1;  // by index in the channel
    int inner_axis = -1;
    Vector3<double> outer_vector{0.0, 0.0, 1.0};
    Vector3<double> inner_vector{0.0, 1.0, 0.0};
    Vector3<double> table_centre{};
    Vector3<double> centre_to_centre{};

    [[nodiscard]] std::vector<SchemeKey> keys();
  };

  explicit TableTable(const SchemeConfig& config);
  // X, Y, Z and both rotary axes must take part.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);
  // The zero of X, Y, Z with which both point modes name the same point at zero angles.
  [[nodiscard]] static AxisVector<double> zero_default(const SchemeConfig& config);

 private:
  TableTable(const SchemeConfig& config, const Geometry& geometry);
};

}  // namespace stanok::kinematics

// Head-table scheme: one rotary axis turns the spindle, one turns the workpiece.
//
// With h the head's angle about head_vector (default Y), w the table's about table_vector (default
// Z), t = pivot_to_spindle + nose_to_tip the vector from the pivot of the head to the tool tip at
// h = 0, c0 = table_centre, X the machine axes X, Y, Z (the pivot's position), p the tip in the
// base frame:
//   X = c0 + Rt(w) p - Rh(h) t        p = Rt(w)^T (X + Rh(h) t - c0)
// The base frame has its origin at c0 and turns with the table; it lies along M at w = 0. With the
// default vectors the tool points along o = (sin B cos C, -sin B sin C, cos B) in it (from tip to
// nose). Both point modes name the same point at h = w = 0 when zero = c0 - pivot_to_spindle, which
// is the default of the linear zeros.
#pragma once

#include "kinematics/rotary_scheme.h"

namespace stanok::kinematics {

class HeadTable final : public RotaryScheme {
 public:
  static constexpr std::string_view type_name = "head_table";

  struct Geometry {
    int head_axis = -1;   // on the spindle, by index in the channel
    int table_axis = -1;  // under the workpiece
    Vector3<double> head_vector{0.0, 1.0, 0.0};
    Vector3<double> table_vector{0.0, 0.0, 1.0};
    Vector3<double> pivot_to_spindle{};
    Vector3<double> table_centre{};

    [[nodiscard]] std::vector<SchemeKey> keys();
  };

  explicit HeadTable(const SchemeConfig& config);
  // X, Y, Z and both rotary axes must take part.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);
  // The zero of X, Y, Z with which both point modes name the same point at zero angles.
  [[nodiscard]] static AxisVector<double> zero_default(const SchemeConfig& config);

 private:
  HeadTable(const SchemeConfig& config, const Geometry& geometry);
};

}  // namespace stanok::kinematics

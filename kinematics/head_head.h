// Head-head scheme: both rotary axes turn the spindle, the workpiece stands on the bed (gantry and
// fork-head mills, portal robots of the aircraft trade).
//
// With R1 the turn of the outer axis (nearest to the slides), R2 of the inner one (nearest to the
// spindle), a = pivot_to_pivot from the outer pivot to the inner, b = pivot_to_spindle from the
// inner pivot to the spindle nose, X the machine axes X, Y, Z (the outer pivot's position):
//   X = c + p - R1 (a + R2 (b + nose_to_tip))      c = zero + a + b
// The base stands on the bed: its origin is where the spindle nose stands when the axes read `zero`
// and the head is upright. Both point modes therefore name the same point at zero angles whatever
// the linear zeros are.
#pragma once

#include "kinematics/rotary_scheme.h"

namespace stanok::kinematics {

class HeadHead final : public RotaryScheme {
 public:
  static constexpr std::string_view type_name = "head_head";

  struct Geometry {
    int outer_axis = -1;  // by index in the channel
    int inner_axis = -1;
    Vector3<double> outer_vector{0.0, 0.0, 1.0};
    Vector3<double> inner_vector{0.0, 1.0, 0.0};
    Vector3<double> pivot_to_pivot{};
    Vector3<double> pivot_to_spindle{};

    [[nodiscard]] std::vector<SchemeKey> keys();
  };

  explicit HeadHead(const SchemeConfig& config);
  // X, Y, Z and both rotary axes must take part.
  [[nodiscard]] static std::string defect(const SchemeConfig& config);

 private:
  HeadHead(const SchemeConfig& config, const Geometry& geometry);
};

}  // namespace stanok::kinematics

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
  explicit HeadHead(const SchemeConfig& config);
};

// "" or what is missing: X, Y, Z, the outer and the inner axis must take part.
[[nodiscard]] std::string head_head_defect(const SchemeConfig& config);

}  // namespace stanok::kinematics

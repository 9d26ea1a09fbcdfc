// Base of the schemes whose rotary axes turn tool and workpiece: head_table, head_head,
// table_table.
//
// Two chains meet at the tool tip. The head hangs on the linear axes X, the table stands on the bed
// at `centre` c:
//   tip             X + head.reach(nose_to_tip)       (in M)
//   workpiece point c + table.reach(p)                (in M; p in the base frame B)
// so, in PointMode::tip,
//   inverse  X = table.reach(p) + (c - head.reach(nose_to_tip))
//   forward  p = table.reach_back(X + head.reach(nose_to_tip) - c)
// PointMode::axes rides on the linear axes as cartesian.h does, M = B + zero - nose_to_tip. Rotary
// axes: M = B + zero in both modes: `zero` is the reading at which an angle counts as 0. A derived
// type only lays down its geometry. Derivation and pictures: docs/integrator/kinematics.md.
#pragma once

#include <string_view>

#include "kinematics/cartesian.h"
#include "kinematics/rotary_chain.h"

namespace stanok::kinematics {

class RotaryScheme : public FormulaScheme<RotaryScheme> {
 public:
  template <class Scalar>
  void to_axes(PointMode mode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    if (mode == PointMode::axes) {
      shift_.inverse(tool, point_B, axes_M);
      return;
    }
    const Vector3<Scalar> tip = chains_.table.reach(point_B, linear_.of(point_B));
    const Vector3<Scalar> arm = chains_.head.reach(point_B, tool.nose_to_tip_mm);
    shift_.inverse(ToolVector{}, point_B, axes_M);  // rotary axes; the linear ones follow the tip
    linear_.set<Scalar>(tip + (chains_.centre - arm), axes_M);
  }
  void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override;
  [[nodiscard]] unsigned head_axes() const RT_SAFE override { return chains_.head.axes(); }
  [[nodiscard]] unsigned leading_axes() const RT_SAFE override {
    return chains_.head.axes() | chains_.table.axes();
  }
  [[nodiscard]] DirectionSolution directions(const Vector3<double>& tool_B) const RT_SAFE override;
  [[nodiscard]] std::array<Vector3<double>, 3> spindle_axes(const AxisVector<double>& point_B) const
      RT_SAFE override;

 protected:
  struct Chains {
    RotaryChain head;          // its end is nose_to_tip
    RotaryChain table;         // its end is the workpiece point
    Vector3<double> centre{};  // position of X, Y, Z with the head's start at the table's start, mm
  };

  RotaryScheme(const SchemeConfig& config, const Chains& chains);

 private:
  AxisShift shift_;
  LinearAxes linear_;
  Chains chains_;
};

// A rotary axis as a scheme file names it, for messages: key, index in the channel, unit vector.
struct RotaryRole {
  std::string_view axis_key;
  int axis = -1;
  std::string_view vector_key;
  Vector3<double> vector{};
};

// "" or what is missing: X, Y, Z and both rotary axes must take part, these must differ and turn
// about unit vectors.
[[nodiscard]] std::string rotary_scheme_defect(const SchemeConfig& config, const RotaryRole& first,
                                               const RotaryRole& second);

// A zero of X, Y and Z in the order of the channel's axes.
[[nodiscard]] AxisVector<double> linear_zero(const SchemeConfig& config,
                                             const Vector3<double>& zero);

}  // namespace stanok::kinematics

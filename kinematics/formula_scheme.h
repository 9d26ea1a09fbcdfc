// Base of the schemes that write their formula once, as a template over the scalar.
//
//   class Wedge final : public FormulaScheme<Wedge> {
//    public:
//     explicit Wedge(const SchemeConfig& config) : FormulaScheme(config) {}
//     template <class Scalar>
//     void to_axes(PointMode mode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
//                  AxisVector<Scalar>& axes_M) const RT_SAFE;
//     void forward(...) const RT_SAFE override;
//   };
//
// Preparation and cycle ask with a double for the position alone, with a Jet (jet.h) for its
// derivatives besides. The formula is the same for both, so the values are, too, to the last bit.
// `axes_M` may be `point_B` itself.
#pragma once

#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

template <class Type>
class FormulaScheme : public Scheme {
 public:
  void inverse(PointMode mode, const ToolVector& tool, const AxisVector<Jet>& point_B,
               AxisVector<Jet>& axes_M) const RT_SAFE final {
    formula().to_axes(mode, tool, point_B, axes_M);
  }
  void inverse(PointMode mode, const ToolVector& tool, const AxisVector<double>& point_B,
               AxisVector<double>& axes_M) const RT_SAFE final {
    formula().to_axes(mode, tool, point_B, axes_M);
  }

 private:
  friend Type;
  explicit FormulaScheme(const SchemeConfig& config) : Scheme(config) {}

  [[nodiscard]] const Type& formula() const RT_SAFE { return static_cast<const Type&>(*this); }
};

}  // namespace stanok::kinematics

// Head-head scheme: see head_head.h for the formulas.
#include "kinematics/head_head.h"

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

// Origin of the base as a position of the outer pivot less the upright arm: c of head_head.h.
Vector3<double> base_of(const SchemeConfig& config, const HeadHead::Geometry& geometry) {
  return geometry.pivot_to_pivot + geometry.pivot_to_spindle +
         LinearAxes(config.linear).of(config.zero);
}

}  // namespace

std::vector<SchemeKey> HeadHead::Geometry::keys() {
  using enum KeyPresence;
  return {
      {"outer_axis", AxisName{outer_axis}, "rotary axis nearest to the slides", required},
      {"outer_vector", Direction{outer_vector}, "direction of outer_axis", required},
      {"inner_axis", AxisName{inner_axis}, "rotary axis nearest to the spindle", required},
      {"inner_vector", Direction{inner_vector}, "direction of inner_axis, outer axis at 0",
       required},
      {"pivot_to_pivot", Place{pivot_to_pivot},
       "from the pivot of outer_axis to that of inner_axis, head upright"},
      {"pivot_to_spindle", Place{pivot_to_spindle},
       "from the inner pivot to the spindle nose, head upright", required},
  };
}

HeadHead::HeadHead(const SchemeConfig& config)
    : HeadHead(config, std::get<Geometry>(config.geometry)) {}

HeadHead::HeadHead(const SchemeConfig& config, const Geometry& geometry)
    : RotaryScheme(
          config,
          {.head = {{geometry.outer_axis, geometry.outer_vector, geometry.pivot_to_pivot},
                    {geometry.inner_axis, geometry.inner_vector, geometry.pivot_to_spindle}},
           .table = {},
           .centre = base_of(config, geometry)}) {}

std::string HeadHead::defect(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  return rotary_scheme_defect(
      config, {"outer_axis", geometry.outer_axis, "outer_vector", geometry.outer_vector},
      {"inner_axis", geometry.inner_axis, "inner_vector", geometry.inner_vector});
}

}  // namespace stanok::kinematics

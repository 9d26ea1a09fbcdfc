// Head-head scheme: see head_head.h for the formulas.
#include "kinematics/head_head.h"

namespace stanok::kinematics {
namespace {

// Origin of the base as a position of the outer pivot less the upright arm: c of head_head.h.
Vector<double> base_of(const SchemeConfig& config) {
  Vector<double> base = sum(config.pivot_to_pivot, config.pivot_to_spindle);
  for (std::size_t k = 0; k < 3; ++k) {
    base[k] += config.zero[static_cast<std::size_t>(config.linear[k])];
  }
  return base;
}

}  // namespace

HeadHead::HeadHead(const SchemeConfig& config)
    : RotaryScheme(config,
                   {.head = {{config.outer_axis, config.outer_vector, config.pivot_to_pivot},
                             {config.inner_axis, config.inner_vector, config.pivot_to_spindle}},
                    .table = {},
                    .centre = base_of(config)}) {}

std::string head_head_defect(const SchemeConfig& config) {
  return rotary_scheme_defect(
      config, {"outer_axis", config.outer_axis, "outer_vector", config.outer_vector},
      {"inner_axis", config.inner_axis, "inner_vector", config.inner_vector});
}

}  // namespace stanok::kinematics

// The cycle and the increment of the machines that tests make up: the usual ones of
// config/machines.
#pragma once

namespace stanok::testing {

inline constexpr double cycle_s = 0.001;
inline constexpr double increment_mm = 0.001;

}  // namespace stanok::testing

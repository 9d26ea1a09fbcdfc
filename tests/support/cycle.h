// The cycle and the discrete of the machines that tests make up: the usual ones of config/machines.
#pragma once

namespace stanok::testing {

inline constexpr double cycle_s = 0.001;
inline constexpr double discrete_mm = 0.001;

}  // namespace stanok::testing

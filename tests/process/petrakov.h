// The worked example of Petrakov 2014: its control file (figure 9) to the letter, and its sheet.
#pragma once

#include <string_view>

#include "process/grinding/grinding_process.h"
#include "process/grinding/infeed_law.h"

namespace stanok::process::petrakov {

inline constexpr std::string_view figure_9 =
    "\n"
    "30.0 - радиус детали\n"
    "20.0 - ширина заготовки\n"
    "200.0 - радиус шлифовального круга\n"
    "25000000.0 - жесткость ТОС\n"
    "32.0 - приведенная масса\n"
    "50911.7 - коэффициент вязкого трения\n"
    "120.0 - частота вращения заготовки\n"
    "3.600 - Cp\n"
    "0.560 - α } данные силовой характеристики\n"
    "0.010\n"
    "0.090\n"
    "0.050 } данные граничного алгоритма\n"
    "11 - количество точек переключения\n"
    "0.3000 0.0400\n"
    "0.2602 0.0400\n"
    "0.2602 0.0294\n"
    "0.0893 0.0294\n"
    "0.0893 0.0233\n"
    "0.0700 0.0233\n"
    "0.0700 0.0177\n"
    "0.0500 0.0177\n"
    "0.0500 0.0097\n"
    "0.0200 0.0097\n"
    "0.0200 0.0040\n"
    "-0.0048 0.0040 } данные УП\n"
    "    \n";

inline GrindingProcess sheet() {
  return {.part_radius_mm = 30.0,
          .width_mm = 20.0,
          .wheel_radius_mm = 200.0,
          .stiffness_n_per_m = 25e6,
          .mass_kg = 32.0,
          .damping_n_s_per_m = 50911.7,
          .part_speed_rpm = 120.0,
          .force_factor = 3.6,
          .force_exponent = 0.56,
          .deflection_max_mm = 0.010,
          .critical_allowance_mm = 0.090,
          .removal_end_mm2_per_rad = 0.050};
}

inline InfeedLaw table() {
  return {{0.3000, 0.0400}, {0.2602, 0.0400}, {0.2602, 0.0294}, {0.0893, 0.0294},
          {0.0893, 0.0233}, {0.0700, 0.0233}, {0.0700, 0.0177}, {0.0500, 0.0177},
          {0.0500, 0.0097}, {0.0200, 0.0097}, {0.0200, 0.0040}, {-0.0048, 0.0040}};
}

}  // namespace stanok::process::petrakov

#include "process/grinding/grinding_process.h"

#include <array>
#include <cmath>
#include <numbers>

#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

using P = GrindingProcess;

// The ranges hold everything from a needle to a mill roll; beyond them a unit was mistaken.
constexpr std::array quantities{
    ProcessQuantity{"part_radius", &P::part_radius_mm, "mm", 0.5, 2000.0,
                    "radius of the finished part", "m", 1000.0},
    ProcessQuantity{"width", &P::width_mm, "mm", 0.5, 1000.0, "width of the ground surface", "m",
                    1000.0},
    ProcessQuantity{"wheel_radius", &P::wheel_radius_mm, "mm", 1.0, 1000.0,
                    "radius of the grinding wheel", "m", 1000.0},
    ProcessQuantity{"stiffness", &P::stiffness_n_per_m, "N/m", 1e6, 1e10,
                    "stiffness of machine, wheel and part in the direction of infeed", "N/mm",
                    1000.0},
    ProcessQuantity{"mass", &P::mass_kg, "kg", 0.1, 5000.0, "moving mass, reduced to the wheel",
                    "t", 1000.0},
    ProcessQuantity{"damping", &P::damping_n_s_per_m, "N s/m", 10.0, 1e8, "viscous friction",
                    "N s/mm", 1000.0},
    ProcessQuantity{"part_speed", &P::part_speed_rpm, "rev/min", 1.0, 3000.0,
                    "speed of the part spindle", "rev/s", 60.0},
    ProcessQuantity{"force_factor", &P::force_factor, "N/mm", 0.01, 1000.0,
                    "C_p of the force law P = C_p B (Q V)^alpha"},
    ProcessQuantity{"force_exponent", &P::force_exponent, "", 0.1, 1.0, "alpha of the force law"},
    ProcessQuantity{"deflection_max", &P::deflection_max_mm, "mm", 0.0001, 0.5,
                    "permitted deflection of the elastic system", "um", 0.001},
    ProcessQuantity{"critical_allowance", &P::critical_allowance_mm, "mm", 0.001, 5.0,
                    "allowance below which the surface layer can burn", "um", 0.001},
    ProcessQuantity{"removal_end", &P::removal_end_mm2_per_rad, "mm2/rad", 1e-5, 100.0,
                    "permitted removal at the end of the cycle"},
};

constexpr double plunge_in_revolutions = 4.0;

bool is_within(const ProcessQuantity& quantity, double value) {
  return value >= quantity.min && value <= quantity.max;
}

std::string hint(const ProcessQuantity& quantity, double value) {
  const double meant = value * quantity.mistaken_factor;
  if (quantity.mistaken_unit.empty() || !is_within(quantity, meant)) return "";
  return "; " + number_text(value) + " " + std::string(quantity.mistaken_unit) + " would be " +
         number_text(meant) + " " + std::string(quantity.unit);
}

}  // namespace

double revolution_s(const GrindingProcess& process) {
  return 60.0 / process.part_speed_rpm;
}

double part_surface_speed_m_per_min(const GrindingProcess& process) {
  return 2.0 * std::numbers::pi * process.part_radius_mm * process.part_speed_rpm / 1000.0;
}

double removal_radius_mm(const GrindingProcess& process) {
  const double R = process.part_radius_mm;
  const double R_w = process.wheel_radius_mm;
  return process.removal == RemovalForm::exact ? R : R * R_w / (R + R_w);
}

double steady_feed_mm_per_s(const GrindingProcess& process, double removal_mm2_per_rad) {
  return removal_mm2_per_rad / (removal_radius_mm(process) * revolution_s(process));
}

double plunge_in_s(const GrindingProcess& process) {
  return plunge_in_revolutions * revolution_s(process);
}

double damping_ratio(const GrindingProcess& process) {
  return process.damping_n_s_per_m / (2.0 * std::sqrt(process.stiffness_n_per_m * process.mass_kg));
}

std::span<const ProcessQuantity> process_quantities() {
  return quantities;
}

std::string range_text(const ProcessQuantity& quantity) {
  const std::string unit = quantity.unit.empty() ? "" : " " + std::string(quantity.unit);
  return number_text(quantity.min) + " to " + number_text(quantity.max) + unit;
}

std::vector<ProcessFault> range_faults(const GrindingProcess& process) {
  std::vector<ProcessFault> faults;
  for (const ProcessQuantity& quantity : quantities) {
    const double value = process.*quantity.value;
    if (is_within(quantity, value)) continue;
    faults.push_back({quantity.key, std::string(quantity.key) + " is " + number_text(value) +
                                        "; it must be " + range_text(quantity) + " (" +
                                        std::string(quantity.meaning) + ")" +
                                        hint(quantity, value)});
  }
  return faults;
}

}  // namespace stanok::process

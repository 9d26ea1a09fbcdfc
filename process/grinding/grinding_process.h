// The data of a plunge cylindrical grinding operation: part, wheel, elastic system, force law,
// limits.
//
// Fields are in the units of the technologist's sheet and of the control file: mm, rev/min, and SI
// for the elastic system (N/m, kg, N s/m). Everything that is computed from them is in mm, s, N.
// Source: Yu. V. Petrakov, Programming of plunge cylindrical grinding on CNC machines (2014), whose
// equations (3) to (7) are lost in print; docs/programmer/grinding.md derives them again.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::process {

// How the layer that is taken becomes the analogue Q of the rate of removal, mm2/rad.
enum class RemovalForm {
  triangle,  // Q = a R R_w / (R + R_w): the paper's triangle between the two contact lines
  exact,     // Q = a R: the area that a layer a has per radian of the part
};

// A point of the burn line: what may be removed with that much allowance left.
struct BurnPoint {
  double allowance_mm = 0.0;
  double removal_mm2_per_rad = 0.0;

  bool operator==(const BurnPoint&) const = default;
};

struct GrindingProcess {
  double part_radius_mm = 0.0;           // R, of the finished part
  double width_mm = 0.0;                 // B, of the ground surface
  double wheel_radius_mm = 0.0;          // R_w
  double stiffness_n_per_m = 0.0;        // C, of the elastic system in the direction of infeed
  double mass_kg = 0.0;                  // m, reduced to the wheel
  double damping_n_s_per_m = 0.0;        // b, viscous
  double part_speed_rpm = 0.0;           // n
  double force_factor = 0.0;             // C_p, N/mm at Q V = 1
  double force_exponent = 0.0;           // alpha
  double deflection_max_mm = 0.0;        // delta_allow, of the elastic system during the cycle
  double critical_allowance_mm = 0.0;    // H_crit, below which the layer can burn
  double removal_end_mm2_per_rad = 0.0;  // Q_end, permitted at the end of the cycle
  RemovalForm removal = RemovalForm::triangle;
  // Between 0, where Q_end is permitted, and H_crit, where Q_max is, both ascending; empty: the
  // burn line is straight.
  std::vector<BurnPoint> burn_curve{};

  bool operator==(const GrindingProcess&) const = default;
};

// tau: one revolution of the part, s.
[[nodiscard]] double revolution_s(const GrindingProcess& process);
// Surface speed of the part, m/min.
[[nodiscard]] double part_surface_speed_m_per_min(const GrindingProcess& process);
// Q of a layer of 1 mm: the R_eq of the triangle, or R.
[[nodiscard]] double removal_radius_mm(const GrindingProcess& process);
// Infeed that keeps up the removal Q in steady state, one layer a revolution: Q / (R_eq tau), mm/s.
[[nodiscard]] double steady_feed_mm_per_s(const GrindingProcess& process,
                                          double removal_mm2_per_rad);
// The time behind the touch in which deflection and removal build up, s: neither error nor fault of
// an infeed law. Four revolutions: what is missing of a step shrinks by k / (C + k) in each, to
// about 1 % for a cut of half the stiffness of the system.
[[nodiscard]] double plunge_in_s(const GrindingProcess& process);
// zeta = b / (2 sqrt(C m)).
[[nodiscard]] double damping_ratio(const GrindingProcess& process);

// One number of the sheet: what it is called, its unit and the range outside of which it is a slip.
struct ProcessQuantity {
  std::string_view key;  // of the process file
  double GrindingProcess::* value;
  std::string_view unit;
  double min;
  double max;
  std::string_view meaning;
  // A unit it is often given in by mistake: value x factor is right; "" for none.
  std::string_view mistaken_unit{};
  double mistaken_factor = 0.0;
};

// The same for what is no part of the sheet: allowance per side, and feeds.
inline constexpr double allowance_max_mm = 10.0;
inline constexpr double feed_max_mm_per_s = 1.0;

// In the order of the control file.
[[nodiscard]] std::span<const ProcessQuantity> process_quantities();

// What is wrong with a number of the sheet.
struct ProcessFault {
  std::string_view key;
  std::string text;  // "stiffness is 25000; it must be 1000000 to 10000000000 N/m (...)"
};

// "1000000 to 10000000000 N/m".
[[nodiscard]] std::string range_text(const ProcessQuantity& quantity);

// Numbers outside their ranges, each with a hint where another unit explains it. Nothing else is
// checked: see `boundary_faults` of boundary.h for what two numbers say together.
[[nodiscard]] std::vector<ProcessFault> range_faults(const GrindingProcess& process);

}  // namespace stanok::process

#include "process/grinding/boundary.h"

#include <algorithm>
#include <cmath>

#include "process/grinding/force_law.h"
#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr int shown_decimals = 4;

// C delta, N: the force at the permitted deflection.
double force_max_n(const GrindingProcess& process) {
  return process.stiffness_n_per_m / 1000.0 * process.deflection_max_mm;
}

}  // namespace

Boundary::Boundary(const GrindingProcess& process)
    : removal_max_(ForceLaw(process).removal_mm2_per_rad(force_max_n(process))),
      removal_end_(process.removal_end_mm2_per_rad),
      critical_mm_(process.critical_allowance_mm) {}

double Boundary::burn_line(double allowance_mm) const {
  return removal_end_ + (removal_max_ - removal_end_) * std::max(allowance_mm, 0.0) / critical_mm_;
}

double Boundary::at(double allowance_mm) const {
  return std::min(removal_max_, burn_line(allowance_mm));
}

double overrun_max_mm(const GrindingProcess& process) {
  constexpr double layers = 4.0;  // two, and as much room again
  return process.deflection_max_mm +
         layers * process.removal_end_mm2_per_rad / removal_radius_mm(process);
}

double least_time_s(const GrindingProcess& process, double allowance_mm) {
  const Boundary boundary(process);
  const double critical_mm = std::min(process.critical_allowance_mm, allowance_mm);
  const double above = (allowance_mm - critical_mm) / boundary.removal_max();
  const double slope =
      (boundary.removal_max() - boundary.removal_end()) / process.critical_allowance_mm;
  const double below = std::log1p(slope * critical_mm / boundary.removal_end()) / slope;
  return removal_radius_mm(process) * revolution_s(process) * (above + below);
}

std::vector<ProcessFault> boundary_faults(const GrindingProcess& process, double allowance_mm) {
  std::vector<ProcessFault> faults;
  if (process.critical_allowance_mm > allowance_mm) {
    faults.push_back({"critical_allowance", "critical_allowance is " +
                                                number_text(process.critical_allowance_mm) +
                                                "; it must be at most the allowance, " +
                                                number_text(allowance_mm) + " mm"});
  }
  const double removal_max = Boundary(process).removal_max();
  if (process.removal_end_mm2_per_rad >= removal_max) {
    faults.push_back(
        {"removal_end", "removal_end is " + number_text(process.removal_end_mm2_per_rad) +
                            "; it must be below the removal at deflection_max, " +
                            rounded_text(removal_max, shown_decimals) +
                            " mm2/rad: check stiffness, deflection_max and the force law"});
  }
  const double layer_mm = removal_max / removal_radius_mm(process);
  if (layer_mm >= allowance_mm) {
    faults.push_back(
        {"deflection_max", "deflection_max is " + number_text(process.deflection_max_mm) +
                               "; it permits a layer of " + rounded_text(layer_mm, shown_decimals) +
                               " mm in a revolution, and the allowance is only " +
                               number_text(allowance_mm) +
                               " mm: check stiffness, deflection_max and the force law"});
  }
  return faults;
}

}  // namespace stanok::process

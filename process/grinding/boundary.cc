#include "process/grinding/boundary.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "process/grinding/force_law.h"
#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr int shown_decimals = 4;

// C delta, N: the force at the permitted deflection.
double force_max_n(const GrindingProcess& process) {
  return process.stiffness_n_per_m / 1000.0 * process.deflection_max_mm;
}

// The integral of dH / Q over a straight piece of the burn line, up to `allowance_mm`.
double piece_of_time(const BurnPoint& from, const BurnPoint& to, double allowance_mm) {
  const double length_mm =
      std::min(to.allowance_mm, allowance_mm) - std::min(from.allowance_mm, allowance_mm);
  const double slope =
      (to.removal_mm2_per_rad - from.removal_mm2_per_rad) / (to.allowance_mm - from.allowance_mm);
  if (slope == 0.0) return length_mm / from.removal_mm2_per_rad;
  return std::log1p(slope * length_mm / from.removal_mm2_per_rad) / slope;
}

// A curve that rises from Q_end to Q_max while the allowance rises to H_crit; "" or what is wrong.
std::string curve_fault(const GrindingProcess& process, double removal_max) {
  BurnPoint before{0.0, process.removal_end_mm2_per_rad};
  for (const BurnPoint& point : process.burn_curve) {
    const std::string name =
        "the point of the burn line at " + number_text(point.allowance_mm) + " mm ";
    if (point.allowance_mm <= before.allowance_mm)
      return name + "has to lie above the one before, " + number_text(before.allowance_mm) + " mm";
    if (point.allowance_mm >= process.critical_allowance_mm) {
      return name + "has to lie below critical_allowance, " +
             number_text(process.critical_allowance_mm) + " mm, where the line meets Q_max";
    }
    if (point.removal_mm2_per_rad < before.removal_mm2_per_rad) {
      return name + "permits less than the one before, " + number_text(before.removal_mm2_per_rad) +
             " mm2/rad: more allowance permits at least as much";
    }
    if (point.removal_mm2_per_rad > removal_max) {
      return name + "permits more than Q_max, " + rounded_text(removal_max, shown_decimals) +
             " mm2/rad: there the line ends at critical_allowance";
    }
    before = point;
  }
  return "";
}

}  // namespace

Boundary::Boundary(const GrindingProcess& process)
    : removal_max_(ForceLaw(process).removal_mm2_per_rad(force_max_n(process))),
      removal_end_(process.removal_end_mm2_per_rad) {
  corners_.push_back({0.0, removal_end_});
  for (const BurnPoint& point : process.burn_curve) corners_.push_back(point);
  corners_.push_back({process.critical_allowance_mm, removal_max_});
}

// Behind the last corner it goes on as before it.
double Boundary::burn_line(double allowance_mm) const {
  const double H = std::max(allowance_mm, 0.0);
  std::size_t k = 0;
  while (k + 2 < corners_.size() && H > corners_[k + 1].allowance_mm) ++k;
  const BurnPoint& from = corners_[k];
  const BurnPoint& to = corners_[k + 1];
  return from.removal_mm2_per_rad + (to.removal_mm2_per_rad - from.removal_mm2_per_rad) *
                                        (H - from.allowance_mm) /
                                        (to.allowance_mm - from.allowance_mm);
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
  double below = 0.0;
  const std::vector<BurnPoint>& corners = boundary.corners();
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    below += piece_of_time(corners[k], corners[k + 1], allowance_mm);
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
  if (std::string fault = curve_fault(process, removal_max); !fault.empty())
    faults.push_back({"burn", std::move(fault)});
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

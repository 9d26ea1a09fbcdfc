#include "jobs/cutting/found_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "jobs/cutting/keyed_text.h"

namespace stanok::jobs {
namespace {

using process::Estimate;
using process::TurningFit;

std::string process_key(const char* key, const Estimate& estimate) {
  return fmt::format("{} = {:.4f}  # {:.4f} to {:.4f}\n", key, estimate.value, estimate.low,
                     estimate.high);
}

std::string idle_key(const TurningFit& fit, double rev_per_min) {
  if (!fit.idle_square) return "";
  return fmt::format("idle_coulomb_part = {:.4f}  # at {:.0f} rev/min\n",
                     fit.coulomb_part(rev_per_min), rev_per_min);
}

Estimate times(double factor, const Estimate& estimate) {
  return {.value = factor * estimate.value,
          .low = factor * estimate.low,
          .high = factor * estimate.high};
}

}  // namespace

CutForces cut_forces(const process::MillingFit& fit, double efficiency) {
  return {.force_n_per_mm2 = times(efficiency, fit.force_n_per_mm2),
          .edge_n_per_mm = times(efficiency, fit.edge_n_per_mm)};
}

std::string with_figures(const std::string& cut_file, const CutForces& forces) {
  Estimate edge = forces.edge_n_per_mm;
  edge.value = std::max(edge.value, 0.0);
  return with_figures(cut_file, {{.key = "force", .estimate = forces.force_n_per_mm2, .digits = 1},
                                 {.key = "edge_force", .estimate = edge, .digits = 2}});
}

Estimate quotient(double known, const Estimate& found) {
  return {.value = known / found.value, .low = known / found.high, .high = known / found.low};
}

std::string process_section(const TurningFit& fit, double rev_per_min, double coefficient_n) {
  std::string text = "[process]\n";
  if (coefficient_n > 0.0) {
    Estimate efficiency = quotient(coefficient_n, fit.coefficient_n);
    efficiency.value = std::min(efficiency.value, 1.0);
    text += process_key("efficiency", efficiency);
  }
  return text + process_key("power_lag", fit.lag_s) + process_key("feed_exponent", fit.exponent) +
         idle_key(fit, rev_per_min);
}

std::string with_figures(const std::string& process_file, const process::GrindingFit& fit) {
  return with_figures(process_file,
                      {{.key = "stiffness", .estimate = fit.stiffness_n_per_m, .digits = 0},
                       {.key = "force_factor", .estimate = fit.force_factor, .digits = 4},
                       {.key = "force_exponent", .estimate = fit.force_exponent, .digits = 4}});
}

}  // namespace stanok::jobs

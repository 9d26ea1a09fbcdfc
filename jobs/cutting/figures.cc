#include "jobs/cutting/figures.h"

namespace stanok::jobs {
namespace {

Figure lag(const process::Estimate& lag_s, int digits) {
  return {"power_lag_s", "power_lag_ms", "lag of the sensor", "ms", 1e3, digits, lag_s};
}

void add_drive(Figures& figures, const process::DriveFit& fit) {
  figures.push_back(lag(fit.lag_s, 2));
  figures.push_back({"idle_linear_w_min", "idle_linear_w_min", "idle power, with n", "W min", 1.0,
                     5, fit.idle_linear});
  if (fit.idle_square) {
    figures.push_back({"idle_square_w_min2", "idle_square_w_min2", "idle power, with n^2",
                       "W min^2", 1.0, 8, *fit.idle_square});
  }
}

}  // namespace

Figures figures_of(const process::TurningFit& fit, double coefficient_n) {
  Figures figures{{"coefficient_over_efficiency_n", "coefficient_over_efficiency_n",
                   "C / efficiency", "N", 1.0, 1, fit.coefficient_n}};
  if (coefficient_n > 0.0) {
    figures.push_back({"efficiency", "efficiency", "efficiency", "", 1.0, 4,
                       quotient(coefficient_n, fit.coefficient_n)});
  }
  figures.push_back({"exponent", "exponent", "exponent y", "", 1.0, 4, fit.exponent});
  add_drive(figures, fit);
  return figures;
}

Figures figures_of(const process::MillingFit& fit, double efficiency) {
  const CutForces forces = cut_forces(fit, efficiency);
  Figures figures{
      {"force_n_per_mm2", "force_n_mm2", "force K_t", "N/mm2", 1.0, 1, forces.force_n_per_mm2},
      {"edge_force_n_per_mm", "edge_force_n_mm", "force of the edge K_te", "N/mm", 1.0, 2,
       forces.edge_n_per_mm}};
  add_drive(figures, fit);
  return figures;
}

Figures figures_of(const process::GrindingFit& fit) {
  return {{"stiffness_n_per_m", "stiffness_n_um", "stiffness C", "N/um", 1e-6, 3,
           fit.stiffness_n_per_m},
          {"force_factor", "force_factor", "force factor C_p", "N/mm", 1.0, 4, fit.force_factor},
          {"force_exponent", "force_exponent", "exponent alpha", "", 1.0, 4, fit.force_exponent},
          {"idle_w", "idle_w", "idle power", "W", 1.0, 1, fit.idle_w},
          lag(fit.lag_s, 1)};
}

}  // namespace stanok::jobs

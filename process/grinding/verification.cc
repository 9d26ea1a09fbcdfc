#include "process/grinding/verification.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "process/grinding/number_text.h"
#include "process/grinding/stability.h"

namespace stanok::process {
namespace {

constexpr std::array stiffness_factors{0.5, 1.5};
// Rounding of feeds and time steps; not a crossing of the boundary.
constexpr double ratio_noise = 1e-3;

// Peaks stand at kinks of the table, between two steps: they are looked for with finer ones.
constexpr int refinement = 5;

void raise(Peak& peak, double ratio, const PlungeSample& sample) {
  if (ratio > peak.ratio) peak = {ratio, sample.time_s, sample.x_mm};
}

void find_peaks(const GrindingProcess& process, const PlungeRun& run, Verification& verification) {
  const Boundary boundary(process);
  for (const PlungeSample& sample : run.samples) {
    const double Q = sample.removal_mm2_per_rad;
    const double H = sample.allowance_mm;
    raise(verification.boundary, Q / boundary.at(H), sample);
    raise(verification.burn, Q / boundary.burn_line(H), sample);
    if (sample.time_s <= plunge_in_s(process)) continue;
    raise(verification.boundary_settled, Q / boundary.at(H), sample);
    raise(verification.deflection, Q / boundary.removal_max(), sample);
  }
}

std::string place_text(const Peak& peak) {
  return "at X " + rounded_text(peak.x_mm, 4) + " mm, " + rounded_text(peak.time_s, 2) + " s";
}

std::string times_text(double ratio) {
  return rounded_text(ratio, 3) + " times";
}

void judge_burn(const Peak& burn, const VerificationLimits& limits, Findings& findings) {
  if (burn.ratio > 1.0 + limits.burn_margin) {
    findings.push_back({"E9103", "the part burns: removal " + times_text(burn.ratio) +
                                     " the burn line " + place_text(burn)});
  } else if (burn.ratio > 1.0 + ratio_noise) {
    findings.push_back({"W911", "the removal comes to " + times_text(burn.ratio) +
                                    " the burn line " + place_text(burn) + ", within the margin"});
  }
}

void judge_deflection(const Verification& verification, const VerificationLimits& limits,
                      Findings& findings) {
  const Peak& settled = verification.deflection;
  const Peak& all = verification.boundary;
  if (settled.ratio > 1.0 + limits.burn_margin) {
    findings.push_back({"E9104", "the system is bent too far: removal " +
                                     times_text(settled.ratio) + " Q_max " + place_text(settled)});
  }
  if (all.ratio > 1.0 + ratio_noise && all.ratio > verification.boundary_settled.ratio) {
    findings.push_back({"W910", "while plunging in the removal rises to " + times_text(all.ratio) +
                                    " the boundary " + place_text(all)});
  }
}

void judge_end(const Verification& verification, const VerificationLimits& limits,
               Findings& findings) {
  const PlungeRun& run = verification.run;
  if (run.residual_mm < -limits.undersize_max_mm) {
    findings.push_back(
        {"E9108", "the part is undersize: its highest place lies " +
                      rounded_text(-run.residual_mm * 1000.0, 2) + " um below size, " +
                      rounded_text(limits.undersize_max_mm * 1000.0, 2) + " um are permitted"});
  }
  if (run.residual_mm <= limits.residual_max_mm) return;
  findings.push_back(
      {"E9106", "the size is not reached: " + rounded_text(run.residual_mm * 1000.0, 2) +
                    " um are left at the end, after " + rounded_text(run.time_s, 2) + " s"});
}

void judge_stability(const GrindingProcess& process, const PlungeRun& run, Findings& findings) {
  constexpr double margin_safe = 1.3;
  const double margin = stability_margin(process);
  if (margin >= margin_safe) return;
  const std::string growth =
      "waves become " + times_text(wave_growth(process)) + " as high with each revolution";
  if (margin >= 1.0) {
    findings.push_back({"W913", "the cut is close to chatter: the stability margin is " +
                                    rounded_text(margin, 3) + "; " + growth});
    return;
  }
  if (run.contact_losses == 0) {
    findings.push_back({"E9109", "the cut is not stable: the stability margin is " +
                                     rounded_text(margin, 3) + "; " + growth});
    return;
  }
  findings.push_back({"E9105", "the cut chatters: the wheel leaves the part " +
                                   std::to_string(run.contact_losses) +
                                   " times; the system has only " + rounded_text(margin, 3) +
                                   " of the stiffness and damping that hold the thinnest layer; " +
                                   growth});
}

}  // namespace

std::optional<int> spark_out_needed(const GrindingProcess& process, const InfeedLaw& law,
                                    const PlungeOptions& simulation, double roundness_mm) {
  constexpr int revolutions_max = 40;
  PlungeOptions options = simulation;
  for (int revolutions = 1; revolutions <= revolutions_max; ++revolutions) {
    options.spark_out_revolutions = revolutions;
    if (simulate_plunge(process, law, options).out_of_roundness_mm() <= roundness_mm)
      return revolutions;
  }
  return std::nullopt;
}

namespace {

// Where no roundness is asked for, a step beyond the tolerance of the size is told all the same.
void judge_roundness(const GrindingProcess& process, const InfeedLaw& law,
                     const PlungeOptions& simulation, const VerificationLimits& limits,
                     Verification& verification) {
  constexpr double reserve = 1.05;
  const bool is_asked_for = limits.roundness_max_mm > 0.0;
  const double permitted_mm = is_asked_for
                                  ? limits.roundness_max_mm
                                  : reserve * (limits.residual_max_mm + limits.undersize_max_mm);
  const double step_mm = verification.run.out_of_roundness_mm();
  if (step_mm <= permitted_mm) return;
  const auto needed = spark_out_needed(process, law, simulation, permitted_mm);
  const std::string remedy =
      needed ? "it takes " + std::to_string(*needed) + " revolutions (" +
                   rounded_text(*needed * revolution_s(process), 2) + " s) of spark-out, not " +
                   number_text(simulation.spark_out_revolutions)
             : std::string("no spark-out removes that: take a lower last feed");
  verification.findings.push_back(
      {is_asked_for ? "E9110" : "W912",
       "the cycle ends " + rounded_text(step_mm * 1000.0, 2) + " um out of round, " +
           rounded_text(permitted_mm * 1000.0, 2) + " um are permitted: " + remedy});
}

SizeError size_error(const GrindingProcess& process, const InfeedLaw& law,
                     const PlungeOptions& simulation, double factor, double residual_mm) {
  GrindingProcess other = process;
  other.stiffness_n_per_m *= factor;
  PlungeOptions gauged = simulation;
  gauged.at_end = InfeedTravel::AtEnd::goes_on;
  return {factor, simulate_plunge(other, law, simulation).residual_mm - residual_mm,
          simulate_plunge(other, law, gauged).size_reached_s};
}

}  // namespace

Verification verify_cycle(const GrindingProcess& process, const InfeedLaw& law,
                          const PlungeOptions& simulation, const VerificationLimits& limits) {
  PlungeOptions options = simulation;
  options.at_end = InfeedTravel::AtEnd::stands;
  Verification verification;
  if (const double time_s = law_time_s(law); time_s > options.time_max_s) {
    verification.findings.push_back({"E9106", "the table takes " + rounded_text(time_s, 1) +
                                                  " s; that is more than " +
                                                  number_text(options.time_max_s) + " s"});
    return verification;
  }
  verification.run = simulate_plunge(process, law, options);
  PlungeOptions fine = options;
  fine.time_step_max_s /= refinement;
  find_peaks(process, simulate_plunge(process, law, fine), verification);
  judge_stability(process, verification.run, verification.findings);
  judge_burn(verification.burn, limits, verification.findings);
  judge_deflection(verification, limits, verification.findings);
  judge_end(verification, limits, verification.findings);
  judge_roundness(process, law, options, limits, verification);
  for (const double factor : stiffness_factors) {
    verification.size_errors.push_back(
        size_error(process, law, options, factor, verification.run.residual_mm));
  }
  return verification;
}

}  // namespace stanok::process

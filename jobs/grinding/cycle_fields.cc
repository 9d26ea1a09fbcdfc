// A cycle by its names, as `stanok grind --json` and Python give it.
#include <ranges>

#include "jobs/grinding/grind_cycle.h"
#include "process/grinding/boundary.h"
#include "process/grinding/stability.h"

namespace stanok::jobs {
namespace {

using process::Boundary;
using process::InfeedLaw;
using process::OptimalLaw;
using process::Verification;

FieldList law_rows(const InfeedLaw& law) {
  return field_list(
      law, [](const process::InfeedRow& row) { return FieldList{row.x_mm, row.feed_mm_per_s}; });
}

// The rows down to where the cycle ends: a law may go on behind it.
InfeedLaw law_down_to(const InfeedLaw& law, double end_mm) {
  InfeedLaw shown;
  for (const process::InfeedRow& row : law) {
    if (!shown.empty() && row.x_mm < end_mm) {
      const process::InfeedRow& last = shown.back();
      const double part = (last.x_mm - end_mm) / (last.x_mm - row.x_mm);
      if (last.x_mm > end_mm) {
        shown.push_back(
            {end_mm, last.feed_mm_per_s + part * (row.feed_mm_per_s - last.feed_mm_per_s)});
      }
      break;
    }
    shown.push_back(row);
  }
  return shown;
}

FieldList continuous_rows(const OptimalLaw& optimum) {
  if (optimum.run.samples.empty()) return law_rows(optimum.law);
  return law_rows(law_down_to(optimum.law, optimum.run.samples.back().x_mm));
}

// The corners of D(H), from the allowance down to 0.
FieldList boundary_corners(const process::DesignRequest& request) {
  const Boundary boundary(request.process);
  FieldList corners;
  corners.push_back(FieldList{request.allowance_mm, boundary.at(request.allowance_mm)});
  for (const process::BurnPoint& corner : std::views::reverse(boundary.corners()))
    corners.push_back(FieldList{corner.allowance_mm, boundary.at(corner.allowance_mm)});
  return corners;
}

FieldList iterations_of(const OptimalLaw& law) {
  return field_list(law.iterations, [](const process::Iteration& iteration) {
    return Fields{
        {"n", count_field(iteration.number)}, {"rms", iteration.rms}, {"worst", iteration.worst}};
  });
}

FieldList findings_list(const process::Findings& findings) {
  return field_list(findings, [](const process::Finding& finding) {
    return Fields{{"code", finding.code}, {"text", finding.text}};
  });
}

FieldValue peak_of(const process::Peak& peak) {
  return Fields{{"ratio", peak.ratio}, {"time_s", peak.time_s}, {"x_mm", peak.x_mm}};
}

FieldValue corner_fields(const process::Corner& corner) {
  const Verification& verification = corner.verification;
  return Fields{{"name", corner.name},
                {"stiffness", corner.process.stiffness_n_per_m},
                {"force_factor", corner.process.force_factor},
                {"allowance_mm", corner.allowance_mm},
                {"cycle_time_s", verification.run.time_s},
                {"q_over_burn_line", peak_of(verification.burn)},
                {"residual_mm", verification.run.residual_mm},
                {"out_of_roundness_mm", verification.run.out_of_roundness_mm()},
                {"ok", !process::has_errors(verification.findings)}};
}

FieldValue stiffness_fields(const process::SizeError& error) {
  return Fields{{"factor", error.factor},
                {"size_error_mm", error.error_mm},
                {"gauged_time_s", optional_field(error.gauged_time_s)}};
}

}  // namespace

Fields cycle_fields(const GrindCycle& cycle) {
  const auto& [request, design, corners] = cycle;
  const Verification& verification = design.verification;
  const process::PlungeRun& run = verification.run;
  return {{"ok", !process::has_errors(verification.findings)},
          {"q_max", Boundary(request.process).removal_max()},
          {"boundary", boundary_corners(request)},
          {"law", law_rows(design.law)},
          {"iterations", iterations_of(design.continuous)},
          {"cycle_time_s", run.time_s},
          {"size_reached_s", optional_field(run.size_reached_s)},
          {"lower_bound_s", design.least_time_s},
          {"q_over_d_max", verification.boundary.ratio},
          {"q_over_d", peak_of(verification.boundary)},
          {"q_over_d_settled", peak_of(verification.boundary_settled)},
          {"q_over_burn_line", peak_of(verification.burn)},
          {"spark_out_revolutions", design.spark_out_revolutions},
          {"spark_out_s", design.spark_out_revolutions * process::revolution_s(request.process)},
          {"residual_mm", run.residual_mm},
          {"residual_mean_mm", run.residual_mean_mm},
          {"out_of_roundness_mm", run.out_of_roundness_mm()},
          {"wear_mm", run.wear_mm},
          {"force_max_n", run.force_max_n},
          {"damping_ratio", process::damping_ratio(request.process)},
          {"stability_margin", process::stability_margin(request.process)},
          {"wave_growth", process::wave_growth(request.process)},
          {"compare", Fields{{"constant_safe_s", design.constant_safe_time_s},
                             {"three_step_s", optional_field(three_step_time_s(design))},
                             {"continuous_s", optional_field(continuous_time_s(design))}}},
          {"continuous_law", continuous_rows(design.continuous)},
          {"stiffness", field_list(verification.size_errors, stiffness_fields)},
          {"corners", field_list(corners, corner_fields)},
          {"findings", findings_list(verification.findings)}};
}

Fields refusal_fields(const process::Findings& findings) {
  return {{"ok", false}, {"findings", findings_list(findings)}};
}

Fields plunge_fields(const process::PlungeRun& run) {
  return {{"time_s", run.time_s},
          {"size_reached_s", optional_field(run.size_reached_s)},
          {"residual_mm", run.residual_mm},
          {"residual_min_mm", run.residual_min_mm},
          {"residual_mean_mm", run.residual_mean_mm},
          {"wear_mm", run.wear_mm},
          {"volume_mm2", run.volume_mm2},
          {"contact_losses", count_field(run.contact_losses)},
          {"force_max_n", run.force_max_n}};
}

}  // namespace stanok::jobs

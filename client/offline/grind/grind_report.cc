#include "client/offline/grind/grind_report.h"

#include <fmt/format.h>

#include <optional>
#include <ranges>

#include "base/enum_names.h"
#include "client/terminal/text_table.h"
#include "process/grinding/stability.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Boundary;
using process::InfeedLaw;
using process::Iteration;
using process::OptimalLaw;
using process::Verification;

constexpr double seconds_per_minute = 60.0;
constexpr double um_per_mm = 1000.0;

ordered_json rows_json(const InfeedLaw& law) {
  ordered_json rows = ordered_json::array();
  for (const process::InfeedRow& row : law) rows.push_back({row.x_mm, row.feed_mm_per_s});
  return rows;
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

ordered_json continuous_rows_json(const OptimalLaw& optimum) {
  if (optimum.run.samples.empty()) return rows_json(optimum.law);
  return rows_json(law_down_to(optimum.law, optimum.run.samples.back().x_mm));
}

// The corners of D(H), from the allowance down to 0.
ordered_json boundary_json(const process::DesignRequest& request) {
  const Boundary boundary(request.process);
  ordered_json points = ordered_json::array();
  points.push_back({request.allowance_mm, boundary.at(request.allowance_mm)});
  for (const process::BurnPoint& corner : std::views::reverse(boundary.corners()))
    points.push_back({corner.allowance_mm, boundary.at(corner.allowance_mm)});
  return points;
}

ordered_json iterations_json(const OptimalLaw& law) {
  ordered_json list = ordered_json::array();
  for (const Iteration& iteration : law.iterations) {
    list.push_back({{"n", iteration.number}, {"rms", iteration.rms}, {"worst", iteration.worst}});
  }
  return list;
}

ordered_json findings_json(const process::Findings& findings) {
  ordered_json list = ordered_json::array();
  for (const process::Finding& finding : findings) {
    list.push_back({{"code", finding.code}, {"text", finding.text}});
  }
  return list;
}

ordered_json peak_json(const process::Peak& peak) {
  return {{"ratio", peak.ratio}, {"time_s", peak.time_s}, {"x_mm", peak.x_mm}};
}

ordered_json optional_json(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

std::optional<double> continuous_time_s(const process::CycleDesign& design) {
  return design.continuous.run.size_reached_s;
}

std::optional<double> three_step_time_s(const process::CycleDesign& design) {
  if (design.three_step_time_s <= 0.0) return std::nullopt;
  return design.three_step_time_s;
}

constexpr auto settling_texts = enum_names<process::Settling>({
    {process::Settling::converged, "settled"},
    {process::Settling::grew, "ended as the error grew"},
    {process::Settling::ran_out, "ended with the last iteration"},
});

std::string process_text(const process::DesignRequest& request) {
  const process::GrindingProcess& process = request.process;
  const Boundary boundary(process);
  return fmt::format(
      "boundary    Q_max {:.4f}, Q_end {:.4f} mm2/rad, burn line from H_crit {:g} mm\n"
      "system      damping ratio {:.4f}, revolution {:g} s\n"
      "stability   margin {:.2f}; a wave is {:.3g} times as high after a revolution\n",
      boundary.removal_max(), boundary.removal_end(), process.critical_allowance_mm,
      process::damping_ratio(process), process::revolution_s(process),
      process::stability_margin(process), process::wave_growth(process));
}

std::string continuous_text(const OptimalLaw& law) {
  if (law.law.empty()) return "";
  return fmt::format(
      "optimum     {:.3f} s as a continuous law; {} iterations, {}: error rms {:.2f} %, largest "
      "{:.2f} %\n",
      law.run.time_s, law.iterations.size(), settling_texts[law.settling], 100.0 * law.best.rms,
      100.0 * law.best.worst);
}

std::string comparison_text(const process::CycleDesign& design) {
  TextTable table({"cycle", "s", "against this one"});
  const double time_s = design.verification.run.time_s;
  const auto add = [&](const char* name, const std::optional<double>& other_s) {
    if (!other_s) return;
    table.add_row(
        {name, fmt::format("{:.3f}", *other_s), fmt::format("{:.2f}", *other_s / time_s)});
  };
  add("this one", time_s);
  add("lower bound", design.least_time_s);
  add("continuous law", continuous_time_s(design));
  add("three steps 4:2:1", three_step_time_s(design));
  add("constant safe feed", design.constant_safe_time_s);
  return table.text(Terminal(Screen::none));
}

std::string spark_out_text(const GrindReport& report) {
  const double revolutions = report.design.spark_out_revolutions;
  if (revolutions <= 0.0) return "";
  return fmt::format(
      "spark-out   {:g} revolutions, {:.2f} s, behind the last X; {:.2f} um out of "
      "round are left\n",
      revolutions, revolutions * process::revolution_s(report.request.process),
      report.design.verification.run.out_of_roundness_mm() * um_per_mm);
}

std::string verification_text(const Verification& verification) {
  std::string text = fmt::format(
      "Q/D         at most {:.4f} at X {:.4f} mm, {:.4f} behind the plunge-in\n"
      "residual    {:.2f} um at most, {:.2f} um on the average, {:.2f} um out of round\n"
      "force       {:.1f} N at most\n",
      verification.boundary.ratio, verification.boundary.x_mm, verification.boundary_settled.ratio,
      verification.run.residual_mm * um_per_mm, verification.run.residual_mean_mm * um_per_mm,
      verification.run.out_of_roundness_mm() * um_per_mm, verification.run.force_max_n);
  for (const process::SizeError& error : verification.size_errors) {
    text += fmt::format("stiffness   x {:g}: radius {:+.2f} um", error.factor,
                        error.error_mm * um_per_mm);
    if (error.gauged_time_s) text += fmt::format("; {:.3f} s with a gauge", *error.gauged_time_s);
    text += "\n";
  }
  if (verification.run.wear_mm > 0.0) {
    text +=
        fmt::format("wear        {:.2f} um of the wheel\n", verification.run.wear_mm * um_per_mm);
  }
  return text;
}

ordered_json corners_json(const std::vector<process::Corner>& corners) {
  ordered_json list = ordered_json::array();
  for (const process::Corner& corner : corners) {
    const Verification& verification = corner.verification;
    list.push_back({{"name", corner.name},
                    {"stiffness", corner.process.stiffness_n_per_m},
                    {"force_factor", corner.process.force_factor},
                    {"allowance_mm", corner.allowance_mm},
                    {"cycle_time_s", verification.run.time_s},
                    {"q_over_burn_line", peak_json(verification.burn)},
                    {"residual_mm", verification.run.residual_mm},
                    {"out_of_roundness_mm", verification.run.out_of_roundness_mm()},
                    {"ok", !process::has_errors(verification.findings)}});
  }
  return list;
}

std::string corners_text(const std::vector<process::Corner>& corners) {
  if (corners.empty()) return "";
  TextTable table({"corner", "Q/L", "radius um", "round um", ""});
  for (const process::Corner& corner : corners) {
    const Verification& verification = corner.verification;
    table.add_row({corner.name, fmt::format("{:.3f}", verification.burn.ratio),
                   fmt::format("{:+.2f}", verification.run.residual_mm * um_per_mm),
                   fmt::format("{:.2f}", verification.run.out_of_roundness_mm() * um_per_mm),
                   process::has_errors(verification.findings) ? "failed" : "ok"});
  }
  return table.text(Terminal(Screen::none)) + "\n";
}

std::string law_text(const InfeedLaw& law) {
  TextTable table({"from X mm", "to X mm", "mm/s", "mm/min"});
  for (std::size_t k = 0; k + 1 < law.size(); ++k) {
    if (law[k].x_mm == law[k + 1].x_mm) continue;
    const double begin = law[k].feed_mm_per_s;
    const double end = law[k + 1].feed_mm_per_s;
    const bool is_constant = begin == end;
    const auto feed = [&](double unit) {
      return is_constant ? fmt::format("{:.5g}", begin * unit)
                         : fmt::format("{:.5g} to {:.5g}", begin * unit, end * unit);
    };
    table.add_row({fmt::format("{:.4f}", law[k].x_mm), fmt::format("{:.4f}", law[k + 1].x_mm),
                   feed(1.0), feed(seconds_per_minute)});
  }
  return table.text(Terminal(Screen::none));
}

}  // namespace

const std::vector<process::Corner> GrindReport::no_corners;

ordered_json to_json(const GrindReport& report) {
  const auto& [request, design, corners] = report;
  const Verification& verification = design.verification;
  ordered_json stiffness = ordered_json::array();
  for (const process::SizeError& error : verification.size_errors) {
    stiffness.push_back({{"factor", error.factor},
                         {"size_error_mm", error.error_mm},
                         {"gauged_time_s", optional_json(error.gauged_time_s)}});
  }
  return {{"ok", !process::has_errors(verification.findings)},
          {"q_max", Boundary(request.process).removal_max()},
          {"boundary", boundary_json(request)},
          {"law", rows_json(design.law)},
          {"iterations", iterations_json(design.continuous)},
          {"cycle_time_s", verification.run.time_s},
          {"size_reached_s", optional_json(verification.run.size_reached_s)},
          {"lower_bound_s", design.least_time_s},
          {"q_over_d_max", verification.boundary.ratio},
          {"q_over_d", peak_json(verification.boundary)},
          {"q_over_d_settled", peak_json(verification.boundary_settled)},
          {"q_over_burn_line", peak_json(verification.burn)},
          {"spark_out_revolutions", design.spark_out_revolutions},
          {"spark_out_s", design.spark_out_revolutions * process::revolution_s(request.process)},
          {"residual_mm", verification.run.residual_mm},
          {"residual_mean_mm", verification.run.residual_mean_mm},
          {"out_of_roundness_mm", verification.run.out_of_roundness_mm()},
          {"wear_mm", verification.run.wear_mm},
          {"force_max_n", verification.run.force_max_n},
          {"damping_ratio", process::damping_ratio(request.process)},
          {"stability_margin", process::stability_margin(request.process)},
          {"wave_growth", process::wave_growth(request.process)},
          {"compare",
           {{"constant_safe_s", design.constant_safe_time_s},
            {"three_step_s", optional_json(three_step_time_s(design))},
            {"continuous_s", optional_json(continuous_time_s(design))}}},
          {"continuous_law", continuous_rows_json(design.continuous)},
          {"stiffness", stiffness},
          {"corners", corners_json(corners)},
          {"findings", findings_json(verification.findings)}};
}

ordered_json refusal_json(const process::Findings& findings) {
  return {{"ok", false}, {"findings", findings_json(findings)}};
}

std::string to_text(const GrindReport& report, const Terminal& terminal) {
  const auto& [request, design, corners] = report;
  const bool is_good = !process::has_errors(design.verification.findings);
  return process_text(request) + continuous_text(design.continuous) + "\n" + law_text(design.law) +
         "\n" + spark_out_text(report) + verification_text(design.verification) + "\n" +
         corners_text(corners) + comparison_text(design) +
         (is_good ? terminal.coloured("ok", Colour::green)
                  : terminal.coloured("failed", Colour::red)) +
         "\n";
}

std::string to_text(const process::Finding& finding) {
  return std::string(finding.is_error() ? "error" : "warning") + "[" + finding.code +
         "]: " + finding.text + "\n";
}

}  // namespace stanok::client

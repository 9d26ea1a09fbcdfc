#include "client/offline/grind/grind_report.h"

#include <fmt/format.h>

#include <optional>

#include "base/enum_names.h"
#include "client/terminal/text_table.h"
#include "process/grinding/boundary.h"
#include "process/grinding/stability.h"

namespace stanok::client {
namespace {

using process::Boundary;
using process::InfeedLaw;
using process::OptimalLaw;
using process::Verification;

constexpr double seconds_per_minute = 60.0;
constexpr double um_per_mm = 1000.0;

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
  add("continuous law", jobs::continuous_time_s(design));
  add("three steps 4:2:1", jobs::three_step_time_s(design));
  add("constant safe feed", design.constant_safe_time_s);
  return table.text(Terminal(Screen::none));
}

std::string spark_out_text(const jobs::GrindCycle& cycle) {
  const double revolutions = cycle.design.spark_out_revolutions;
  if (revolutions <= 0.0) return "";
  return fmt::format(
      "spark-out   {:g} revolutions, {:.2f} s, behind the last X; {:.2f} um out of "
      "round are left\n",
      revolutions, revolutions * process::revolution_s(cycle.request.process),
      cycle.design.verification.run.out_of_roundness_mm() * um_per_mm);
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

std::string to_text(const jobs::GrindCycle& cycle, const Terminal& terminal) {
  const auto& [request, design, corners] = cycle;
  const bool is_good = !process::has_errors(design.verification.findings);
  return process_text(request) + continuous_text(design.continuous) + "\n" + law_text(design.law) +
         "\n" + spark_out_text(cycle) + verification_text(design.verification) + "\n" +
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

#include "process/grinding/cycle_design.h"

#include <algorithm>
#include <cmath>

#include "process/grinding/baselines.h"
#include "process/grinding/number_text.h"
#include "process/grinding/stability.h"

namespace stanok::process {
namespace {

constexpr double feed_min_part = 0.1;  // of the steady feed at Q_end
constexpr double feed_max_part = 1.3;  // of the steady feed at Q_max
constexpr double feedback_max = 1.0;
// A process with less than this margin is looked at before anything is designed for it.
constexpr double margin_trusted = 1.0;
constexpr double trial_revolutions = 40.0;

FeedRange feeds_of(const DesignRequest& request) {
  const FeedRange usual = usual_feeds(request.process);
  const FeedRange& given = request.feeds;
  return {given.min_mm_per_s > 0.0 ? given.min_mm_per_s : usual.min_mm_per_s,
          given.max_mm_per_s > 0.0 ? given.max_mm_per_s : usual.max_mm_per_s};
}

void check_switch_points(const DesignRequest& request, Findings& findings) {
  double before_mm = request.allowance_mm;
  for (const double x_mm : request.staircase.at_mm) {
    if (std::isfinite(x_mm) && x_mm < before_mm && x_mm > -overrun_max_mm(request.process)) {
      before_mm = x_mm;
      continue;
    }
    findings.push_back({"E9102", "switch point " + number_text(x_mm) +
                                     " mm; switch points fall from below the allowance, " +
                                     number_text(request.allowance_mm) + " mm, one by one"});
    return;
  }
}

void check_feeds(const DesignRequest& request, Findings& findings) {
  const FeedRange feeds = feeds_of(request);
  if (feeds.min_mm_per_s < feeds.max_mm_per_s) return;
  findings.push_back({"E9102", "feed_min is " + number_text(feeds.min_mm_per_s) +
                                   " mm/s; it must be below the greatest feed, " +
                                   number_text(feeds.max_mm_per_s) + " mm/s"});
}

void check_gain(const OptimiserOptions& options, Findings& findings) {
  if (!options.stops_when_growing || options.feedback < feedback_max) return;
  findings.push_back({"E9107", "k_oc is " + number_text(options.feedback) +
                                   "; from 1 on every correction overshoots and the error of "
                                   "fast changes grows: take 0.1 to 0.9 (0.5 is usual)"});
}

void check_time(const DesignRequest& request, Findings& findings) {
  const double time_s = least_time_s(request.process, request.allowance_mm);
  if (time_s <= request.simulation.time_max_s) return;
  findings.push_back({"E9106", "the allowance takes at least " + rounded_text(time_s, 1) +
                                   " s under the boundary; time_max is " +
                                   number_text(request.simulation.time_max_s) +
                                   " s: check stiffness, deflection_max and the force law"});
}

// A process near its limit of stability is tried at the feed of the end, where the cut is stiffest.
void check_stability(const DesignRequest& request, Findings& findings) {
  const GrindingProcess& process = request.process;
  const double margin = stability_margin(process);
  if (margin >= margin_trusted) return;
  const double feed = steady_feed_mm_per_s(process, process.removal_end_mm2_per_rad);
  const double travel_mm = trial_revolutions * revolution_s(process) * feed;
  PlungeOptions options = request.simulation;
  options.at_end = InfeedTravel::AtEnd::stands;
  const PlungeRun run = simulate_plunge(process, constant_law(travel_mm, 0.0, feed), options);
  if (run.contact_losses == 0) return;
  findings.push_back({"E9105", "the cut chatters at the feed of the end: stiffness " +
                                   number_text(process.stiffness_n_per_m) +
                                   " N/m with damping ratio " +
                                   rounded_text(damping_ratio(process), 4) + " is " +
                                   rounded_text(margin, 3) + " of what holds the thinnest layer"});
}

// The table again for the spark-out that its roundness needs: what the spring gives back is not
// fed. Where none is long enough the table stays, and its verification says so.
CycleDesign with_spark_out(const DesignRequest& request, InfeedLaw law) {
  DesignRequest found = request;
  found.spark_out = SparkOut::given;
  PlungeOptions simulation = request.simulation;
  simulation.at_end = InfeedTravel::AtEnd::stands;
  simulation.spark_out_revolutions = 0.0;
  const double roundness_mm = request.limits.roundness_max_mm;
  const bool is_round =
      simulate_plunge(request.process, law, simulation).out_of_roundness_mm() <= roundness_mm;
  const auto needed = is_round ? std::optional(0)
                               : spark_out_needed(request.process, law, simulation, roundness_mm);
  found.simulation.spark_out_revolutions = needed.value_or(0);
  if (needed.value_or(0) == 0) return assessed_cycle(found, std::move(law));
  Staircase staircase = design_staircase(found.process, found.allowance_mm, feeds_of(found),
                                         found.staircase, found.simulation);
  return assessed_cycle(found, std::move(staircase.law));
}

bool chatters(const Verification& verification) {
  return std::ranges::any_of(verification.findings,
                             [](const Finding& finding) { return finding.code == "E9105"; });
}

}  // namespace

FeedRange usual_feeds(const GrindingProcess& process) {
  const Boundary boundary(process);
  return {feed_min_part * steady_feed_mm_per_s(process, boundary.removal_end()),
          std::min(feed_max_part * steady_feed_mm_per_s(process, boundary.removal_max()),
                   feed_max_mm_per_s)};
}

Findings request_findings(const DesignRequest& request) {
  Findings findings;
  for (const ProcessFault& fault : range_faults(request.process)) {
    findings.push_back({"E9102", fault.text});
  }
  if (!findings.empty()) return findings;
  for (const ProcessFault& fault : boundary_faults(request.process, request.allowance_mm)) {
    findings.push_back({"E9102", fault.text});
  }
  check_feeds(request, findings);
  check_switch_points(request, findings);
  check_gain(request.optimiser, findings);
  if (!has_errors(findings)) check_time(request, findings);
  return findings;
}

CycleDesign assessed_cycle(const DesignRequest& request, InfeedLaw law) {
  const GrindingProcess& process = request.process;
  const double allowance_mm = request.allowance_mm;
  CycleDesign design;
  design.law = std::move(law);
  design.spark_out_revolutions = request.simulation.spark_out_revolutions;
  design.verification = verify_cycle(process, design.law, request.simulation, request.limits);
  design.least_time_s = least_time_s(process, allowance_mm);
  design.constant_safe_time_s = constant_safe_time_s(process, allowance_mm);
  if (request.comparison == Comparison::none || chatters(design.verification)) return design;
  design.continuous =
      optimal_law(process, allowance_mm, feeds_of(request), request.optimiser, request.simulation);
  design.three_step_time_s = three_step_time_s(process, allowance_mm, request.simulation);
  return design;
}

Expected<CycleDesign, Findings> design_cycle(const DesignRequest& request) {
  Findings findings = request_findings(request);
  if (!has_errors(findings)) check_stability(request, findings);
  if (has_errors(findings)) return Unexpected<Findings>(std::move(findings));
  Staircase staircase = design_staircase(request.process, request.allowance_mm, feeds_of(request),
                                         request.staircase, request.simulation);
  if (!staircase.is_reachable) {
    return Unexpected<Findings>({{"E9106", "the size is not reached within time_max, " +
                                               number_text(request.simulation.time_max_s) + " s"}});
  }
  if (request.spark_out == SparkOut::given)
    return assessed_cycle(request, std::move(staircase.law));
  return with_spark_out(request, std::move(staircase.law));
}

}  // namespace stanok::process

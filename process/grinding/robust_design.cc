#include "process/grinding/robust_design.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr int lowerings_max = 12;
constexpr int robust_spark_out_max = 40;  // revolutions

std::vector<double> sides(double spread) {
  return spread > 0.0 ? std::vector{-spread, spread} : std::vector{0.0};
}

std::vector<Corner> corners_of(const DesignRequest& request, const Spread& spread) {
  std::vector<Corner> corners;
  for (const double stiffness : sides(spread.stiffness)) {
    for (const double force : sides(spread.force_factor)) {
      for (const double allowance_mm : sides(spread.allowance_mm)) {
        Corner corner{.process = request.process,
                      .allowance_mm = request.allowance_mm + allowance_mm,
                      .name = "stiffness x " + rounded_text(1.0 + stiffness, 2) + ", force x " +
                              rounded_text(1.0 + force, 2) + ", allowance " +
                              rounded_text(request.allowance_mm + allowance_mm, 4) + " mm",
                      .verification = {}};
        corner.process.stiffness_n_per_m *= 1.0 + stiffness;
        corner.process.force_factor *= 1.0 + force;
        corners.push_back(std::move(corner));
      }
    }
  }
  return corners;
}

// The corner that permits the least removal: soft, and with a dull wheel.
const Corner& tightest(const std::vector<Corner>& corners) {
  return *std::ranges::min_element(
      corners, {}, [](const Corner& corner) { return Boundary(corner.process).removal_max(); });
}

// How far the worst corner is above what is permitted, behind its plunge-in.
double worst_use(const std::vector<Corner>& corners, const InfeedLaw& law,
                 const PlungeOptions& simulation, double margin) {
  double worst = 0.0;
  for (const Corner& corner : corners) {
    const Boundary boundary(corner.process);
    const PlungeRun run =
        simulate_plunge(corner.process, law_from(law, corner.allowance_mm), simulation);
    const double settled_s = plunge_in_s(corner.process);
    for (const PlungeSample& sample : run.samples) {
      const double Q = sample.removal_mm2_per_rad;
      worst = std::max(worst, Q / (boundary.burn_line(sample.allowance_mm) * (1.0 + margin)));
      if (sample.time_s > settled_s)
        worst = std::max(worst, Q / (boundary.removal_max() * (1.0 + margin)));
    }
  }
  return worst;
}

InfeedLaw with_feeds(InfeedLaw law, double factor) {
  for (InfeedRow& row : law) row.feed_mm_per_s *= factor;
  return law;
}

// The greatest and the least size of all corners.
struct Sizes {
  double least_mm = 0.0;
  double most_mm = 0.0;
  double step_mm = 0.0;  // out of round, at most
  [[nodiscard]] double width_mm() const { return most_mm - least_mm; }
};

Sizes sizes_of(const std::vector<Corner>& corners, const InfeedLaw& law,
               const PlungeOptions& simulation) {
  Sizes sizes{.least_mm = 1e9, .most_mm = -1e9};
  for (const Corner& corner : corners) {
    const PlungeRun run =
        simulate_plunge(corner.process, law_from(law, corner.allowance_mm), simulation);
    sizes.least_mm = std::min(sizes.least_mm, run.residual_mm);
    sizes.most_mm = std::max(sizes.most_mm, run.residual_mm);
    sizes.step_mm = std::max(sizes.step_mm, run.out_of_roundness_mm());
  }
  return sizes;
}

// Moves the last X so that the sizes lie about the middle of the band; the removal is steady there.
void centre(const std::vector<Corner>& corners, const VerificationLimits& limits,
            const PlungeOptions& simulation, double quantum_mm, InfeedLaw& law) {
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    const Sizes sizes = sizes_of(corners, law, simulation);
    const double middle_mm = 0.5 * (limits.residual_max_mm - limits.undersize_max_mm);
    const double off_mm = 0.5 * (sizes.least_mm + sizes.most_mm) - middle_mm;
    const double quanta = std::round(off_mm / quantum_mm);
    if (quanta == 0.0) return;
    InfeedRow& last = law.back();
    last.x_mm = std::min(last.x_mm - quanta * quantum_mm, law[law.size() - 2].x_mm);
  }
}

void judge_corners(const DesignRequest& request, const InfeedLaw& law, std::vector<Corner>& corners,
                   Findings& findings) {
  for (Corner& corner : corners) {
    corner.verification = verify_cycle(corner.process, law_from(law, corner.allowance_mm),
                                       request.simulation, request.limits);
    corner.verification.run.samples.clear();
    for (const Finding& finding : corner.verification.findings)
      if (finding.is_error()) findings.push_back({finding.code, corner.name + ": " + finding.text});
  }
}

}  // namespace

InfeedLaw law_from(const InfeedLaw& law, double allowance_mm) {
  InfeedLaw rest = law;
  if (allowance_mm >= law.front().x_mm) {
    rest.front().x_mm = allowance_mm;
    return rest;
  }
  std::size_t first = 0;
  while (first + 2 < rest.size() && rest[first + 1].x_mm >= allowance_mm) ++first;
  rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(first));
  const InfeedRow& above = rest[0];
  const InfeedRow& below = rest[1];
  const double part =
      above.x_mm > below.x_mm ? (above.x_mm - allowance_mm) / (above.x_mm - below.x_mm) : 0.0;
  rest.front() = {allowance_mm,
                  above.feed_mm_per_s + part * (below.feed_mm_per_s - above.feed_mm_per_s)};
  return rest;
}

Expected<RobustDesign, Findings> design_robust(const DesignRequest& request, const Spread& spread) {
  std::vector<Corner> corners = corners_of(request, spread);
  DesignRequest tight = request;
  tight.spark_out = SparkOut::given;
  tight.comparison = Comparison::none;
  tight.process = tightest(corners).process;
  auto table = design_cycle(tight);
  if (!table) return Unexpected<Findings>(std::move(table.error()));
  InfeedLaw law = std::move(table->law);
  law.front().x_mm = request.allowance_mm + spread.allowance_mm;

  PlungeOptions simulation = request.simulation;
  simulation.at_end = InfeedTravel::AtEnd::stands;
  const int decimals = request.staircase.decimals.value_or(usual_decimals(request.process));
  const double quantum = std::pow(10.0, -decimals);
  for (int round = 0; round < lowerings_max; ++round) {
    const double use = worst_use(corners, law, simulation, request.limits.burn_margin);
    if (use <= 1.0) break;
    law = with_feeds(std::move(law), 1.0 / use);
    for (InfeedRow& row : law)
      row.feed_mm_per_s = std::max(quantum, std::floor(row.feed_mm_per_s / quantum) * quantum);
  }
  const double band_mm = request.limits.residual_max_mm + request.limits.undersize_max_mm;
  const double round_mm =
      request.limits.roundness_max_mm > 0.0 ? request.limits.roundness_max_mm : band_mm;
  constexpr double used_part = 0.9;  // of the band: the last X is rounded
  const bool finds = request.spark_out == SparkOut::found || !spread.is_none();
  for (int revolutions = 0; finds && revolutions <= robust_spark_out_max; ++revolutions) {
    simulation.spark_out_revolutions = revolutions;
    const Sizes sizes = sizes_of(corners, law, simulation);
    if (sizes.width_mm() <= used_part * band_mm && sizes.step_mm <= round_mm) break;
  }
  centre(corners, request.limits, simulation, quantum, law);

  DesignRequest nominal = request;
  nominal.simulation = simulation;
  nominal.comparison = Comparison::none;
  RobustDesign robust;
  robust.design = assessed_cycle(nominal, law_from(law, request.allowance_mm));
  robust.design.law = law;
  judge_corners(nominal, law, corners, robust.design.verification.findings);
  robust.corners = std::move(corners);
  return robust;
}

}  // namespace stanok::process

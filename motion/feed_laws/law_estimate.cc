#include "motion/feed_laws/law_estimate.h"

#include <algorithm>
#include <cmath>

#include "motion/feed_laws/interrupted_law.h"
#include "motion/feed_laws/linear_law.h"
#include "motion/feed_laws/modulated_law.h"

namespace stanok::motion {
namespace {

// factor ln(upper / lower), in s from min; only where both are feeds.
std::optional<double> logarithm(double factor, double upper, double lower) {
  if (upper <= 0.0 || lower <= 0.0) return std::nullopt;
  return s_per_min * factor * std::log(upper / lower);
}

// The feed of a stretch in mm/min.
double feed_of(const FeedLaw& law, const LawStretch& stretch, const LawPart& part) {
  if (stretch.feed <= 0.0) return s_per_min * part.feed_per_s;
  if (!law.units().per_revolution) return stretch.feed;
  const bool has_speed = law.units().speed == LawSpeed::rev_per_min;
  return stretch.feed * (has_speed ? stretch.speed : part.rev_per_min);
}

// Adds up the stretches, with the stands between them.
double sum_over_stretches(const FeedLaw& law, const LawPart& part) {
  double time = 0.0;
  std::uint64_t increments = law.increments_at(part.from_mm);
  for (double from = part.from_mm; from < part.to_mm - same_path_mm; ++increments) {
    const LawStretch stretch = law.stretch(increments);
    const double to = std::min(stretch.end_mm, part.to_mm);
    const bool stands = stretch.end_mm < part.to_mm - same_path_mm;
    time += (to - from + (stands ? stretch.stand_mm : 0.0)) / feed_of(law, stretch, part);
    from = to;
  }
  return s_per_min * time;
}

// Increments behind which the part goes on.
std::uint64_t increments_within(const FeedLaw& law, const LawPart& part) {
  const double to = part.to_mm - 2.0 * same_path_mm;
  return law.increments_at(std::max(to, part.from_mm)) - law.increments_at(part.from_mm);
}

// A linear law from its beginning on: whole stretches in closed form, and the rest.
std::optional<double> linear_closed_form(const LinearLaw& law, const LawPart& part) {
  const LinearLawParameters& p = law.parameters();
  const bool speed_changes = law.units().speed != LawSpeed::unchanged;
  if (part.from_mm > 0.0 || (law.units().per_revolution && speed_changes)) return std::nullopt;
  const double per_min = law.units().per_revolution ? part.rev_per_min : 1.0;
  const std::uint64_t stretches = increments_within(law, part);
  const auto whole =
      linear_time(per_min * p.feed_first, per_min * p.feed_step, p.path_step_mm, stretches);
  if (!whole.corrected) return std::nullopt;
  const double rest = part.to_mm - static_cast<double>(stretches) * p.path_step_mm;
  return *whole.corrected + s_per_min * rest / (per_min * law.stretch(stretches).feed);
}

void add_modulation(const ModulatedLaw& law, const LawPart& part, LawEstimate& found) {
  const ModulatedLawParameters& p = law.parameters();
  const double per_min = law.units().per_revolution ? part.rev_per_min : 1.0;
  found.cycle =
      modulation_cycle_time(per_min * p.feed_min, per_min * p.feed_step, p.path_step_mm, p.steps);
  const double cycle_mm = 2.0 * static_cast<double>(p.steps) * p.path_step_mm;
  found.closed_form_s = *found.cycle->corrected * (part.to_mm - part.from_mm) / cycle_mm;
  found.modulation_depth = p.feed_min / (p.feed_min + static_cast<double>(p.steps) * p.feed_step);
}

void add_interruption(const InterruptedLaw& law, const LawPart& part, LawEstimate& found) {
  found.feed_first = found.feed_last = s_per_min * part.feed_per_s;
  found.closed_form_s = found.time_s;
  if (part.rev_per_min <= 0.0) return;
  const double feed_per_rev = found.feed_first / part.rev_per_min;
  found.duration_rev = law.stand_mm() / feed_per_rev;
  found.spacing_rev = law.cut_mm() / feed_per_rev;
}

}  // namespace

TimeForms linear_time(double feed_first, double feed_step, double path_step_mm,
                      std::uint64_t stretches) {
  TimeForms time;
  for (std::uint64_t k = 0; k < stretches; ++k)
    time.exact += s_per_min * path_step_mm / (feed_first + static_cast<double>(k) * feed_step);
  const auto n = static_cast<double>(stretches);
  if (feed_step == 0.0) {
    time.printed = time.corrected = time.exact;
    return time;
  }
  const double factor = path_step_mm / feed_step;
  time.printed = logarithm(factor, feed_first + (n - 1.0) * feed_step, feed_first);
  time.corrected =
      logarithm(factor, feed_first + (n - 0.5) * feed_step, feed_first - 0.5 * feed_step);
  return time;
}

TimeForms modulation_cycle_time(double feed_min, double feed_step, double path_step_mm,
                                std::uint64_t steps) {
  TimeForms time;
  const std::uint64_t stretches = 2 * steps;
  for (std::uint64_t k = 0; k < stretches; ++k) {
    const auto above = static_cast<double>(std::min(k, stretches - k));
    time.exact += s_per_min * path_step_mm / (feed_min + above * feed_step);
  }
  const double feed_max = feed_min + static_cast<double>(steps) * feed_step;
  const double factor = path_step_mm / feed_step;
  time.printed =
      logarithm(factor, feed_max * (feed_max - feed_step), feed_min * (feed_min + feed_step));
  time.corrected = logarithm(2.0 * factor, feed_max, feed_min);
  return time;
}

double linear_increments_after(double feed_first, double feed_step, double path_step_mm,
                               double time_s) {
  const double time_min = time_s / s_per_min;
  if (feed_step == 0.0) return feed_first * time_min / path_step_mm;
  return feed_first * std::expm1(feed_step * time_min / path_step_mm) / feed_step;
}

std::optional<LawEstimate> estimate(const FeedLaw& law, const LawPart& part) {
  const bool needs_speed = law.units().per_revolution && law.units().speed != LawSpeed::rev_per_min;
  if (needs_speed && part.rev_per_min <= 0.0) return std::nullopt;
  LawEstimate found;
  found.increments = increments_within(law, part);
  found.feed_first = law.stretch(law.increments_at(part.from_mm)).feed;
  found.feed_last = law.stretch(law.increments_at(part.from_mm) + found.increments).feed;
  found.time_s = sum_over_stretches(law, part);
  if (law.kind() == LawKind::linear)
    found.closed_form_s = linear_closed_form(static_cast<const LinearLaw&>(law), part);
  if (law.kind() == LawKind::modulated)
    add_modulation(static_cast<const ModulatedLaw&>(law), part, found);
  if (law.kind() == LawKind::interrupted)
    add_interruption(static_cast<const InterruptedLaw&>(law), part, found);
  return found;
}

}  // namespace stanok::motion

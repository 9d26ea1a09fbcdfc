#include "channels/preparation/feed_law_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "motion/feed_laws/curve_law.h"
#include "motion/feed_laws/interrupted_law.h"
#include "motion/feed_laws/linear_law.h"
#include "motion/feed_laws/modulated_law.h"

namespace stanok::channels {
namespace {

using MadeLaw = Expected<std::unique_ptr<const motion::FeedLaw>, Diagnostic>;

// The smallest increment of feed: 0.1 mm/min, 0.001 mm/rev.
constexpr double feed_step_per_minute = 0.1;
constexpr double feed_step_per_revolution = 0.001;

Unexpected<Diagnostic> misfit(const std::string& message, const std::string& help) {
  Diagnostic d;
  d.code = "E5105";
  d.message = message;
  d.help = {help};
  return Unexpected<Diagnostic>(std::move(d));
}

std::string six_digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

motion::LawUnits units_of(const lang::FeedLaw& wanted) {
  motion::LawUnits units;
  units.per_revolution = wanted.feed_mode == lang::FeedMode::per_revolution;
  if (wanted.speed == lang::FeedLaw::Speed::rev_per_min)
    units.speed = motion::LawSpeed::rev_per_min;
  if (wanted.speed == lang::FeedLaw::Speed::m_per_min) units.speed = motion::LawSpeed::m_per_min;
  return units;
}

// From S_n to S_k over the block: |dl| is rounded down to increments of the machine first, so that
// all increments lie within the block; the number of increments comes from dS, and dn follows from
// it.
MadeLaw make_linear_over_block(const lang::FeedLaw& wanted, const LawPlace& place) {
  if (place.block_mm <= 0.0) {
    return misfit("a feed law with `S_k` but without `dl` has no length over which it is spread",
                  "give `dl`, or write the addresses in the block with the motion");
  }
  const double change = wanted.feed_last - wanted.feed_first;
  const double count = std::round(std::abs(change) / wanted.feed_step);
  const double machine_increments =
      std::floor((place.block_mm / count + motion::same_path_mm) / place.increment_mm);
  if (machine_increments < 1.0) {
    return misfit(six_digits(count) + " increments of `dS` do not fit into " +
                      six_digits(place.block_mm) + " mm in steps of " +
                      six_digits(place.increment_mm) + " mm",
                  "use a larger `dS`");
  }
  const bool has_speed = wanted.speed != lang::FeedLaw::Speed::unchanged;
  return std::make_unique<const motion::LinearLaw>(
      units_of(wanted),
      motion::LinearLawParameters{
          .feed_first = wanted.feed_first,
          .feed_step = std::copysign(wanted.feed_step, change),
          .path_step_mm = machine_increments * place.increment_mm,
          .increments_max = static_cast<std::uint64_t>(count),
          .speed_first = wanted.speed_first,
          .speed_step = has_speed ? (wanted.speed_last - wanted.speed_first) / count : 0.0});
}

// How many increments a law with dl makes at most: to S_k, or, where only the speed changes, over
// the block.
std::uint64_t increments_to_end(const lang::FeedLaw& wanted, const LawPlace& place) {
  const double change = std::abs(wanted.feed_last - wanted.feed_first);
  if (wanted.feed_last > 0.0 && wanted.feed_step > 0.0)
    return static_cast<std::uint64_t>(std::llround(change / wanted.feed_step));
  if (wanted.speed_last > 0.0) return motion::whole_steps(place.block_mm, wanted.path_step_mm);
  return ~std::uint64_t{0};
}

MadeLaw make_linear(const lang::FeedLaw& wanted, const LawPlace& place) {
  if (wanted.path_step_mm <= 0.0) return make_linear_over_block(wanted, place);
  motion::LinearLawParameters parameters{
      .feed_first = wanted.feed_first,
      .feed_step = wanted.falls ? -wanted.feed_step : wanted.feed_step,
      .path_step_mm = wanted.path_step_mm,
      .increments_max = increments_to_end(wanted, place),
      .speed_first = wanted.speed_first,
      .speed_step = wanted.speed_step};
  if (wanted.speed_last > 0.0) {
    if (parameters.increments_max == 0) {
      return misfit("`dl` is longer than the path of the law", "use a smaller `dl`");
    }
    parameters.speed_step =
        (wanted.speed_last - wanted.speed_first) / static_cast<double>(parameters.increments_max);
  }
  return std::make_unique<const motion::LinearLaw>(units_of(wanted), parameters);
}

MadeLaw make_modulated(const lang::FeedLaw& wanted, const LawPlace&) {
  return std::make_unique<const motion::ModulatedLaw>(
      units_of(wanted),
      motion::ModulatedLawParameters{.feed_min = wanted.feed_first,
                                     .feed_step = wanted.feed_step,
                                     .path_step_mm = wanted.path_step_mm,
                                     .steps = static_cast<std::uint64_t>(wanted.steps)});
}

MadeLaw make_interrupted(const lang::FeedLaw& wanted, const LawPlace&) {
  return std::make_unique<const motion::InterruptedLaw>(wanted.stand_mm, wanted.cut_mm);
}

MadeLaw make_curve(const lang::FeedLaw& wanted, const LawPlace& place) {
  const motion::LawUnits units = units_of(wanted);
  std::vector<motion::CurveLawPoint> points;
  points.reserve(wanted.curve.size());
  for (const lang::FeedLaw::CurvePoint& point : wanted.curve)
    points.push_back({point.path_mm, point.feed, point.speed});
  return std::make_unique<const motion::CurveLaw>(
      units, points, units.per_revolution ? feed_step_per_revolution : feed_step_per_minute,
      place.increment_mm);
}

struct LawRow {
  lang::FeedLaw::Kind kind;
  MadeLaw (*make)(const lang::FeedLaw& wanted, const LawPlace& place);
};

constexpr std::array law_rows{
    LawRow{lang::FeedLaw::Kind::linear, make_linear},
    LawRow{lang::FeedLaw::Kind::modulated, make_modulated},
    LawRow{lang::FeedLaw::Kind::interrupted, make_interrupted},
    LawRow{lang::FeedLaw::Kind::curve, make_curve},
};

}  // namespace

MadeLaw make_feed_law(const lang::FeedLaw& wanted, const LawPlace& place) {
  const auto row = std::find_if(law_rows.begin(), law_rows.end(),
                                [&](const LawRow& one) { return one.kind == wanted.kind; });
  return row->make(wanted, place);
}

}  // namespace stanok::channels

#include "motion/interpolation/automatic_feed.h"

#include <algorithm>
#include <cmath>

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

AutomaticFeed::AutomaticFeed(const AutomaticFeedConfig& config) : config_(config) {
  begin(config.on_at_start ? ModuleState::ready : ModuleState::reset);
}

void AutomaticFeed::begin(ModuleState state) RT_SAFE {
  state_ = config_.law != LawKind::none ? state : ModuleState::reset;
  part_ = 1.0;
  path_mm_ = 0.0;
  increments_ = 0;
}

void AutomaticFeed::advance(std::optional<double> signal, double path_mm) RT_SAFE {
  if (state_ == ModuleState::reset || state_ == ModuleState::fault) return;
  if (!signal || !std::isfinite(*signal)) {
    state_ = ModuleState::fault;
    part_ = config_.part_min;
    return;
  }
  if (state_ == ModuleState::ready) {
    if (*signal <= config_.level) return;
    state_ = ModuleState::running;
    path_mm_ = 0.0;
    increments_ = 0;
    return;
  }
  path_mm_ += path_mm;
  const std::uint64_t before = increments_;
  increments_ = whole_steps(path_mm_, config_.path_step_mm);
  if (config_.law == LawKind::modulated) {
    modulate(*signal);
  } else {
    follow(*signal, increments_ - before);
  }
}

// Smax = F, and Smin = F - n_s dS: down, up, and so on; it lets go at F.
void AutomaticFeed::modulate(double signal) RT_SAFE {
  const auto steps = static_cast<std::uint64_t>(
      std::max(std::llround((1.0 - config_.part_min) / config_.part_step), 1LL));
  const std::uint64_t in_cycle = increments_ % (2 * steps);
  const std::uint64_t below = std::min(in_cycle, 2 * steps - in_cycle);
  if (below == 0 && signal < config_.release) return switch_on();
  part_ = std::max(1.0 - config_.part_step * static_cast<double>(below), config_.part_min);
}

// One increment for each step of path that was passed.
void AutomaticFeed::follow(double signal, std::uint64_t steps) RT_SAFE {
  const double change = config_.part_step * static_cast<double>(steps);
  if (signal > config_.level) part_ = std::max(part_ - change, config_.part_min);
  if (signal < config_.release) part_ = std::min(part_ + change, 1.0);
  if (part_ >= 1.0 && signal <= config_.level) switch_on();
}

}  // namespace stanok::motion

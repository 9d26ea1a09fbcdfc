// What the process asks of the spindles: the speeds of feed laws and constant cutting speed.
#include <cmath>
#include <numbers>

#include "channels/cycle/channel.h"

namespace stanok::channels {

// The master spindle takes over what the piece of the path at hand asks for, and behind a law what
// its last increment asked for, which may have no path any more; it keeps that until it is told
// another speed. All spindles that hold a cutting speed follow the diameter.
void Channel::follow_process() RT_SAFE {
  const motion::PieceProcess& process = path_.process;
  const AskedSpeed behind{process.speed, process.spindle_speed_behind};
  if (path_.state == motion::PathState::moving) {
    if (process.spindle_speed <= 0.0) ask_speed(speed_behind_law_);
    ask_speed({process.speed, process.spindle_speed});
    speed_behind_law_ = behind;
  } else if (path_.chain_ended) {
    ask_speed(behind);
    speed_behind_law_ = {};
  }
  const double at = diameter();
  for (Spindle& spindle : spindles_) spindle.follow_diameter(at);
}

void Channel::ask_speed(const AskedSpeed& speed) RT_SAFE {
  if (speed.value <= 0.0) return;
  if (speed.unit == motion::LawSpeed::rev_per_min) spindles_[0].run_at(speed.value);
  if (speed.unit == motion::LawSpeed::m_per_min) spindles_[0].cut_at(speed.value);
}

void Channel::sense(std::span<const SpindleSensors> sensors) RT_SAFE {
  const auto spindle = static_cast<std::size_t>(figures_.machine_spindle[0]);
  if (figures_.spindle_count > 0 && spindle < sensors.size()) sensors_ = sensors[spindle];
}

// What the laws of the cycle leave of the programmed feed, by the path at feed of the cycle before.
double Channel::form_feed() RT_SAFE {
  const double way = path_.feed_commanded > 0.0 ? path_.path_advanced : 0.0;
  double part = 1.0;
  for (motion::AutomaticFeed& law : automatic_feeds_) {
    const bool was_lost = law.state() == motion::ModuleState::fault;
    const bool is_modulated = law.config().law == motion::LawKind::modulated;
    law.advance(is_modulated ? sensors_.vibration_um : sensors_.power_w, way);
    part *= law.part();
    if (law.state() == motion::ModuleState::fault && !was_lost) {
      emit(cycle_, "W604",
           is_modulated ? "the sensor of vibration gives no value: the feed is the smallest one"
                        : "the sensor of power gives no value: the feed is the smallest one",
           path_.tag);
    }
  }
  return part;
}

// A program begins with the programmed feed.
void Channel::restart_automatic_feeds() RT_SAFE {
  for (motion::AutomaticFeed& law : automatic_feeds_)
    law.switch_on(law.state() != motion::ModuleState::reset);
}

bool Channel::switch_automatic_feed(motion::LawKind law, bool on) RT_SAFE {
  for (motion::AutomaticFeed& candidate : automatic_feeds_) {
    if (candidate.config().law != law) continue;
    candidate.switch_on(on);
    return true;
  }
  return false;
}

double Channel::diameter() const RT_SAFE {
  const int x = motion_.geometry[0];
  return x < 0 ? 0.0 : 2.0 * std::abs(path_.point[static_cast<std::size_t>(x)].value);
}

ProcessOutput Channel::process() const RT_SAFE {
  constexpr double s_per_min = 60.0;
  constexpr double mm_per_m = 1000.0;
  ProcessOutput output;
  output.law = path_.process.kind;
  output.increments = path_.process.increments;
  output.stands = path_.state == motion::PathState::standing;
  output.interruption = interpolator_.interruption().lengths();
  output.interruptions = interpolator_.interruption().count();
  for (std::size_t k = 0; k < automatic_feeds_max; ++k) {
    const motion::AutomaticFeed& law = automatic_feeds_[k];
    output.automatic[k] = {.law = law.config().law, .state = law.state(), .part = law.part()};
  }
  output.feed_mm_per_min = s_per_min * path_.feed_commanded;
  output.spindle_rev_per_min = spindles_[0].speed();
  const double speed = std::abs(output.spindle_rev_per_min);
  if (speed > 0.0) output.feed_mm_per_rev = output.feed_mm_per_min / speed;
  output.cutting_speed_m_per_min = std::numbers::pi * diameter() * speed / mm_per_m;
  for (std::size_t k = 0; k < static_cast<std::size_t>(figures_.spindle_count); ++k)
    output.spindles[k] = {.id = spindles_[k].id(), .rev_per_min = spindles_[k].speed()};
  output.has_force_control = figures_.feed_modifier != nullptr;
  if (output.has_force_control) output.force = figures_.feed_modifier->status();
  return output;
}

}  // namespace stanok::channels

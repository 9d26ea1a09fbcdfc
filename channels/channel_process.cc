// What the process asks of the spindles: the speeds of feed laws and constant cutting speed.
#include <cmath>
#include <numbers>

#include "channels/channel.h"

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
  output.feed_mm_per_min = s_per_min * path_.feed_commanded;
  output.spindle_rev_per_min = spindles_[0].speed();
  const double speed = std::abs(output.spindle_rev_per_min);
  if (speed > 0.0) output.feed_mm_per_rev = output.feed_mm_per_min / speed;
  output.cutting_speed_m_per_min = std::numbers::pi * diameter() * speed / mm_per_m;
  for (std::size_t k = 0; k < static_cast<std::size_t>(figures_.spindle_count); ++k)
    output.spindles[k] = {.id = spindles_[k].id(), .rev_per_min = spindles_[k].speed()};
  return output;
}

}  // namespace stanok::channels

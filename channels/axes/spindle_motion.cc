#include "channels/axes/spindle_motion.h"

#include <cmath>

#include "base/units.h"

namespace stanok::channels {

double in_counts(double angle_deg, int pulses) RT_SAFE {
  constexpr double counts_per_pulse = 4.0;  // both edges of two tracks
  if (pulses <= 0) return angle_deg;
  const double count_deg = full_turn_deg / (counts_per_pulse * pulses);
  return count_deg * std::round(angle_deg / count_deg);
}

motion::SpindleMotion command_of(const Spindle& spindle) RT_SAFE {
  return {.turns = spindle.turns(),
          .speed = spindle.speed() / seconds_per_minute,
          .speed_wanted = spindle.target() / seconds_per_minute};
}

motion::SpindleMotion coming_motion(const Spindle& spindle, const motion::SpindleObserver& observer,
                                    double cycle_s) RT_SAFE {
  Spindle coming = spindle;
  coming.advance(cycle_s);
  motion::SpindleMotion next = command_of(coming);
  next.acceleration = (next.speed - spindle.speed() / seconds_per_minute) / cycle_s;
  return observer.ahead(cycle_s, next);
}

void obey(Spindle& spindle, const motion::SpindleOrder& order) RT_SAFE {
  switch (order.kind) {
    case motion::SpindleOrder::Kind::none:
      return;
    case motion::SpindleOrder::Kind::stop_within:
      return spindle.stop_within(order.turns);
    case motion::SpindleOrder::Kind::turn_back:
      return spindle.turn_back(order.factor, seconds_per_minute * order.acceleration);
    case motion::SpindleOrder::Kind::go_on:
      return spindle.go_on();
    case motion::SpindleOrder::Kind::turn_out:
      return spindle.turn_out(seconds_per_minute * order.speed,
                              seconds_per_minute * order.acceleration);
    case motion::SpindleOrder::Kind::stop:
      return spindle.stop();
  }
}

}  // namespace stanok::channels

#include "process/adaptive/force_control.h"

#include <algorithm>
#include <cmath>

#include "process/adaptive/clock_block.h"

namespace stanok::process {
namespace {

using motion::ForceCommand;
using motion::ForceEvent;
using motion::ForceState;

// The path goes at the feed asked for when it is this close to it.
constexpr double follows_within = 0.05;

// At S_max, or so near to it that no further rise is asked for, the force is too low when it is
// lower by this part of its setpoint.
constexpr double at_most_within = 0.02;
constexpr double low_part = 0.1;

ForceEvent event_of(motion::PowerDoubt doubt, SensorFault then) RT_SAFE {
  const bool is_slow = then == SensorFault::feed_min;
  switch (doubt) {
    case motion::PowerDoubt::none:
      break;
    case motion::PowerDoubt::lost:
      return is_slow ? ForceEvent::sensor_lost_slow : ForceEvent::sensor_lost;
    case motion::PowerDoubt::below_idle:
      return is_slow ? ForceEvent::below_idle_slow : ForceEvent::below_idle;
    case motion::PowerDoubt::no_answer:
      return is_slow ? ForceEvent::no_answer_slow : ForceEvent::no_answer;
    case motion::PowerDoubt::stays_high:
      return is_slow ? ForceEvent::stays_high_slow : ForceEvent::stays_high;
  }
  return ForceEvent::none;
}

}  // namespace

ForceControl::ForceControl(const ForceControlConfig& config)
    : config_(config),
      compensator_(config),
      controller_(config),
      law_(config),
      observer_(config),
      interruption_(config) {
  amplifier_.set_level(config.vibration_level_um);
}

bool ForceControl::command(const ForceCommand& command) RT_SAFE {
  switch (command.kind) {
    case ForceCommand::Kind::off:
      switch_off();
      return true;
    case ForceCommand::Kind::force:
      command_force(command);
      return law_.mean_n() > 0.0;
    case ForceCommand::Kind::oscillate:
      if (!is_on() || command.oscillation_n >= law_.mean_n()) return false;
      law_.set_programmed(
          {.force_n = command.oscillation_n, .frequency_hz = command.oscillation_hz});
      return true;
    case ForceCommand::Kind::vibration_on:
      return command_vibration(command);
    case ForceCommand::Kind::vibration_off:
      law_.set_automatic(0.0, 0.0);
      return true;
    case ForceCommand::Kind::adjust:
      adjust(command);
      return true;
    case ForceCommand::Kind::depth:
      observer_.give_depth(command.depth_mm);
      return true;
  }
  return false;
}

// The force commanded last is kept for an operator who switches on again.
void ForceControl::switch_off() RT_SAFE {
  status_ = {};
  controller_.reset();
  observer_ = ProcessObserver(config_);
  const double force_n = law_.mean_n();
  law_ = SetpointLaw(config_);
  law_.set_mean(force_n);
  amplifier_.set_level(config_.vibration_level_um);
  feed_asked_ = 0.0;
  interruption_ = InterruptedCut(config_);
  missing_.reset();
  events_.tell_again();
}

void ForceControl::command_force(const ForceCommand& command) RT_SAFE {
  if (command.force_n > 0.0) set_force(command.force_n);
  if (law_.mean_n() <= 0.0) return;
  clamps_ = FeedClamps(command);
  observer_.reset();
  events_.tell_again();
  status_.state = ForceState::idle_power;
}

// Another force while it is on: the feed ahead goes as h ~ P^(1/y).
void ForceControl::set_force(double force_n) RT_SAFE {
  const double before = law_.mean_n();
  law_.set_mean(force_n);
  if (!is_on() || before <= 0.0) return;
  const double factor = std::pow(force_n / before, 1.0 / config_.feed_exponent);
  controller_.scale(factor);
  observer_.scale(factor);
}

// What an operator sets holds from now on, beyond the program.
void ForceControl::adjust(const ForceCommand& command) RT_SAFE {
  if (command.force_n > 0.0) set_force(command.force_n);
  if (command.level_um > 0.0) {
    config_.vibration_level_um = command.level_um;
    amplifier_.set_level(command.level_um);
  }
  if (command.reduced_mass_kg > 0.0) config_.reduced_mass_kg = command.reduced_mass_kg;
  if (command.oscillation_hz > 0.0) config_.oscillation_hz = command.oscillation_hz;
  const bool forms = command.reduced_mass_kg > 0.0 || command.oscillation_hz > 0.0;
  if (forms && law_.can_form()) law_.set_automatic(config_.reduced_mass_kg, config_.oscillation_hz);
}

bool ForceControl::command_vibration(const ForceCommand& command) RT_SAFE {
  const auto given = [](double commanded, double otherwise)
                         RT_SAFE { return commanded > 0.0 ? commanded : otherwise; };
  amplifier_.set_level(given(command.level_um, config_.vibration_level_um));
  law_.set_automatic(given(command.reduced_mass_kg, config_.reduced_mass_kg),
                     given(command.oscillation_hz, config_.oscillation_hz));
  return is_on() && amplifier_.level_um() > 0.0 && law_.can_form();
}

bool ForceControl::is_ready() const RT_SAFE {
  return status_.state != ForceState::idle_power;
}

motion::FeedDemand ForceControl::advance(const motion::CutState& cut) RT_SAFE {
  events_.begin_cycle();
  radius_.count(cut);
  compensator_.advance(cut);
  computing_ = {.omega = angular_speed(cut.rev_per_min),
                .radius_mm = radius_.counter().radius_mm(),
                .efficiency = config_.efficiency};
  status_.captures = compensator_.captures();
  status_.radius_mm = computing_.radius_mm;
  status_.power_w = cut.power_w;
  status_.power_idle_w = compensator_.power_w(cut.rev_per_min);
  status_.level_um = amplifier_.level_um();
  status_.reduced_mass_kg = law_.mass_kg();
  if (!is_on()) return {};
  resolve_clamps(cut);
  observe(cut);
  return control(cut);
}

void ForceControl::resolve_clamps(const motion::CutState& cut) RT_SAFE {
  const auto limits = clamps_.resolve(config_, cut);
  if (!limits) return;  // in rapid: those of the feed before
  status_.feed_max_per_s = limits->max;
  status_.feed_min_per_s = limits->min;
}

void ForceControl::observe(const motion::CutState& cut) RT_SAFE {
  const bool lost_vibration = law_.mass_kg() > 0.0 && !std::isfinite(cut.vibration_um);
  events_.set_vibration_lost(lost_vibration);
  if (status_.state == ForceState::fault) return;
  const double turns_per_s = cut.rev_per_min / s_per_min;
  const bool turns = turns_per_s > 0.0;
  const bool has_gaps = interruption_.is_interrupted();
  observer_.look({.cycle_s = cut.cycle_s,
                  .power_w = cut.power_w,
                  .power_idle_w = status_.power_idle_w,
                  .force_n = status_.force_n,
                  .wanted_n = law_.mean_n(),
                  .watt_per_newton = computing_.power_w(1.0),
                  .feed = controller_.feed_per_rev(),
                  .feed_max = turns ? status_.feed_max_per_s / turns_per_s : 0.0,
                  .feed_programmed = turns ? cut.feed_programmed / turns_per_s : 0.0,
                  .revolution_s = turns ? 1.0 / turns_per_s : 0.0,
                  .measuring_s = has_gaps ? 1.0 / turns_per_s : 0.0,
                  .cuts = cuts_ && turns && controller_.has_feed(),
                  .is_rapid = cut.is_rapid,
                  .follows = path_follows(cut),
                  .is_at_speed = cut.at_speed && compensator_.is_captured(),
                  .is_at_minimum = feed_asked_ <= status_.feed_min_per_s});
  status_.doubt = observer_.doubt();
  status_.reference = observer_.reference();
  status_.force_worst_n = observer_.worst_part() * law_.mean_n();
  if (status_.doubt == motion::PowerDoubt::none) return;
  status_.state = ForceState::fault;
  events_.note(event_of(status_.doubt, config_.on_sensor_fault));
}

// At the feed asked for, and at no less of it.
bool ForceControl::path_follows(const motion::CutState& cut) const RT_SAFE {
  const double expected = cut.feed_override * feed_asked_;
  return !cut.has_law && cut.feed_override >= 1.0 &&
         std::abs(cut.path_speed - expected) <= follows_within * expected;
}

motion::FeedDemand ForceControl::demand(double feed_per_s) RT_SAFE {
  feed_asked_ = feed_per_s;
  status_.feed_per_s = feed_per_s;
  if (feed_per_s <= 0.0) return {};
  return {.feed_per_s = feed_per_s, .feed_max_per_s = status_.feed_max_per_s};
}

motion::FeedDemand ForceControl::control(const motion::CutState& cut) RT_SAFE {
  if (status_.state == ForceState::fault) return demand(status_.feed_min_per_s);
  if (!compensator_.is_known() || (!compensator_.is_captured() && cut.path_speed == 0.0)) {
    // A spindle that stands has no idle power to wait for.
    status_.state = cut.rev_per_min > 0.0 ? ForceState::idle_power : ForceState::holding;
    cuts_ = false;
    return demand(0.0);
  }
  const double turns_per_s = cut.rev_per_min / s_per_min;
  interruption_.follow({.cycle_s = cut.cycle_s,
                        .turns_per_s = turns_per_s,
                        .cutting_w = deviation_w(cut.power_w, status_.power_idle_w, 0.0),
                        .feeds = cut.is_controllable && cut.path_speed > 0.0});
  cuts_ = is_cutting(cut);
  status_.state = cuts_ ? ForceState::regulating : ForceState::holding;
  const ForceSetpoint setpoint = form_setpoint(cut);
  if (turns_per_s > 0.0 && cut.is_controllable) regulate(cut, setpoint);
  watch_force(cut);
  // Blocks 22 and 23.
  const double part =
      clock_part(computing_, computing_.power_w(setpoint.emphasised_n), setpoint.mean_n);
  const double clock = std::clamp(part * controller_.feed_per_rev() * turns_per_s,
                                  status_.feed_min_per_s, status_.feed_max_per_s);
  constexpr double code_of_program = 0.0;
  const Traverse traverse = cut.is_rapid ? Traverse::rapid : Traverse::feed;
  return demand(controller_.has_feed() ? rapid_key(traverse, code_of_program, clock)
                                       : code_of_program);
}

// At working feed, with power enough to be in the workpiece, over a turn where the cut has gaps.
bool ForceControl::is_cutting(const motion::CutState& cut) RT_SAFE {
  const double wanted_w = computing_.power_w(law_.mean_n());
  const double cutting_w = deviation_w(cut.power_w, status_.power_idle_w, 0.0);
  const bool has_gaps = interruption_.is_interrupted();
  const double over_turn_w = has_gaps ? interruption_.mean_w() : cutting_w;
  const bool cuts = cut.is_controllable && cut.path_speed > 0.0 && cut.rev_per_min > 0.0 &&
                    wanted_w > config_.power_min_w && over_turn_w > config_.air_part * wanted_w;
  status_.force_n = cuts ? computing_.force_n(has_gaps ? interruption_.peak_w() : cutting_w) : 0.0;
  return cuts;
}

// Blocks 16 to 21.
ForceSetpoint ForceControl::form_setpoint(const motion::CutState& cut) RT_SAFE {
  const Vibration vibration =
      amplifier_.pass({.amplitude_um = cut.vibration_um, .frequency_hz = cut.vibration_hz},
                      config_.vibration_release);
  const ForceSetpoint setpoint =
      law_.advance({.cycle_s = cut.cycle_s,
                    .revolution_s = cut.rev_per_min > 0.0 ? s_per_min / cut.rev_per_min : 0.0,
                    .vibration = vibration,
                    .sensed = {.amplitude_um = cut.vibration_um, .frequency_hz = cut.vibration_hz},
                    .least_um = config_.vibration_release * amplifier_.level_um(),
                    .cuts = cuts_});
  events_.note(law_.event());
  status_.force_set_n = setpoint.mean_n;
  status_.force_now_n = setpoint.now_n;
  status_.vibration_um = vibration.amplitude_um;
  status_.vibration_hz = vibration.frequency_hz;
  status_.oscillation_n = law_.oscillation().force_n;
  status_.oscillation_hz = law_.oscillation().frequency_hz;
  return setpoint;
}

// Blocks 13 and 14.
void ForceControl::regulate(const motion::CutState& cut, const ForceSetpoint& setpoint) RT_SAFE {
  const double turns_per_s = cut.rev_per_min / s_per_min;
  if (!controller_.has_feed()) controller_.begin_with(cut.feed_programmed / turns_per_s);
  const double wanted_w = computing_.power_w(setpoint.sensed_n);
  const double mean_w = computing_.power_w(setpoint.mean_n);
  const bool has_gaps = interruption_.is_interrupted();
  const double deviation = has_gaps ? interruption_.peak_w() - mean_w
                                    : deviation_w(cut.power_w, status_.power_idle_w, wanted_w);
  const double feed_min = status_.feed_min_per_s / turns_per_s;
  const double feed_max = std::min(status_.feed_max_per_s / turns_per_s, observer_.feed_max());
  controller_.advance({.cycle_s = cut.cycle_s,
                       .revolution_s = 1.0 / turns_per_s,
                       .deviation = mean_w > 0.0 ? deviation / mean_w : 0.0,
                       .cuts = cuts_,
                       .follows = path_follows(cut),
                       .feed_min = feed_min,
                       .feed_max = std::max(feed_min, feed_max),
                       .delay_s = has_gaps ? 1.0 / turns_per_s : 0.0});
  events_.set_overloaded(controller_.is_at_minimum());
}

void ForceControl::watch_force(const motion::CutState& cut) RT_SAFE {
  const bool feeds =
      cut.is_controllable && cut.path_speed > 0.0 && cut.feed_override >= 1.0 && !cut.has_law;
  const bool is_low = status_.force_n < (1.0 - low_part) * law_.mean_n();
  const bool is_at_most = feed_asked_ >= (1.0 - at_most_within) * status_.feed_max_per_s;
  const bool is_limited = cuts_ && observer_.is_at_reference(controller_.feed_per_rev());
  const MissingForce::Inputs inputs{.cycle_s = cut.cycle_s,
                                    .is_rapid = cut.is_rapid,
                                    .feeds = feeds,
                                    .is_low = !cuts_ || (is_low && (is_at_most || is_limited))};
  if (missing_.look(inputs, config_.air_time_s))
    events_.note(is_limited ? ForceEvent::cut_is_lighter : ForceEvent::force_missing);
}

}  // namespace stanok::process

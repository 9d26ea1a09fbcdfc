// What is asked of one channel: load, start, stop, reset, change of kinematics.
#include "channels/coordinator.h"

namespace stanok::channels {
namespace {

// A drive needs several polls of the bus from switch-on to holding its axis.
constexpr double drives_ready_within_s = 3.0;

}  // namespace

Coordinator::Verdict Coordinator::step_load(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    if (is_busy(target) || target.is_resetting())
      return refusal("E6003", target, " is running or held");
    if (target.state() == ChannelState::alarm)
      return refusal("E6004", target, " has an alarm; reset it first");
    target.begin_load(errand.text, errand.job);
    errand.stage = 1;
    return pending();
  }
  if (target.load_outcome() == Outcome::pending) return pending();
  if (target.load_outcome() == Outcome::failed) return refusal("", target.last_text().view());
  return success();
}

Coordinator::Verdict Coordinator::step_start(Errand& errand, Channel& target) RT_SAFE {
  if (target.state() == ChannelState::held) {
    target.resume();
    return success();
  }
  if (target.state() == ChannelState::running)
    return refusal("E6003", target, " is already running");
  if (target.state() == ChannelState::alarm)
    return refusal("E6004", target, " has an alarm; reset it first");
  if (errand.job == Job::program && !target.has_program())
    return refusal("E6005", target, " has no program loaded");
  if (!target.is_powered()) return refusal("E6006", "the machine is off");
  if (!target.drives_ready()) {
    const double waited = static_cast<double>(errand.cycles) * cycle_s_;
    return waited < drives_ready_within_s ? pending()
                                          : refusal("E6008", target, ": the drives are not ready");
  }
  if (!target.is_quiet()) return pending();
  target.begin_run(errand.job);
  const auto started = static_cast<std::size_t>(errand.target);
  owner_[started] = errand.asker;
  if (errand.asker != operator_asker)
    owner_run_[started] = channels_[static_cast<std::size_t>(errand.asker)]->run();
  return success();
}

Coordinator::Verdict Coordinator::step_run(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage < 2) {
    const Verdict loaded = step_load(errand, target);
    if (!loaded.done || !loaded.ok) return loaded;
    errand.stage = 2;
  }
  return step_start(errand, target);
}

Coordinator::Verdict Coordinator::step_stop(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    if (!is_busy(target)) return refusal("E6007", target, ": nothing was running");
    target.hold(errand.asker == operator_asker ? HoldCause::operator_hold
                                               : HoldCause::channel_stop);
    errand.stage = 1;
  }
  if (!is_busy(target)) return success();
  return target.is_standing() ? success() : pending();
}

Coordinator::Verdict Coordinator::step_reset(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    target.begin_reset();
    errand.stage = 1;
    return pending();
  }
  return target.is_resetting() ? pending() : success();
}

// M99 in the main program, endless on a machine; a simulation ends behind it.
Coordinator::Verdict Coordinator::step_restart(Channel& asker) RT_SAFE {
  if (asker.begins_again()) return success();
  return refusal("W2099", "M99 in the main program");
}

Coordinator::Verdict Coordinator::step_kinematics(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    const bool own = errand.asker == errand.target;
    if (!target.has_scheme(errand.number))
      return refusal("E5201", "the channel has no such kinematic scheme");
    if (!own && is_busy(target))
      return refusal("E5202", "the channel whose kinematics shall change is running or held");
    if (target.state() == ChannelState::alarm)
      return refusal("E6004", target, " has an alarm; reset it first");
    if (!target.is_powered()) return refusal("E6006", "the machine is off");
    if (!own && !target.is_quiet()) return pending();
    target.begin_switch(errand.number);
    errand.stage = 1;
    return pending();
  }
  if (target.switch_outcome() == Outcome::pending) return pending();
  if (target.switch_outcome() == Outcome::failed)
    return refusal("E5204", target.last_text().view());
  return success();
}

}  // namespace stanok::channels

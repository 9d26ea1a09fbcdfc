// What is asked of one channel: load, start, stop, reset, change of kinematics.
#include "channels/coordinator/coordinator.h"

namespace stanok::channels {
namespace {

// A drive needs several polls of the bus from switch-on to holding its axis.
constexpr double drives_ready_within_s = 3.0;
// The slowest spindle needs this long from its greatest speed to rest.
constexpr double spindle_stands_within_s = 120.0;

}  // namespace

Coordinator::Verdict Coordinator::step_load(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    const bool searches = errand.job == Job::search;
    const auto action = searches ? OperatorAction::program_search : OperatorAction::program_load;
    if (const auto refused = obstacle(errand, action, target)) return *refused;
    if (searches) {
      if (!target.has_program()) return refusal("E6005", target, ": no program is loaded");
      if (!target.is_quiet()) return pending();
      target.begin_search(errand.text, errand.number == 0, errand.value);
    } else {
      target.begin_load(errand.text, errand.job);
    }
    errand.stage = 1;
    return pending();
  }
  if (target.load_outcome() == Outcome::pending) return pending();
  if (target.load_outcome() == Outcome::succeeded) return success();
  if (const auto refused = obstacle(errand, OperatorAction::program_load, target)) return *refused;
  return refusal("", target.last_text().view());
}

Coordinator::Verdict Coordinator::step_start(Errand& errand, Channel& target) RT_SAFE {
  const bool is_run = errand.kind == lang::RequestKind::channel_run;
  const auto action = is_run ? OperatorAction::program_run : OperatorAction::program_start;
  if (const auto refused = obstacle(errand, action, target)) return *refused;
  if (target.state() == ChannelState::held) {
    target.resume();
    return success();
  }
  if (target.axis_on_limit_switch() >= 0)
    return refusal("E6057", target, ": an axis stands on a limit switch; jog it back");
  if (const auto homeless = unreferenced(target, target.axes_of_scheme())) return *homeless;
  if (const auto taken = claim(errand.target, target.axes_of_scheme())) return *taken;
  target.release_axes(target.axes_of_scheme());
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
    if (errand.stage == 0) {
      if (const auto refused = obstacle(errand, OperatorAction::program_run, target))
        return *refused;
    }
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

std::optional<Coordinator::Verdict> Coordinator::claim(int index, lang::AxisSet axes) RT_SAFE {
  if (const auto foreign = foreign_axis(index, axes)) return foreign;
  const AxisOwnership::Obstacle obstacle = ownership_.obstacle(index, axes);
  if (obstacle.axis < 0) {
    ownership_.claim(index, axes);
    return std::nullopt;
  }
  Verdict verdict = refusal("E5203", "axis ");
  verdict.text.append(channel(index).axis_name(obstacle.axis).view());
  verdict.text.append(" belongs to channel ").append(channel(obstacle.owner).id());
  verdict.text.append(obstacle.owner_is_busy ? ", which is running or held" : " and is moving");
  return verdict;
}

// A program or a scheme may only begin where every axis knows its position; spindles need none.
std::optional<Coordinator::Verdict> Coordinator::unreferenced(const Channel& target,
                                                              lang::AxisSet axes) RT_SAFE {
  for (int axis = 0; axis < target.axis_count(); ++axis) {
    if ((axes >> axis & 1U) == 0 || target.is_homed(axis) || target.is_spindle_now(axis)) continue;
    Verdict verdict = refusal("E5208", "axis ");
    verdict.text.append(target.axis_name(axis).view()).append(" is not homed");
    return verdict;
  }
  return std::nullopt;
}

Coordinator::Verdict Coordinator::step_kinematics(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    const bool own = errand.asker == errand.target;
    if (!target.has_scheme(errand.number))
      return refusal("E5201", "the channel has no such kinematic scheme");
    if (const auto refused = obstacle(errand, OperatorAction::kinematics_select, target))
      return *refused;
    if (!target.is_powered()) return refusal("E6006", "the machine is off");
    if (!own && !target.is_quiet()) return pending();
    const lang::AxisSet axes = target.axes_of_scheme(errand.number);
    if (const auto homeless = unreferenced(target, axes)) return *homeless;
    if (const auto taken = claim(errand.target, axes)) return *taken;
    target.begin_switch(errand.number);
    errand.stage = 1;
    return pending();
  }
  if (target.switch_outcome() == Outcome::pending) return pending();
  if (target.switch_outcome() == Outcome::failed)
    return refusal(target.switch_fault().view(), target.last_text().view());
  return success();
}

// M902: the spindle stops, the drive takes the position over where it stands; without a reference
// it turns to its index pulse.
Coordinator::Verdict Coordinator::step_spindle_to_axis(Errand& errand, Channel& asker) RT_SAFE {
  const int spindle = errand.number;
  const double waited = static_cast<double>(errand.cycles) * cycle_s_;
  switch (errand.stage) {
    case 0:
      asker.stop_spindle(spindle);
      errand.stage = 1;
      return pending();
    case 1:
      if (!asker.spindle_stands(spindle)) {
        return waited < spindle_stands_within_s
                   ? pending()
                   : refusal("E5206", "the spindle that becomes an axis does not come to rest");
      }
      asker.close_position_loop(spindle);
      errand.stage = 2;
      errand.cycles = 0;
      return pending();
    case 2:
      if (asker.position_loop_is_closed(spindle) && asker.is_homed(asker.axis_of_spindle(spindle)))
        return success();
      if (asker.position_loop_is_closed(spindle) && asker.begin_homing_of_spindle(spindle)) {
        errand.stage = 3;
        return pending();
      }
      if (waited < drives_ready_within_s) return pending();
      asker.open_position_loop(spindle);
      return asker.is_homed(asker.axis_of_spindle(spindle))
                 ? refusal("E5206", "the drive does not close the position loop of the axis")
                 : refusal("E5207", "the axis that a spindle becomes has no reference");
    default:
      if (asker.manual_motion().homing() == ManualMotion::Outcome::running) return pending();
      if (asker.manual_motion().homing() == ManualMotion::Outcome::succeeded) return success();
      asker.open_position_loop(spindle);
      return refusal("E5207", asker.manual_motion().homing_fault().view());
  }
}

}  // namespace stanok::channels

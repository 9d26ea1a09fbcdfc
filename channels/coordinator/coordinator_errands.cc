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
      if (!target.state().has_program()) return refusal("E6005", target, ": no program is loaded");
      if (!target.is_quiet()) return pending();
      target.items().begin_search(
          errand.text, errand.number == 0 ? SearchWay::calculated : SearchWay::not_calculated,
          errand.value);
    } else {
      target.items().begin_load(errand.text, errand.job);
    }
    errand.stage = 1;
    return pending();
  }
  if (target.items().loads().outcome() == Outcome::pending) return pending();
  if (target.items().loads().outcome() == Outcome::succeeded) return success();
  if (const auto refused = obstacle(errand, OperatorAction::program_load, target)) return *refused;
  return refusal("", target.items().loads().text().view());
}

Coordinator::Verdict Coordinator::step_start(Errand& errand, Channel& target) RT_SAFE {
  const bool is_run = errand.kind == lang::RequestKind::channel_run;
  const auto action = is_run ? OperatorAction::program_run : OperatorAction::program_start;
  if (const auto refused = obstacle(errand, action, target)) return *refused;
  if (target.state().shown() == ChannelState::held) {
    target.run.resume();
    return success();
  }
  if (target.drives.axis_on_limit_switch() >= 0)
    return refusal("E6057", target, ": an axis stands on a limit switch; jog it back");
  if (const auto homeless = unreferenced(target, target.schemes.participants())) return *homeless;
  if (const auto taken = claim(errand.target, target.schemes.participants())) return *taken;
  target.axes.release(target.schemes.participants());
  if (!target.drives.all_ready()) {
    const double waited = static_cast<double>(errand.cycles) * cycle_s_;
    return waited < drives_ready_within_s ? pending()
                                          : refusal("E6008", target, ": the drives are not ready");
  }
  if (!target.is_quiet()) return pending();
  target.items().begin_run(errand.job);
  const auto started = static_cast<std::size_t>(errand.target);
  owner_[started] = errand.asker;
  if (errand.asker != operator_asker)
    owner_run_[started] = channels_[static_cast<std::size_t>(errand.asker)]->runs.run();
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
    target.run.hold(errand.asker == operator_asker ? HoldCause::operator_hold
                                                   : HoldCause::channel_stop);
    errand.stage = 1;
  }
  if (!is_busy(target)) return success();
  return target.motion.is_standing() ? success() : pending();
}

Coordinator::Verdict Coordinator::step_reset(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    target.run.begin_reset();
    errand.stage = 1;
    return pending();
  }
  return target.state().is_ending() ? pending() : success();
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
  verdict.text.append(channel(index).axes.name(obstacle.axis).view());
  verdict.text.append(" belongs to channel ").append(channel(obstacle.owner).id());
  verdict.text.append(obstacle.owner_is_busy ? ", which is running or held" : " and is moving");
  return verdict;
}

// A program or a scheme may only begin where every axis knows its position; spindles need none.
std::optional<Coordinator::Verdict> Coordinator::unreferenced(const Channel& target,
                                                              lang::AxisSet axes) RT_SAFE {
  for (int axis = 0; axis < target.axes.count(); ++axis) {
    if ((axes >> axis & 1U) == 0 || target.drives.is_homed(axis) || target.axes.is_spindle(axis))
      continue;
    Verdict verdict = refusal("E5208", "axis ");
    verdict.text.append(target.axes.name(axis).view()).append(" is not homed");
    return verdict;
  }
  return std::nullopt;
}

Coordinator::Verdict Coordinator::step_kinematics(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    const bool own = errand.asker == errand.target;
    if (target.schemes.find(errand.number) == nullptr)
      return refusal("E5201", "the channel has no such kinematic scheme");
    if (const auto refused = obstacle(errand, OperatorAction::kinematics_select, target))
      return *refused;
    if (!target.state().is_powered()) return refusal("E6006", "the machine is off");
    if (!own && !target.is_quiet()) return pending();
    const lang::AxisSet axes = target.schemes.axes_of(errand.number);
    if (const auto homeless = unreferenced(target, axes)) return *homeless;
    if (const auto taken = claim(errand.target, axes)) return *taken;
    target.items().begin_switch(errand.number);
    errand.stage = 1;
    return pending();
  }
  if (target.items().change().outcome() == Outcome::pending) return pending();
  if (target.items().change().outcome() == Outcome::failed)
    return refusal(target.items().change().code().view(), target.items().change().text().view());
  return success();
}

// M902: the spindle stops, the drive takes the position over where it stands; without a reference
// it turns to its index pulse.
Coordinator::Verdict Coordinator::step_spindle_to_axis(Errand& errand, Channel& asker) RT_SAFE {
  const int spindle = errand.number;
  const double waited = static_cast<double>(errand.cycles) * cycle_s_;
  switch (errand.stage) {
    case 0:
      asker.spindles.stop(spindle);
      errand.stage = 1;
      return pending();
    case 1:
      if (!asker.spindles.stands(spindle)) {
        return waited < spindle_stands_within_s
                   ? pending()
                   : refusal("E5206", "the spindle that becomes an axis does not come to rest");
      }
      asker.spindles.close_position_loop(spindle);
      errand.stage = 2;
      errand.cycles = 0;
      return pending();
    case 2:
      if (asker.spindles.position_loop_is_closed(spindle) &&
          asker.drives.is_homed(asker.spindles.axis_of(spindle)))
        return success();
      if (asker.spindles.position_loop_is_closed(spindle) &&
          asker.begin_homing_of_spindle(spindle)) {
        errand.stage = 3;
        return pending();
      }
      if (waited < drives_ready_within_s) return pending();
      asker.spindles.open_position_loop(spindle);
      return asker.drives.is_homed(asker.spindles.axis_of(spindle))
                 ? refusal("E5206", "the drive does not close the position loop of the axis")
                 : refusal("E5207", "the axis that a spindle becomes has no reference");
    default:
      if (asker.motion.manual().homing() == ManualMotion::Outcome::running) return pending();
      if (asker.motion.manual().homing() == ManualMotion::Outcome::succeeded) return success();
      asker.spindles.open_position_loop(spindle);
      return refusal("E5207", asker.motion.manual().homing_fault().view());
  }
}

}  // namespace stanok::channels

#include "channels/coordinator/channel_errands.h"

namespace stanok::channels {

using errand_states::Asked;
using errand_states::ChangingScheme;
using errand_states::Ending;
using errand_states::GoingBack;
using errand_states::Homing;
using errand_states::IndexSearching;
using errand_states::Loaded;
using errand_states::Loading;
using errand_states::LoopClosing;
using errand_states::Parking;
using errand_states::SpindleStopping;
using errand_states::TapComingOut;

namespace {

// A drive needs several polls of the bus from switch-on to holding its axis.
constexpr double drives_ready_within_s = 3.0;
// The slowest spindle needs this long from its greatest speed to rest.
constexpr double spindle_stands_within_s = 120.0;

bool is_busy(const Channel& channel) RT_SAFE {
  const ChannelState state = channel.state().shown();
  return state == ChannelState::running || state == ChannelState::held;
}

// A program or a scheme may only begin where every axis knows its position; spindles need none.
std::optional<Verdict> unreferenced(const Channel& channel, lang::AxisSet axes) RT_SAFE {
  for (int axis = 0; axis < channel.axes.count(); ++axis) {
    if ((axes >> axis & 1U) == 0 || channel.drives.is_homed(axis)) continue;
    if (channel.axes.is_spindle(axis)) continue;
    Verdict verdict = refusal("E5208", "axis ");
    verdict.text.append(channel.axes.name(axis).view()).append(" is not homed");
    return verdict;
  }
  return std::nullopt;
}

}  // namespace

ChannelErrands::ChannelErrands(const ChannelTable& channels, AxisOwnership& ownership,
                               const ControlDesk& control, const OwnerFailures& on_owner_failure,
                               double cycle_s)
    : channels_(channels),
      ownership_(ownership),
      control_(control),
      on_owner_failure_(on_owner_failure),
      cycle_s_(cycle_s) {}

Verdict ChannelErrands::step(Errand& errand, const requests::ProgramLoad& request) RT_SAFE {
  return load(errand, request.program, Job::program);
}

Verdict ChannelErrands::load(Errand& errand, const ShortText& text, Job job) RT_SAFE {
  if (errand.is<Loading>()) return await_load(errand);
  if (const auto refused = obstacle(errand, OperatorAction::program_load)) return *refused;
  target_of(errand).items().begin_load(text, job);
  errand.state = ErrandState(Loading{});
  return pending();
}

Verdict ChannelErrands::step(Errand& errand, const requests::Search& request) RT_SAFE {
  if (errand.is<Loading>()) return await_load(errand);
  Channel& target = target_of(errand);
  if (const auto refused = obstacle(errand, OperatorAction::program_search)) return *refused;
  if (!target.state().has_program())
    return refusal_of(target.id(), "E6005", ": no program is loaded");
  if (!target.is_quiet()) return pending();
  target.items().begin_search(request.target, request.way, request.passes);
  errand.state = ErrandState(Loading{});
  return pending();
}

Verdict ChannelErrands::await_load(const Errand& errand) const RT_SAFE {
  const LoadDesk& loads = target_of(errand).items().loads();
  if (loads.outcome() == Outcome::pending) return pending();
  if (loads.outcome() == Outcome::succeeded) return success();
  if (const auto refused = obstacle(errand, OperatorAction::program_load)) return *refused;
  return refusal("", loads.text().view());
}

Verdict ChannelErrands::step(Errand& errand, const requests::ProgramStart& /*request*/) RT_SAFE {
  return start(errand, OperatorAction::program_start, Job::program);
}

Verdict ChannelErrands::start(const Errand& errand, OperatorAction action, Job job) RT_SAFE {
  Channel& target = target_of(errand);
  if (const auto refused = obstacle(errand, action)) return *refused;
  if (target.state().shown() == ChannelState::held) {
    target.switches.resume();
    return success();
  }
  if (target.drives.axis_on_limit_switch() >= 0)
    return refusal_of(target.id(), "E6057", ": an axis is on a limit switch; jog it back");
  const lang::AxisSet axes = target.schemes.participants();
  if (const auto homeless = unreferenced(target, axes)) return *homeless;
  if (const auto taken = claim(errand.target, axes)) return *taken;
  target.axes.release(axes);
  if (!target.drives.all_ready()) return await_drives(errand);
  if (!target.is_quiet()) return pending();
  target.items().begin_run(job);
  Owner& owner = owners_[errand.target];
  owner.channel = errand.asker;
  if (errand.asker != operator_asker) owner.run = channels_[errand.asker].runs.run();
  return success();
}

Verdict ChannelErrands::await_drives(const Errand& errand) const RT_SAFE {
  if (waited_s(errand) < drives_ready_within_s) return pending();
  return refusal_of(target_of(errand).id(), "E6008", ": the drives are not ready");
}

Verdict ChannelErrands::step(Errand& errand, const requests::ProgramRun& request) RT_SAFE {
  return run(errand, request.program, Job::program);
}

Verdict ChannelErrands::step(Errand& errand, const requests::LineRun& request) RT_SAFE {
  return run(errand, request.line, Job::line);
}

Verdict ChannelErrands::run(Errand& errand, const ShortText& text, Job job) RT_SAFE {
  if (errand.is<Asked>()) {
    if (const auto refused = obstacle(errand, OperatorAction::program_run)) return *refused;
  }
  if (!errand.is<Loaded>()) {
    const Verdict verdict = load(errand, text, job);
    if (!verdict.done || !verdict.ok) return verdict;
    errand.state = ErrandState(Loaded{});
  }
  return start(errand, OperatorAction::program_run, job);
}

Verdict ChannelErrands::step(Errand& errand, const requests::ProgramStop& /*request*/) RT_SAFE {
  Channel& target = target_of(errand);
  if (errand.is<Asked>()) {
    if (!is_busy(target)) return refusal_of(target.id(), "E6007", ": nothing was running");
    target.run.hold(errand.asker == operator_asker ? HoldCause::operator_hold
                                                   : HoldCause::channel_stop);
    errand.state = ErrandState(Ending{});
  }
  if (!is_busy(target)) return success();
  return target.motion.is_standing() ? success() : pending();
}

Verdict ChannelErrands::step(Errand& errand, const requests::ProgramReset& /*request*/) RT_SAFE {
  Channel& target = target_of(errand);
  if (errand.is<Asked>()) {
    target.run.begin_reset();
    errand.state = ErrandState(Ending{});
    return pending();
  }
  return target.state().is_ending() ? pending() : success();
}

// Axes that the scheme parks are released for the search and come back to where they are parked.
Verdict ChannelErrands::step(Errand& errand, const requests::Home& request) RT_SAFE {
  if (errand.is<Asked>()) return begin_homing(errand, request.axis.view());
  Channel& target = target_of(errand);
  const ManualMotion& manual = target.motion.manual();
  if (manual.is_active() || target.state().is_ending()) return pending();
  const bool found = manual.homing() == ManualMotion::HomingState::succeeded;
  const bool is_overtaken = errand.generation != target.run.generation();
  if (errand.is<Homing>() && found && !is_overtaken) {
    target.return_to_parking();
    errand.state = ErrandState(Parking{});
    return pending();
  }
  if (target.state().is_powered()) target.power(Power::on);  // what is parked is braked again
  return found ? success() : refusal("A2001", manual.homing_fault().view());
}

Verdict ChannelErrands::begin_homing(Errand& errand, std::string_view name) RT_SAFE {
  Channel& target = target_of(errand);
  if (const auto refused = obstacle(errand, OperatorAction::home)) return *refused;
  lang::AxisSet axes = axes_to_home(target.axes);
  if (!name.empty()) {
    const int axis = target.axes.named(name);
    if (axis < 0) return refusal("E6052", "the channel has no axis of that name");
    axes = static_cast<lang::AxisSet>(axes & 1U << axis);
  }
  target.axes.release(axes);
  if (!target.drives.all_ready()) return await_drives(errand);
  target.home(axes);
  errand.state = ErrandState(Homing{});
  return pending();
}

// Spindles and coolant first, then the way back, part by part; a stop leaves the axes where they
// come to rest on it.
Verdict ChannelErrands::step(Errand& errand, const requests::ProgramReturn& request) RT_SAFE {
  Channel& target = target_of(errand);
  if (errand.is<Asked>()) {
    if (const auto refused = obstacle(errand, OperatorAction::program_return)) return *refused;
    if (target.motion.moves_by_hand())
      return refusal_of(target.id(), "E6056", ": axes are being jogged or homed");
    target.switches.set_spindles(Switch::on);
    target.switches.set_coolant(Switch::on);
    errand.state = ErrandState(GoingBack{target.run.hand_stops()});
  }
  if (std::get_if<GoingBack>(&errand.state)->hand_stops != target.run.hand_stops())
    return refusal_of(target.id(), "E6072", " was stopped on its way back");
  if (target.motion.moves_by_hand() || !target.switches.spindles_turn_as_commanded())
    return pending();
  if (target.motion.go_back(request.velocity)) return pending();
  target.run.apply(Change::path_joined);
  return success();
}

Verdict ChannelErrands::step(Errand& errand, const requests::KinematicsSelect& request) RT_SAFE {
  Channel& target = target_of(errand);
  if (errand.is<Asked>()) {
    const bool is_own = errand.asker == errand.target;
    if (target.schemes.find(request.scheme) == nullptr)
      return refusal("E5201", "the channel has no such kinematic scheme");
    if (const auto refused = obstacle(errand, OperatorAction::kinematics_select)) return *refused;
    if (!target.state().is_powered()) return refusal("E6006", "the machine is off");
    if (!is_own && !target.is_quiet()) return pending();
    const lang::AxisSet axes = target.schemes.axes_of(request.scheme);
    if (const auto homeless = unreferenced(target, axes)) return *homeless;
    if (const auto taken = claim(errand.target, axes)) return *taken;
    target.items().begin_switch(request.scheme);
    errand.state = ErrandState(ChangingScheme{});
    return pending();
  }
  const KinematicsChange& change = target.items().change();
  if (change.is_pending()) return pending();
  if (change.outcome() == Outcome::failed)
    return refusal(change.code().view(), change.text().view());
  return success();
}

Verdict ChannelErrands::tap_out(Errand& errand) RT_SAFE {
  Channel& asker = channels_[errand.asker];
  const TapInHole& tap = asker.spindles.tap();
  if (errand.is<Asked>()) {
    if (!tap.is_in()) return refusal("E6103", "no rigid tap was stopped in its hole");
    if (asker.spindles.is_axis(tap.tap().spindle))
      return refusal("E6103", "the spindle of the tap is an axis now");
    asker.items().begin_tap_out();
    errand.state = ErrandState(TapComingOut{});
    return pending();
  }
  if (tap.is_on_way_out()) return pending();
  return tap.code().view().empty() ? success() : refusal(tap.code().view(), tap.text().view());
}

Verdict ChannelErrands::spindle_to_axis(Errand& errand, int spindle) RT_SAFE {
  Channel& asker = channels_[errand.asker];
  if (errand.is<LoopClosing>()) return await_axis(errand, asker, spindle);
  if (errand.is<IndexSearching>()) return await_index(asker, spindle);
  if (errand.is<Asked>()) {
    asker.spindles.stop(spindle);
    errand.state = ErrandState(SpindleStopping{});
    return pending();
  }
  if (!asker.spindles.stands(spindle)) {
    if (waited_s(errand) < spindle_stands_within_s) return pending();
    return refusal("E5206", "the spindle that is to become an axis does not come to rest");
  }
  asker.spindles.close_position_loop(spindle);
  errand.state = ErrandState(LoopClosing{});
  errand.cycles = 0;
  return pending();
}

Verdict ChannelErrands::await_axis(Errand& errand, Channel& asker, int spindle) RT_SAFE {
  const bool is_closed = asker.spindles.position_loop_is_closed(spindle);
  const bool is_homed = asker.drives.is_homed(asker.spindles.axis_of(spindle));
  if (is_closed && is_homed) return success();
  if (is_closed && asker.begin_homing_of_spindle(spindle)) {
    errand.state = ErrandState(IndexSearching{});
    return pending();
  }
  if (waited_s(errand) < drives_ready_within_s) return pending();
  asker.spindles.open_position_loop(spindle);
  return is_homed ? refusal("E5206", "the drive does not close the position loop of the axis")
                  : refusal("E5207",
                            "the spindle that is to become an axis has not found its index pulse");
}

Verdict ChannelErrands::await_index(Channel& asker, int spindle) const RT_SAFE {
  const ManualMotion& manual = asker.motion.manual();
  if (manual.homing() == ManualMotion::HomingState::running) return pending();
  if (manual.homing() == ManualMotion::HomingState::succeeded) return success();
  asker.spindles.open_position_loop(spindle);
  return refusal("E5207", manual.homing_fault().view());
}

// Why what was asked for may not begin now: what the channel does, a stop since it was asked, or
// somebody who has the channel to himself.
std::optional<Verdict> ChannelErrands::obstacle(const Errand& errand, OperatorAction action) const
    RT_SAFE {
  if (errand.asker == errand.target) return std::nullopt;
  const Channel& target = target_of(errand);
  const std::string_view code = refusal_code(action, target.state().situation());
  if (!code.empty()) return refusal_of(target.id(), code, claim_of_refusal(code));
  if (errand.generation != target.run.generation())
    return refusal_of(target.id(), "E6072", " was stopped before it began");
  if (control_.admits(errand)) return std::nullopt;
  return refusal_of(target.id(), "E6080", " is controlled by another operator");
}

// Nothing: all these axes of channel `index` are its own now.
std::optional<Verdict> ChannelErrands::claim(int index, lang::AxisSet axes) RT_SAFE {
  if (const auto foreign = control_.foreign_axis(index, axes)) return foreign;
  const AxisOwnership::Obstacle obstacle = ownership_.obstacle(index, axes);
  if (obstacle.axis < 0) {
    ownership_.claim(index, axes);
    return std::nullopt;
  }
  Verdict verdict = refusal("E5203", "axis ");
  verdict.text.append(channels_[index].axes.name(obstacle.axis).view());
  verdict.text.append(" belongs to channel ").append(channels_[obstacle.owner].id());
  verdict.text.append(obstacle.owner_is_busy ? ", which is running or held" : " and is moving");
  return verdict;
}

void ChannelErrands::follow_owners() RT_SAFE {
  for (int k = 0; k < channels_.count(); ++k) {
    Owner& owner = owners_[k];
    if (owner.channel == operator_asker) continue;
    const Channel& master = channels_[owner.channel];
    if (!master.has_ended(owner.run) && !master.state().is_ending()) continue;
    owner.channel = operator_asker;
    Channel& owned = channels_[k];
    if (master.runs.ended_well(owner.run) || !is_busy(owned)) continue;
    const OwnerFailure rule = on_owner_failure_[k];
    if (rule == OwnerFailure::hold) owned.run.hold(HoldCause::owner_failed);
    if (rule == OwnerFailure::reset) owned.run.begin_reset();
  }
}

}  // namespace stanok::channels

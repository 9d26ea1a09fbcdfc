#include "channels/cycle/channel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "channels/cycle/force_terms.h"

namespace stanok::channels {

Channel::Channel(const motion::MotionConfig& motion, const ChannelConstants& constants,
                 const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes,
                 int scheme, ChannelLink& link, const CycleBooks& books)
    : CycleParts(motion, constants, schemes, scheme, link, books),
      items_(*this),
      announcements_(link.remarks, log),
      arrivals_(link) {}

// The drives did without it what their last targets let them do. A thread that is brought to rest
// is left in step with its spindle, and cannot be entered again.
void Channel::see_gap(const ClockGap& gap) RT_SAFE {
  spindles.see_gap();
  if (gap.then == AfterGap::goes_on || state().is_ending()) return;
  FixedText<128> text("the cycle was ");
  text.append(static_cast<long>(
                  std::llround(1e3 * static_cast<double>(gap.periods) * constants.cycle_s)))
      .append(" ms too late");
  if (motion.path().is_led_by_spindle)
    return run.fail("A4002", text.append(" in a thread").view(), motion.path().tag);
  if (gap.then == AfterGap::is_held) {
    if (state().is_held()) return run.stop_by_hand();  // it keeps its own cause
    if (state().situation() == Situation::running)
      log.tell("W732", text.view(), items_.current_tag());
    return run.hold(HoldCause::clock_gap);
  }
  if (rests_after_gap_ || !state().is_running() || motion.path_is_at_rest()) return;
  rests_after_gap_ = true;
  log.tell("W731", text.append(": the axes stop on the path").view(), motion.path().tag);
}

// A drive that is lost or faulty stops the channel along its path.
void Channel::watch_drives(std::span<const AxisFeedback> feedback) RT_SAFE {
  const bool homes = motion.manual().homing() == ManualMotion::HomingState::running;
  const auto fault = drives.advance(
      feedback, homes ? LimitSwitches::are_looked_for : LimitSwitches::stop_the_axis);
  if (!state().is_running()) motion.adopt_positions(state().is_powered() ? Power::on : Power::off);
  if (fault) run.fault(*fault);
}

void Channel::advance(std::int64_t cycle, Period period) RT_SAFE {
  runs.begin_cycle(cycle);
  marks.begin_cycle();
  if (period == Period::present) work_items();
  spindles.observe();
  stop_where_probe_meets_something();
  switches.advance();
  move();
  follow_thread();
  motion.close_loops();
  spindles.follow_process();
  spindles.turn();
  control_force();
  stop_at_step();
  work_marks(period);
  announce();
  name_program();
  if (std::exchange(link.has_lost_notice, false))
    run.fault({{"A9001"}, {"the preparation of the channel has not accepted a message"}});
  if (run.takes_power_off()) power(Power::off);
}

// A move by hand is stopped, a program fails.
void Channel::stop_where_probe_meets_something() RT_SAFE {
  if (state().is_ending() || !items_.probe().meets_something()) return;
  constexpr std::string_view text = "the probe has met something in a move that does not probe";
  if (!motion.moves_by_hand()) return run.fail("E4326", text, items_.current_tag());
  run.stop_by_hand();
  log.tell("W733", text, items_.current_tag());
}

void Channel::work_items() RT_SAFE {
  if (state().is_ending()) continue_reset();
  items_.advance();
  if (is_at_rest()) items_.settle();
  take_step();
  if (!state().is_ending()) items_.probe().advance(link);
}

// First to rest along the path, then the preparation is told to forget, then what it had pushed is
// dropped.
void Channel::continue_reset() RT_SAFE {
  if (!motion.is_standing()) return remove_power_when_it_lasts();
  if (!run.reset_is_told()) {
    if (link.notices.push(PathReset{items_.stand()})) run.note_reset_told();
    return items_.give_up();
  }
  Rest rest;
  if (!items_.drop_until_reset_done(rest)) return;
  forget_path();
  items_.end_all();
  if (state().is_running()) run.end_run(RunResult::failed, runs.blocks());
  run.finish_reset();
  items_.rest(rest);
}

// No ramp takes so long: something is wrong with the stop itself.
void Channel::remove_power_when_it_lasts() RT_SAFE {
  if (runs.cycle() - run.ends_since() <= constants.stop_cycles_max) return;
  power(Power::off);
  motion.break_off(link.path);
  run.break_off();
}

void Channel::forget_path() RT_SAFE {
  const std::uint64_t items = link.items.popped();
  arrivals_.show_rest();
  motion.forget_path(link.path);
  refill_.forget();
  marks.forget_riders();
  announcements_.forget();
  arrivals_.begin_anew(items);
}

// A step that is awaited and begins on the path: the first block that is closed. Where an item
// comes first that one is the step.
void Channel::take_step() RT_SAFE {
  if (motion.path().chunks_done >= items_.chunk_limit()) return;
  constexpr std::size_t segments_seen = 2;
  const auto& segments = link.path.segments;
  Stepper& stepper = run.stepper();
  for (std::size_t k = 0; k < std::min(segments.size(), segments_seen); ++k) {
    if (!stepper.awaits_next()) return;
    const motion::BlockTag& tag = segments[k].tag;
    if (tag.block >= stepper.closed_from_block()) static_cast<void>(stepper.admits(tag));
  }
}

void Channel::move() RT_SAFE {
  motion::PathQueue& queue = link.path;
  const std::uint64_t chunk_limit = items_.chunk_limit();
  marks.find_gates();
  const motion::FeedControl control = feed_control();
  const std::uint32_t lookahead_blocks =
      queue.chunks.empty() ? 0 : queue.chunks.front().lookahead_blocks;
  const bool is_guarded = state().is_running() && !state().is_ending();
  const auto fault = motion.advance(queue, control, chunk_limit,
                                    is_guarded ? SoftLimits::guarded : SoftLimits::not_guarded);
  if (motion.path_is_at_rest()) rests_after_gap_ = false;
  runs.advance(motion.path(), lookahead_blocks);
  items_.follow(motion.path().tag);
  tell_when_it_runs_dry();
  if (fault) run.fault(*fault);
  if (!motion.moves_by_hand()) run.apply(Change::hand_ends);
  if (!motion.is_off_path()) run.apply(Change::path_joined);
}

void Channel::tell_when_it_runs_dry() RT_SAFE {
  if (!state().is_running() || state().is_ending()) return refill_.forget();
  if (!refill_.look(motion.path().state, link.path)) return;
  log.tell("W730", "the axes pause: the blocks after this one were not prepared in time",
           motion.path().tag);
}

motion::FeedControl Channel::feed_control() RT_SAFE {
  motion::FeedControl control;
  control.feed_override = switches.feed_override_in_force();
  control.rapid_override = switches.rapid_override_in_force();
  control.hold =
      run.holds_path() || items_.probe().ends_path() || refill_.is_on() || rests_after_gap_;
  control.leaves_thread = run.leaves_thread();
  control.law_part = process.form_feed();
  process.apply(control);
  control.closed_from_block = closed_from_block();
  control.spindle_rev_per_min = std::abs(spindles.master().speed());
  return control;
}

std::uint64_t Channel::closed_from_block() const RT_SAFE {
  return std::min(run.stepper().closed_from_block(), marks.closed_from_block());
}

void Channel::follow_thread() RT_SAFE {
  const motion::InterpolatorOutput& path = motion.path();
  if (spindles.follow_tap(path))
    log.tell("W734", "a tap was left in its hole; G30 P99 takes it out", path.tag);
  spindles.obey(path.spindle_order);
  if (motion::ends_tap(path.spindle_order)) items_.wait_for_spindles();
  if (path.has_lost_spindle && !state().is_ending())
    run.fail("A4001", "the axes cannot follow the spindle through the thread", path.tag);
}

void Channel::control_force() RT_SAFE {
  const motion::ForceEvent event = process.advance(switches.feed_override_in_force());
  if (tell(event, motion.path().tag, log) == SensorLoss::holds_feed)
    run.hold(HoldCause::sensor_fault);
}

// A path that came too fast to a gate runs on to the end of the block behind it. A step is over
// when its items are done, too: a spindle has its speed.
void Channel::stop_at_step() RT_SAFE {
  const motion::InterpolatorOutput& path = motion.path();
  Stepper& stepper = run.stepper();
  if (path.tag.run == runs.run() && path.tag.block >= stepper.closed_from_block())
    stepper.pass(path.tag);
  const bool is_done = items_.is_idle() && !stepper.awaits_next();
  const bool is_at_step =
      is_done && path.at_gate && closed_from_block() == stepper.closed_from_block();
  if (is_at_step && state().situation() == Situation::running) run.hold(HoldCause::single_block);
}

void Channel::work_marks(Period period) RT_SAFE {
  const motion::InterpolatorOutput& path = motion.path();
  const bool is_present = period == Period::present;
  const std::uint64_t riders_before = link.riders.popped();
  if (state().is_ending() || (path.at_gate && !is_present)) return;
  const auto missed =
      marks.advance({.path = path.tag,
                     .stands_at_gate = path.at_gate,
                     .closed_block = run.stepper().closed_from_block(),
                     .riders_before_item = is_present ? items_.riders_before_item() : 0});
  if (link.riders.popped() != riders_before) motion.cut_history();
  if (missed) run.fail("E6024", "the path reached the mark too fast to stop there", *missed);
}

void Channel::announce() RT_SAFE {
  const bool is_over = motion.path_is_at_rest() && link.path.chunks.empty();
  announcements_.advance(motion.path().tag, is_over ? PathEnd::reached : PathEnd::not_reached);
}

void Channel::name_program() RT_SAFE {
  if (!runs.program().view().empty() || !state().is_running()) return;
  motion::BlockTag tag = items_.current_tag();
  if (tag.line == 0) return;
  tag.file = 0;
  runs.name_program(log.file_name(tag));
}

void Channel::fill(ChannelOutput& output) const RT_SAFE {
  output.id = constants.id;
  run.show(output);
  output.waiting = items_.is_waiting() || marks.is_waiting();
  output.wait = marks.is_waiting() ? marks.waits_for() : items_.waits_for();
  output.scheme = schemes.active_id();
  output.tag = items_.current_tag();
  output.feed_override = switches.feed_override();
  output.process = {};
  axes.show(output);
  drives.show(output);
  motion.show(output);
  spindles.show(output.process);
  process.show(output.process);
  output.workpiece = announcements_.workpiece();
  output.coolant_off = switches.coolant() == Switch::off;
  output.spindles_off = switches.spindles_are_off();
  output.tap_in_hole = spindles.tap().is_left();
  if (!output.coolant_off) output.coolant = items_.coolant();
  output.tool = items_.tool();
  output.arrivals = arrivals_.arrivals();
}

void Channel::power(Power to) RT_SAFE {
  run.apply(to == Power::on ? Change::power_on : Change::power_off);
  const bool has_scheme = schemes.active() != nullptr;
  const lang::AxisSet on = has_scheme ? schemes.participants() : axes.all();
  axes.power(to == Power::on ? on : lang::AxisSet{0});
}

void Channel::take_axis(int axis, const YieldedAxis& yielded) RT_SAFE {
  axes.take(axis, yielded);
  drives.forget(axis);
  motion.stand_with(axis, yielded.position);
}

void Channel::home(lang::AxisSet axes) RT_SAFE {
  motion.manual().home(axes);
  if (motion.manual().is_active()) run.apply(Change::hand_begins);
}

bool Channel::begin_homing_of_spindle(int id) RT_SAFE {
  const int axis = spindles.axis_of(id);
  if (axis < 0 || axes.constants(axis).manual.homing.order == 0) return false;
  home(static_cast<lang::AxisSet>(1U << axis));
  return true;
}

void Channel::return_to_parking() RT_SAFE {
  motion.return_to_parking();
  if (motion.manual().is_active()) run.apply(Change::hand_begins);
}

void Channel::set_single_block(Switch to) RT_SAFE {
  if (to == Switch::on) return run.stepper().switch_on(items_.current_tag());
  run.stepper().switch_off();
}

bool Channel::is_at_rest() const RT_SAFE {
  return !state().is_running() && !state().is_ending() && motion.is_standing() &&
         !items_.change().is_pending();
}

bool Channel::looks_for_contact() const RT_SAFE {
  return items_.probe().is_on() || motion.manual().homing() == ManualMotion::HomingState::running;
}

bool Channel::is_quiet() const RT_SAFE {
  return is_at_rest() && items_.is_idle() && link.items.empty() && link.riders.empty() &&
         items_.loads().outcome() != Outcome::pending && items_.settling().is_done();
}

}  // namespace stanok::channels

#include "channels/cycle/channel.h"

#include <algorithm>

#include "base/numeric.h"

namespace stanok::channels {
namespace {

constexpr int remarks_per_cycle = 8;
constexpr FileName no_file;

std::string_view first_line(std::string_view text) RT_SAFE {
  text.remove_suffix(text.size() - std::min(text.find('\n'), text.size()));
  return text;
}

}  // namespace

Channel::Channel(const motion::MotionConfig& motion, const ChannelFigures& figures,
                 const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes,
                 int scheme, ChannelLink& link, CycleBooks books)
    : motion_(motion),
      figures_(figures),
      link_(link),
      books_(books),
      interpolator_(motion),
      marks_(link.riders, *books.outputs) {
  for (const auto& [id, made] : schemes)
    schemes_.at(static_cast<std::size_t>(scheme_count_++)) = {id, made.get()};
  for (int k = 0; k < figures_.spindle_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    spindles_[i] = Spindle(figures_.spindles[i]);
  }
  for (std::size_t k = 0; k < automatic_feeds_max; ++k)
    automatic_feeds_[k] = motion::AutomaticFeed(figures_.automatic_feeds[k]);
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    path_.axes[k] = figures_.start[k];
    // Ideal drives, until real ones answer.
    feedback_[k].valid = true;
    feedback_[k].enabled = true;
    feedback_[k].referenced = figures_.axes[k].homed_at_start;
    setpoints_[k].position = figures_.start[k];
    setpoints_[k].position_code = motion::position_code(figures_.start[k], figures_.axes[k].codes);
  }
  owned_ = static_cast<lang::AxisSet>((1U << figures_.axis_count) - 1U);
  for (const int axis : figures_.spindle_axis) {
    if (axis >= 0) spindle_axes_ = static_cast<lang::AxisSet>(spindle_axes_ | 1U << axis);
  }
  std::array<ManualAxis, motion::axes_max> manual_axes{};
  for (std::size_t k = 0; k < motion::axes_max; ++k) manual_axes[k] = figures_.axes[k].manual;
  manual_.set_up({manual_axes.data(), static_cast<std::size_t>(figures_.axis_count)},
                 figures_.cycle_s);
  make_regulators();
  select_scheme(scheme);
}

void Channel::select_scheme(int scheme) {
  scheme_ = scheme;
  transform_ = {};
  transform_.scheme = find_scheme(scheme);
  stand_in_frame();
}

void Channel::advance(std::int64_t cycle) RT_SAFE {
  cycle_ = cycle;
  marks_.begin_cycle();
  if (resetting_) continue_reset();
  work_items();
  take_step();
  watch_probe();
  observe_spindles();
  move();
  follow_thread();
  demand_velocities();
  follow_process();
  turn_spindles();
  control_force();
  stop_at_step();
  work_marks();
  show_remarks(cycle);
  name_program();
  if (power_off_wanted_ && !resetting_ && is_standing()) {
    power(false);
    power_off_wanted_ = false;
  }
}

void Channel::work_marks() RT_SAFE {
  if (resetting_) return;
  const auto missed = marks_.advance({.path = path_.tag,
                                      .stands_at_gate = path_.at_gate,
                                      .closed_block = stepper_.closed_from_block(),
                                      .riders_before_item = riders_before_item()});
  if (missed) fail_run("E6024", "the path came too fast to the mark to stop there", *missed);
}

// Of an item that waits for nothing but riders; 0: there is none.
std::uint64_t Channel::riders_before_item() const RT_SAFE {
  if (link_.items.empty() || activity_ != Activity::none || !interpolator_.at_rest()) return 0;
  const Item& next = link_.items.front();
  return path_.chunks_done >= next.after_chunk ? next.after_rider : 0;
}

std::uint64_t Channel::closed_from_block() const RT_SAFE {
  return std::min(stepper_.closed_from_block(), marks_.closed_from_block());
}

// Chunks that may be entered now: those before the next item, and none while an item is at work.
std::uint64_t Channel::chunk_limit(std::uint64_t available) const RT_SAFE {
  if (activity_ != Activity::none) return path_.chunks_done;
  if (link_.items.empty()) return available;
  return std::min(available, link_.items.front().after_chunk);
}

void Channel::move() RT_SAFE {
  const std::uint64_t available = link_.path.chunks.shown();
  const std::uint64_t limit = chunk_limit(available);
  motion::FeedControl control = control_;
  if (!overrides_.feed_enabled) control.feed_override = 1.0;
  control.hold = control.hold || probe_.ends_path;
  marks_.find_gates();
  control.law_part = form_feed();
  apply_feed_demand(control);
  control.closed_from_block = closed_from_block();
  control.spindle_rev_per_min = std::abs(spindles_[0].speed());
  if (!link_.path.chunks.empty())
    lookahead_max_ = std::max(lookahead_max_, link_.path.chunks.front().lookahead_blocks);
  interpolator_.advance(link_.path, control, path_, limit);
  path_mm_ += path_.path_advanced;
  blocks_ = std::max(blocks_, path_.tag.run == run_ ? path_.tag.block : 0);
  // Homing names the position of an axis anew: its number steps, and the axis does not.
  const Steps steps = manual_.is_active() ? Steps::of_numbers : Steps::of_axes;
  if (manual_.is_active()) move_by_hand();
  const bool is_sound = guard_setpoints(steps);
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    AxisSetpoint& setpoint = setpoints_[i];
    const AxisFigures& axis = figures_.axes[i];
    const kinematics::Jet& jet = path_.axes[i];
    setpoint.velocity_code = motion::velocity_code(setpoint.position, jet.value, axis.codes);
    setpoint.position = jet.value;
    setpoint.velocity = jet.first;
    setpoint.acceleration = jet.second;
    setpoint.jerk = jet.third;
    setpoint.position_code = motion::position_code(jet.value, axis.codes);
  }
  if (is_sound) guard_limits();
}

void Channel::show_remarks(std::int64_t cycle) RT_SAFE {
  for (int n = 0; n < remarks_per_cycle && !link_.remarks.empty(); ++n) {
    const Remark& remark = link_.remarks.front();
    const bool passed = path_.tag.run == remark.tag.run && path_.tag.block > remark.tag.block;
    const bool stands = interpolator_.at_rest() && link_.path.chunks.empty();
    if (!passed && !stands) return;
    show(remark, cycle);
    link_.remarks.pop_front();
  }
}

void Channel::show(const Remark& remark, std::int64_t cycle) RT_SAFE {
  if (const auto* spoken = std::get_if<SpokenText>(&remark.news))
    return emit(cycle, spoken->code.view(), spoken->text.view(), remark.tag);
  ++workpiece_.announcements;
  if (const auto* blank = std::get_if<BlankNews>(&remark.news)) {
    ++workpiece_.shapes;
    workpiece_.shape = blank->shape;
    workpiece_.frame = blank->frame;
    workpiece_.has_shape = true;
  } else if (const auto* position = std::get_if<lang::WorkpiecePosition>(&remark.news)) {
    workpiece_.position = *position;
    workpiece_.has_position = true;
  }
}

void Channel::fill(ChannelOutput& output) const RT_SAFE {
  output.id = figures_.id;
  output.axis_count = figures_.axis_count;
  output.state = state_;
  output.moving = path_.state == motion::PathState::moving || manual_.is_active();
  output.running = running_;
  output.run = run_;
  output.waiting =
      (activity_ != Activity::none && activity_ != Activity::frame) || marks_.is_waiting();
  output.hold_cause = state_ == ChannelState::held ? hold_cause_ : HoldCause::none;
  output.scheme = scheme_;
  output.tag = running_ ? tag_at_hand() : motion::BlockTag{};
  output.program = program_;
  output.feed_commanded = path_.feed_commanded;
  output.path_speed = path_.s_speed;
  output.feed_override = control_.feed_override;
  output.process = process();
  output.workpiece = workpiece_;
  output.tool = tool_;
  output.point_W = path_.point;
  output.axes = setpoints_;
  output.drives = drives_;
  output.arrivals = arrivals_;
  output.has_feedback = !drives_are_ideal_;
  output.feedback = feedback_;
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    output.drives[i].follows_velocity = is_spindle_now(k);
    output.drives[i].reference = manual_.reference(i);
  }
}

void Channel::hold(HoldCause cause) RT_SAFE {
  manual_.stop();
  if (!running_ || resetting_) return;
  hold_cause_ = cause;
  control_.hold = true;
  state_ = ChannelState::held;
}

void Channel::resume() RT_SAFE {
  hold_wanted_ = false;
  if (state_ != ChannelState::held) return;
  // Other holds are in the middle of a step.
  if (hold_cause_ == HoldCause::single_block || hold_cause_ == HoldCause::program_stop)
    stepper_.next();
  control_.hold = false;
  state_ = ChannelState::running;
}

void Channel::answer(const ChannelAnswer& answer) RT_SAFE {
  if (!asks_) return;
  asks_ = false;
  activity_ = Activity::none;
  Notice notice;
  notice.kind = NoticeKind::answer;
  notice.block_skip = block_skip_;
  notice.ok = answer.ok;
  notice.raises = answer.raises;
  notice.value = answer.value;
  notice.probe_M = answer.probe_M;
  notice.left_path = answer.left_path;
  notice.code = answer.code;
  notice.text = answer.text;
  notice.axes_M = axes_M();
  static_cast<void>(link_.notices.push(notice));
}

void Channel::raise_alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  state_ = ChannelState::alarm;
  run_ok_ = false;
  record_alarm(code, text, tag);
}

void Channel::record_alarm(std::string_view code, std::string_view text,
                           const motion::BlockTag& tag) RT_SAFE {
  AlarmRecord record;
  record.channel = figures_.id;
  record.cycle = cycle_;
  record.tag = tag;
  record.code = FixedText<8>(code);
  record.text = FixedText<1024>(text);
  record.file = file_name(tag);
  last_alarm_ = {run_, tag.line, record.code, record.file};
  static_cast<void>(books_.reports->alarm_records().push(record));
  emit(cycle_, code, first_line(text), tag);
}

// The program at fault stops along its path and is over; the alarm stays until reset.
void Channel::fail_run(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  if (alarm_stays_) return;
  raise_alarm(code, text, tag);
  begin_reset();
  alarm_stays_ = true;
}

void Channel::name_program() RT_SAFE {
  if (!program_.view().empty() || !running_) return;
  motion::BlockTag tag = tag_at_hand();
  if (tag.line == 0) return;
  tag.file = 0;
  program_ = file_name(tag);
}

const FileName& Channel::file_name(const motion::BlockTag& tag) const RT_SAFE {
  if (tag.run != run_) return no_file;
  return link_.file_names[std::min<std::size_t>(tag.file, link_.file_names.size() - 1)];
}

bool Channel::ended_well(std::uint32_t run) const RT_SAFE {
  return run == run_ ? run_ok_ : run + 1 == run_ && run_before_ok_;
}

Situation Channel::situation() const RT_SAFE {
  if (resetting_) return Situation::ending;
  if (state_ == ChannelState::alarm) return powered_ ? Situation::alarm : Situation::fault;
  if (running_) return state_ == ChannelState::held ? Situation::held : Situation::running;
  if (!powered_) return Situation::off;
  if (is_switching()) return Situation::switching;
  if (manual_.is_active()) return Situation::by_hand;
  return has_program_ ? Situation::ready : Situation::idle;
}

bool Channel::is_quiet() const RT_SAFE {
  return !running_ && !resetting_ && is_standing() && activity_ == Activity::none &&
         link_.items.empty() && link_.riders.empty() && load_ != Outcome::pending &&
         switch_ != Outcome::pending;
}

void Channel::emit(std::int64_t cycle, std::string_view code, std::string_view text,
                   const motion::BlockTag& tag) RT_SAFE {
  Event event;
  event.cycle = cycle;
  event.channel = figures_.id;
  event.code = FixedText<8>(code);
  event.tag = tag;
  event.text = FixedText<240>(text);
  static_cast<void>(books_.events->push(event));
}

const kinematics::Scheme* Channel::find_scheme(int scheme) const RT_SAFE {
  for (int k = 0; k < scheme_count_; ++k) {
    const auto& [id, made] = schemes_[static_cast<std::size_t>(k)];
    if (id == scheme) return made;
  }
  return nullptr;
}

// The axes stand where they are, in the frame that holds from here.
void Channel::stand_in_frame() RT_SAFE {
  interpolator_.stand_at(axes_M(), transform_);
  frame_is_new_ = true;
}

motion::Point Channel::axes_M() const RT_SAFE {
  motion::Point point{};
  for (std::size_t k = 0; k < motion::axes_max; ++k) point[k] = path_.axes[k].value;
  return point;
}

}  // namespace stanok::channels

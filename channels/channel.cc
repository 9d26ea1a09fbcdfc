#include "channels/channel.h"

#include <algorithm>
#include <limits>

#include "base/numeric.h"

namespace stanok::channels {
namespace {

constexpr int items_per_cycle =
    16;  // bound of work; a program cannot keep the cycle busy with items
constexpr int remarks_per_cycle = 8;
constexpr double dwell_rounding = 1e-9;  // cycles; a dwell of whole cycles stays whole

}  // namespace

Channel::Channel(const motion::MotionConfig& motion, const ChannelFigures& figures,
                 const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes,
                 int scheme, ChannelLink& link, CycleBooks books)
    : motion_(motion), figures_(figures), link_(link), books_(books), interpolator_(motion) {
  for (const auto& [id, made] : schemes)
    schemes_.at(static_cast<std::size_t>(scheme_count_++)) = {id, made.get()};
  for (int k = 0; k < figures_.spindle_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    spindles_[i] = Spindle(figures_.spindles[i]);
  }
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    path_.axes[k] = figures_.start[k];
    drive_is_referenced_[k] = figures_.axes[k].homed_at_start;
    setpoints_[k].position = figures_.start[k];
    setpoints_[k].position_code = nearest_integer(figures_.start[k] / figures_.axes[k].resolution);
  }
  select_scheme(scheme);
}

void Channel::select_scheme(int scheme) {
  scheme_ = scheme;
  transform_ = {};
  transform_.scheme = find_scheme(scheme);
  interpolator_.stand_at(axes_M(), transform_);
}

void Channel::advance(std::int64_t cycle) RT_SAFE {
  cycle_ = cycle;
  has_passed_mark_ = false;
  if (resetting_) continue_reset();
  work_items(cycle);
  find_gate();
  move();
  work_riders();
  show_remarks(cycle);
  for (Spindle& spindle : spindles_) spindle.advance(figures_.cycle_s);
  if (power_off_wanted_ && !resetting_ && interpolator_.at_rest()) {
    power(false);
    power_off_wanted_ = false;
  }
}

// Items in program order, each when the path before it is done and the axes stand.
void Channel::work_items(std::int64_t cycle) RT_SAFE {
  for (int n = 0; n < items_per_cycle; ++n) {
    if (resetting_ || (state_ == ChannelState::held && running_)) return;
    if (!finish_activity()) return;
    if (link_.items.empty() || !interpolator_.at_rest()) return;
    if (path_.chunks_done < link_.items.front().after_chunk) return;
    if (link_.riders.popped() < link_.items.front().after_rider) return;
    static_cast<void>(link_.items.pop(item_));
    execute(item_, cycle);
  }
}

// True when nothing keeps the channel from its next item.
bool Channel::finish_activity() RT_SAFE {
  switch (activity_) {
    case Activity::none:
      return true;
    case Activity::frame:
      if (activity_began_ == cycle_) return false;
      break;
    case Activity::dwell:
      if (activity_cycles_-- > 0) return false;
      break;
    case Activity::spindle:
      if (!std::all_of(spindles_.begin(), spindles_.end(),
                       [](const Spindle& s) RT_SAFE { return s.is_settled(); })) {
        return false;
      }
      break;
    case Activity::brakes:
      if (activity_cycles_-- > 0) return false;
      set_axes(item_.axes, item_.kind == ItemKind::join_axes);
      break;
    case Activity::request:
    case Activity::stop:
      return false;
  }
  activity_ = Activity::none;
  return true;
}

void Channel::wait(Activity activity, double seconds) RT_SAFE {
  activity_ = activity;
  activity_began_ = cycle_;
  activity_cycles_ = ceiling(seconds / figures_.cycle_s - dwell_rounding);
}

void Channel::execute(const Item& item, std::int64_t cycle) RT_SAFE {
  switch (item.kind) {
    case ItemKind::load_done:
      load_ = item.flag ? Outcome::succeeded : Outcome::failed;
      text_ = item.text;
      has_program_ = has_program_ || item.flag;
      if (item.flag && state_ == ChannelState::idle) state_ = ChannelState::ready;
      break;
    case ItemKind::run_end:
      end_run(true, static_cast<std::uint64_t>(item.number), cycle);
      if (item.flag)
        emit(cycle, "W2099", "M99 in the main program ends the simulated run", item.tag);
      break;
    case ItemKind::run_failed:
      end_run(false, static_cast<std::uint64_t>(item.number), cycle);
      raise_alarm(item.code.view(), item.text.view(), item.tag);
      break;
    case ItemKind::reset_done:
      break;  // an answer to a reset that is over
    case ItemKind::transform:
      // The axes stand for one cycle in the new frame, so that every trace begins where they are.
      transform_ = *item.transform;
      interpolator_.stand_at(axes_M(), transform_);
      wait(Activity::frame, 0.0);
      break;
    case ItemKind::dwell:
      wait(Activity::dwell, item.value);
      break;
    case ItemKind::spindle:
      for (Spindle& spindle : spindles_) {
        const int wanted = item.spindle.spindle;
        const bool is_master = &spindle == spindles_.data();
        if (wanted == spindle.id() || wanted < 0 || (wanted == 0 && is_master))
          spindle.command(item.spindle);
      }
      wait(Activity::spindle, 0.0);
      break;
    case ItemKind::coolant:
    case ItemKind::tool_change:
      break;
    case ItemKind::override_control:
      take_overrides(item.overrides);
      break;
    case ItemKind::output:
      if (item.flag) {
        books_.outputs->analog[static_cast<std::size_t>(item.number)] = item.value;
      } else {
        books_.outputs->set(static_cast<int>(item.number), item.value != 0.0);
      }
      break;
    case ItemKind::machine_function:
      emit(cycle, "", item.text.view(), item.tag);
      break;
    case ItemKind::program_stop:
      if (item.number == static_cast<std::int64_t>(lang::StopKind::optional_stop)) {
        if (optional_stop_) hold(HoldCause::program_stop);
        break;
      }
      if (figures_.stops_go_on) {
        emit(cycle, "", "program stop: going on at once", item.tag);
        break;
      }
      hold(HoldCause::program_stop);
      break;
    case ItemKind::request:
      activity_ = Activity::request;
      break;
    case ItemKind::park_axes:
    case ItemKind::join_axes: {
      double seconds = 0.0;
      for (std::size_t k = 0; k < motion::axes_max; ++k) {
        if ((item.axes >> k & 1U) == 0) continue;
        seconds = std::max(seconds, figures_.axes[k].brake_s + figures_.axes[k].power_s);
        if (item.kind == ItemKind::park_axes) drives_[k].brake_closed = true;
        if (item.kind == ItemKind::join_axes) drives_[k].enabled = true;
      }
      wait(Activity::brakes, seconds);
      break;
    }
    case ItemKind::scheme_set:
      scheme_ = static_cast<int>(item.number);
      transform_ = {};
      transform_.scheme = find_scheme(scheme_);
      interpolator_.stand_at(axes_M(), transform_);
      break;
    case ItemKind::switch_done:
      switch_ = Outcome::succeeded;
      break;
    case ItemKind::switch_failed:
      switch_ = Outcome::failed;
      text_ = item.text;
      break;
  }
}

// Chunks that may be entered now: those before the next item, and none while an item is at work.
std::uint64_t Channel::chunk_limit(std::uint64_t available) const RT_SAFE {
  if (activity_ != Activity::none) return path_.chunks_done;
  if (link_.items.empty()) return available;
  return std::min(available, link_.items.front().after_chunk);
}

void Channel::move() RT_SAFE {
  // Read before the items: a chunk seen here was pushed after the items that precede it.
  const std::uint64_t available = link_.path.chunks.pushed();
  const std::uint64_t limit = chunk_limit(available);
  motion::FeedControl control = control_;
  if (!overrides_.feed_enabled) control.feed_override = 1.0;
  control.closed_from_block = closed_from_block();
  if (!link_.path.chunks.empty())
    lookahead_max_ = std::max(lookahead_max_, link_.path.chunks.front().lookahead_blocks);
  interpolator_.advance(link_.path, control, path_, limit);
  path_mm_ += path_.path_advanced;
  blocks_ = std::max(blocks_, path_.tag.run == run_ ? path_.tag.block : 0);
  for (int k = 0; k < figures_.axis_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    AxisSetpoint& setpoint = setpoints_[i];
    const AxisFigures& axis = figures_.axes[i];
    const kinematics::Jet& jet = path_.axes[i];
    setpoint.velocity_code =
        nearest_integer((jet.value - setpoint.position) / axis.resolution * axis.kmv);
    setpoint.position = jet.value;
    setpoint.velocity = jet.first;
    setpoint.acceleration = jet.second;
    setpoint.jerk = jet.third;
    setpoint.position_code = nearest_integer(jet.value / axis.resolution);
  }
}

void Channel::show_remarks(std::int64_t cycle) RT_SAFE {
  for (int n = 0; n < remarks_per_cycle && !link_.remarks.empty(); ++n) {
    const Remark& remark = link_.remarks.front();
    const bool passed = path_.tag.run == remark.tag.run && path_.tag.block >= remark.tag.block;
    const bool stands = interpolator_.at_rest() && link_.path.chunks.empty();
    if (!passed && !stands) return;
    emit(cycle, remark.kind == lang::Message::Kind::warning ? "W0001" : "", remark.text.view(),
         remark.tag);
    link_.remarks.pop_front();
  }
}

void Channel::fill(ChannelOutput& output) const RT_SAFE {
  output.id = figures_.id;
  output.axis_count = figures_.axis_count;
  output.state = state_;
  output.moving = path_.state == motion::PathState::moving;
  output.running = running_;
  output.run = run_;
  output.waiting = (activity_ != Activity::none && activity_ != Activity::frame) || at_soft_mark_;
  output.hold_cause = state_ == ChannelState::held ? hold_cause_ : HoldCause::none;
  output.scheme = scheme_;
  output.tag = running_ ? path_.tag : motion::BlockTag{};
  output.feed_commanded = path_.feed_commanded;
  output.path_speed = path_.s_speed;
  output.feed_override = control_.feed_override;
  output.point_W = path_.point;
  output.axes = setpoints_;
  output.drives = drives_;
}

void Channel::begin_load(const ShortText& program) RT_SAFE {
  load_ = Outcome::pending;
  Notice notice;
  notice.kind = NoticeKind::load;
  notice.text = ReasonText(program.view());
  static_cast<void>(link_.notices.push(notice));
}

void Channel::begin_run() RT_SAFE {
  ++run_;
  run_before_ok_ = run_ok_;
  running_ = true;
  run_ok_ = false;
  was_reset_ = false;
  marks_ = {};
  state_ = ChannelState::running;
  control_.hold = false;
  start_cycle_ = cycle_;
  path_mm_ = 0.0;
  lookahead_max_ = 0;
  blocks_ = 0;
  Notice notice;
  notice.kind = NoticeKind::start;
  notice.run = run_;
  notice.number = scheme_;
  notice.block_skip = block_skip_;
  notice.axes_M = axes_M();
  static_cast<void>(link_.notices.push(notice));
  static_cast<void>(books_.reports->run_records().push(run_record()));
}

RunRecord Channel::run_record() const RT_SAFE {
  RunRecord record;
  record.channel = figures_.id;
  record.run = run_;
  record.start_cycle = start_cycle_;
  record.end_cycle = cycle_;
  record.path_mm = path_mm_;
  record.lookahead_max_blocks = lookahead_max_;
  record.blocks = blocks_;
  record.axis_count = figures_.axis_count;
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    record.end_W[k] = path_.point[k].value;
    record.end_M[k] = path_.axes[k].value;
  }
  return record;
}

void Channel::end_run(bool ok, std::uint64_t blocks, std::int64_t cycle) RT_SAFE {
  if (!running_) return;
  running_ = false;
  run_ok_ = ok;
  end_cycle_ = cycle;
  take_overrides({});
  hold_wanted_ = false;
  control_.hold = false;
  state_ = ChannelState::ready;
  for (Spindle& spindle : spindles_) spindle.stop();
  RunRecord record = run_record();
  record.ended = true;
  record.ok = ok;
  record.blocks = blocks;
  record.end_cycle = cycle;
  static_cast<void>(books_.reports->run_records().push(record));
}

void Channel::hold(HoldCause cause) RT_SAFE {
  if (!running_) return;
  hold_cause_ = cause;
  control_.hold = true;
  state_ = ChannelState::held;
}

void Channel::resume() RT_SAFE {
  if (state_ != ChannelState::held) return;
  control_.hold = false;
  state_ = ChannelState::running;
}

void Channel::begin_reset() RT_SAFE {
  alarm_stays_ = false;
  if (resetting_) return;
  resetting_ = true;
  reset_sent_ = false;
  control_.hold = true;
}

// First to rest along the path, then the preparation is told to forget, then what it had pushed is
// dropped.
void Channel::continue_reset() RT_SAFE {
  if (!interpolator_.at_rest()) return;
  if (!reset_sent_) {
    Notice notice;
    notice.kind = NoticeKind::reset;
    reset_sent_ = link_.notices.push(notice);
    activity_ = Activity::none;
    return;
  }
  Item item;
  while (link_.items.pop(item)) {
    if (item.kind != ItemKind::reset_done) continue;
    interpolator_.drop_path(link_.path);
    forget_riders();
    link_.remarks.pop_front(link_.remarks.size());
    end_run(false, blocks_, cycle_);
    resetting_ = false;
    was_reset_ = true;
    control_.hold = false;
    load_ = load_ == Outcome::pending ? Outcome::failed : load_;
    switch_ = switch_ == Outcome::pending ? Outcome::failed : switch_;
    state_ = has_program_ ? ChannelState::ready : ChannelState::idle;
    if (alarm_stays_) state_ = ChannelState::alarm;
    alarm_stays_ = false;
    transform_ = {};
    transform_.scheme = find_scheme(scheme_);
    interpolator_.stand_at(axes_M(), transform_);
    return;
  }
}

void Channel::answer(const ChannelAnswer& answer) RT_SAFE {
  if (activity_ != Activity::request) return;
  activity_ = Activity::none;
  Notice notice;
  notice.kind = NoticeKind::answer;
  notice.block_skip = block_skip_;
  notice.ok = answer.ok;
  notice.raises = answer.raises;
  notice.value = answer.value;
  notice.code = answer.code;
  notice.text = answer.text;
  notice.axes_M = axes_M();
  static_cast<void>(link_.notices.push(notice));
}

void Channel::raise_alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  state_ = ChannelState::alarm;
  run_ok_ = false;
  AlarmRecord record;
  record.channel = figures_.id;
  record.cycle = cycle_;
  record.tag = tag;
  record.code = FixedText<8>(code);
  record.text = FixedText<1024>(text);
  record.file = file_name(tag);
  last_alarm_ = {run_, tag.line, record.code, record.file};
  static_cast<void>(books_.reports->alarm_records().push(record));
  emit(cycle_, code, text.substr(0, text.find('\n')), tag);
}

// The program at fault stops along its path and is over; the alarm stays until reset.
void Channel::fail_run(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  if (alarm_stays_) return;
  raise_alarm(code, text, tag);
  begin_reset();
  alarm_stays_ = true;
}

const FileName& Channel::file_name(const motion::BlockTag& tag) const RT_SAFE {
  return link_.file_names[std::min<std::size_t>(tag.file, link_.file_names.size() - 1)];
}

bool Channel::ended_well(std::uint32_t run) const RT_SAFE {
  return run == run_ ? run_ok_ : run + 1 == run_ && run_before_ok_;
}

bool Channel::is_quiet() const RT_SAFE {
  return !running_ && !resetting_ && interpolator_.at_rest() && activity_ == Activity::none &&
         link_.items.empty() && link_.riders.empty() && link_.notices.empty() &&
         load_ != Outcome::pending && switch_ != Outcome::pending;
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

motion::Point Channel::axes_M() const RT_SAFE {
  motion::Point point{};
  for (std::size_t k = 0; k < motion::axes_max; ++k) point[k] = path_.axes[k].value;
  return point;
}

}  // namespace stanok::channels

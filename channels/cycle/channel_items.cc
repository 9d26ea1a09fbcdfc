// Items of the program in the cycle: executed in their order, each when the path before it is done.
#include <algorithm>

#include "base/numeric.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

constexpr int items_per_cycle = 16;  // bound of work
constexpr double drives_obey_within_s = 3.0;
constexpr double dwell_rounding = 1e-9;  // cycles; a dwell of whole cycles stays whole

// What a program brings about, as opposed to what its load, reset or switch needs.
bool is_of_program(ItemKind kind) RT_SAFE {
  switch (kind) {
    case ItemKind::dwell:
    case ItemKind::spindle:
    case ItemKind::cutting_speed:
    case ItemKind::coolant:
    case ItemKind::tool_change:
    case ItemKind::override_control:
    case ItemKind::force_control:
    case ItemKind::output:
    case ItemKind::machine_function:
    case ItemKind::program_stop:
    case ItemKind::probe:
    case ItemKind::request:
    case ItemKind::run_end:
      return true;
    default:
      return false;
  }
}

}  // namespace

// Items in program order, each when the path before it is done and the axes stand.
void Channel::work_items() RT_SAFE {
  for (int n = 0; n < items_per_cycle; ++n) {
    if (resetting_ || (state_ == ChannelState::held && running_)) return;
    if (stops_where_preparation_broke_off()) return;
    if (!finish_activity()) return;
    if (link_.items.empty() || !interpolator_.at_rest()) return;
    if (path_.chunks_done < link_.items.front().after_chunk) return;
    if (link_.riders.popped() < link_.items.front().after_rider) return;
    const Item& next = link_.items.front();
    if (is_of_program(next.kind) && !stepper_.admits(next.tag)) {
      return hold(HoldCause::single_block);
    }
    static_cast<void>(link_.items.pop(item_));
    execute(item_);
  }
}

// The path that comes before may never be complete: the axes stop along what there is of it.
bool Channel::stops_where_preparation_broke_off() RT_SAFE {
  if (link_.items.empty() || link_.items.front().kind != ItemKind::broken_off) return false;
  static_cast<void>(link_.items.pop(item_));
  fail_run(item_.code.view(), item_.text.view(), item_.tag);
  return true;
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
      // With force control, the feed waits for the power of the idle spindle, too.
      if (figures_.feed_modifier != nullptr && !figures_.feed_modifier->is_ready()) return false;
      break;
    case Activity::brakes:
      if (activity_cycles_-- > 0) return false;
      if (const int axis = disobedient_axis(); axis >= 0) {
        const auto waited = static_cast<double>(cycle_ - activity_began_) * figures_.cycle_s;
        if (waited >= drives_obey_within_s) fail_switch(axis);
        return false;
      }
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
  constexpr double cycles_max = 1e15;  // for ever, and exact
  activity_cycles_ = ceiling(std::min(seconds / figures_.cycle_s - dwell_rounding, cycles_max));
}

void Channel::execute(const Item& item) RT_SAFE {
  switch (item.kind) {
    case ItemKind::load_done:
      return take_load(item);
    case ItemKind::run_end:
      end_run(true, static_cast<std::uint64_t>(item.number));
      if (item.flag)
        emit(cycle_, "W2099", "M99 in the main program ends the simulated run", item.tag);
      return;
    case ItemKind::line_end:
      return close_run(true, static_cast<std::uint64_t>(item.number));
    case ItemKind::run_failed:
      end_run(false, static_cast<std::uint64_t>(item.number));
      return raise_alarm(item.code.view(), item.text.view(), item.tag);
    case ItemKind::broken_off:
    case ItemKind::reset_done:
      return;  // told before; an answer to a reset that is over
    case ItemKind::transform:
      // The axes stand for one cycle in the new frame, so that every trace begins where they are.
      transform_ = *item.transform;
      stand_in_frame();
      return wait(Activity::frame, 0.0);
    case ItemKind::dwell:
      return wait(Activity::dwell, item.value);
    case ItemKind::spindle:
      return command_spindles(item.spindle);
    case ItemKind::cutting_speed:
      return command_cutting_speed(item.cutting);
    case ItemKind::tool_change:
      tool_ = {static_cast<std::int32_t>(item.number), static_cast<std::int32_t>(item.value)};
      return;
    case ItemKind::coolant:
      return;
    case ItemKind::override_control:
      return take_overrides(item.overrides);
    case ItemKind::force_control:
      return order_force(item);
    case ItemKind::output:
      return set_output(item);
    case ItemKind::machine_function:
      return emit(cycle_, "", item.text.view(), item.tag);
    case ItemKind::program_stop:
      return stop_by_program(item);
    case ItemKind::probe:
      return begin_probing(item);
    case ItemKind::request:
      asked_ = item;
      asks_ = true;
      activity_ = Activity::request;
      if (item.request.kind == lang::RequestKind::probe_result) answer_probing();
      return;
    case ItemKind::park_axes:
    case ItemKind::join_axes:
      return begin_brakes(item);
    case ItemKind::scheme_set:
      scheme_ = static_cast<int>(item.number);
      transform_ = {};
      transform_.scheme = find_scheme(scheme_);
      return stand_in_frame();
    case ItemKind::switch_done:
      switch_ = Outcome::succeeded;
      return;
    case ItemKind::switch_failed:
      switch_ = Outcome::failed;
      switch_fault_ = item.code;
      text_ = item.text;
      return;
  }
}

void Channel::take_load(const Item& item) RT_SAFE {
  load_ = item.flag ? Outcome::succeeded : Outcome::failed;
  text_ = item.text;
  if (!item.flag || loading_ != Job::program) return;
  has_program_ = true;
  program_load_ = static_cast<std::int32_t>(item.number);
  if (state_ == ChannelState::idle) state_ = ChannelState::ready;
}

void Channel::command_spindles(const lang::SpindleCommand& command) RT_SAFE {
  for (Spindle& spindle : spindles_) {
    const bool is_master = &spindle == spindles_.data();
    const bool is_meant = command.spindle == spindle.id() || command.spindle < 0 ||
                          (command.spindle == 0 && is_master);
    if (is_meant) spindle.command(command);
  }
  follow_process();
  wait(Activity::spindle, 0.0);
}

void Channel::command_cutting_speed(const lang::CuttingSpeedMode& mode) RT_SAFE {
  for (Spindle& spindle : spindles_) {
    const bool is_master = &spindle == spindles_.data();
    const bool is_meant = mode.spindle == spindle.id() || (mode.spindle == 0 && is_master);
    if (is_meant) spindle.command(mode);
  }
  follow_process();
  wait(Activity::spindle, 0.0);
}

void Channel::set_output(const Item& item) RT_SAFE {
  if (item.flag) {
    books_.outputs->analog[static_cast<std::size_t>(item.number)] = item.value;
  } else {
    books_.outputs->set(static_cast<int>(item.number), item.value != 0.0);
  }
}

void Channel::stop_by_program(const Item& item) RT_SAFE {
  const bool is_optional = item.number == static_cast<std::int64_t>(lang::StopKind::optional_stop);
  if (is_optional && !optional_stop_) return;
  if (!is_optional && figures_.stops_go_on) {
    return emit(cycle_, "", "program stop: going on at once", item.tag);
  }
  hold(HoldCause::program_stop);
}

}  // namespace stanok::channels

#include "channels/cycle/item_worker.h"

#include <algorithm>

#include "base/numeric.h"
#include "channels/cycle/force_terms.h"

namespace stanok::channels {
namespace {

constexpr int items_per_cycle = 16;  // bound of work
constexpr double drives_obey_within_s = 3.0;

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

ItemWorker::ItemWorker(CycleParts& parts)
    : parts_(parts),
      loads_(parts.run, parts.link),
      change_(parts.axes, parts.drives, parts.motion, parts.run, parts.link),
      probe_(parts.figures.probe_input, *parts.books.inputs, parts.drives, parts.motion) {}

void ItemWorker::advance() RT_SAFE {
  Ring<Item>& items = parts_.link.items;
  const RunState& state = parts_.run.state();
  for (int n = 0; n < items_per_cycle; ++n) {
    if (state.is_ending() || state.situation() == Situation::held) return;
    if (stops_where_preparation_broke_off()) return;
    if (!finish_activity()) return;
    if (items.empty() || !parts_.motion.path_is_at_rest()) return;
    const Item& next = items.front();
    if (parts_.motion.path().chunks_done < next.after_chunk) return;
    if (parts_.link.riders.popped() < next.after_rider) return;
    if (is_of_program(next.kind) && !parts_.run.stepper().admits(next.tag))
      return parts_.run.hold(HoldCause::single_block);
    static_cast<void>(items.pop(item_));
    execute(item_);
  }
}

// The path that comes before may never be complete: the axes stop along what there is of it.
bool ItemWorker::stops_where_preparation_broke_off() RT_SAFE {
  Ring<Item>& items = parts_.link.items;
  if (items.empty() || items.front().kind != ItemKind::broken_off) return false;
  static_cast<void>(items.pop(item_));
  parts_.run.fail(item_.code.view(), item_.text.view(), item_.tag);
  return true;
}

// True when nothing keeps the channel from its next item.
bool ItemWorker::finish_activity() RT_SAFE {
  switch (activity_) {
    case Activity::none:
      return true;
    case Activity::frame:
      if (began_ == parts_.runs.cycle()) return false;
      break;
    case Activity::dwell:
      if (cycles_left_-- > 0) return false;
      break;
    case Activity::spindle:
      // With force control, the feed waits for the power of the idle spindle, too.
      if (!parts_.spindles.are_settled() || !parts_.process.is_ready()) return false;
      break;
    case Activity::brakes:
      if (!finish_brakes()) return false;
      break;
    case Activity::request:
      return false;
  }
  activity_ = Activity::none;
  return true;
}

bool ItemWorker::finish_brakes() RT_SAFE {
  if (cycles_left_-- > 0) return false;
  const int axis = change_.disobedient_axis(item_);
  if (axis < 0) {
    change_.finish_step(item_);
    return true;
  }
  const double waited = static_cast<double>(parts_.runs.cycle() - began_) * parts_.figures.cycle_s;
  if (waited < drives_obey_within_s) return false;
  activity_ = Activity::none;
  change_.fail(item_, axis);
  return false;
}

void ItemWorker::wait(Activity activity, double seconds) RT_SAFE {
  constexpr double rounding = 1e-9;    // cycles; a dwell of whole cycles stays whole
  constexpr double cycles_max = 1e15;  // for ever, and exact
  activity_ = activity;
  began_ = parts_.runs.cycle();
  cycles_left_ = ceiling(std::min(seconds / parts_.figures.cycle_s - rounding, cycles_max));
}

void ItemWorker::execute(const Item& item) RT_SAFE {
  switch (item.kind) {
    case ItemKind::load_done:
      return loads_.take(item);
    case ItemKind::run_end:
      return end_run(item);
    case ItemKind::line_end:
      // Spindles and overrides stay as they are.
      return parts_.run.end_run(RunResult::succeeded, static_cast<std::uint64_t>(item.number));
    case ItemKind::run_failed:
      return fail_run(item);
    case ItemKind::broken_off:
    case ItemKind::reset_done:
    case ItemKind::coolant:
      return;  // told before; an answer to a reset that is over; no effect on motion
    case ItemKind::transform:
      // The axes stand for one cycle in the new frame, so that every trace begins where they are.
      parts_.motion.stand_in(*item.transform);
      return wait(Activity::frame, 0.0);
    case ItemKind::dwell:
      return wait(Activity::dwell, item.value);
    case ItemKind::spindle:
      parts_.spindles.command(item.spindle);
      return wait_for_spindles();
    case ItemKind::cutting_speed:
      parts_.spindles.command(item.cutting);
      return wait_for_spindles();
    case ItemKind::tool_change:
      tool_ = {static_cast<std::int32_t>(item.number), static_cast<std::int32_t>(item.value)};
      return;
    case ItemKind::override_control:
      return parts_.switches.admit(item.overrides);
    case ItemKind::force_control:
      return order_force(item);
    case ItemKind::output:
      return set_output(item);
    case ItemKind::machine_function:
      return parts_.log.tell("", item.text.view(), item.tag);
    case ItemKind::program_stop:
      return stop_by_program(item);
    case ItemKind::probe:
      return begin_probing(item);
    case ItemKind::request:
      return begin_request(item);
    case ItemKind::park_axes:
    case ItemKind::join_axes:
      return wait(Activity::brakes, change_.begin_step(item));
    case ItemKind::scheme_set:
      return parts_.motion.select_scheme(static_cast<int>(item.number));
    case ItemKind::switch_done:
      return change_.succeed();
    case ItemKind::switch_failed:
      return change_.refuse(item.code.view(), item.text.view());
  }
}

void ItemWorker::end_run(const Item& item) RT_SAFE {
  if (parts_.run.state().is_running()) {
    end_effects();
    parts_.run.end_run(RunResult::succeeded, static_cast<std::uint64_t>(item.number));
  }
  if (item.flag)
    parts_.log.tell("W2099", "M99 in the main program ends the simulated run", item.tag);
}

void ItemWorker::fail_run(const Item& item) RT_SAFE {
  if (parts_.run.state().is_running()) {
    end_effects();
    parts_.run.end_run(RunResult::failed, static_cast<std::uint64_t>(item.number));
  }
  parts_.run.raise_alarm(item.code.view(), item.text.view(), item.tag);
}

// What programs and lines brought about is over with a program, and with a reset.
void ItemWorker::end_effects() RT_SAFE {
  parts_.switches.admit({});
  parts_.motion.interrupt_feed({});
  static_cast<void>(parts_.process.order(motion::ForceOrder{}));
  parts_.spindles.stop();
  parts_.spindles.open_position_loops();
}

void ItemWorker::end_all() RT_SAFE {
  probe_.end();
  end_effects();
  loads_.end();
  if (change_.is_pending()) change_.end();
}

void ItemWorker::order_force(const Item& item) RT_SAFE {
  if (!parts_.process.order(order_of(item.force))) {
    return parts_.run.fail("E6062", "the order does not fit the force control of the channel",
                           item.tag);
  }
  wait_for_spindles();
}

void ItemWorker::set_output(const Item& item) RT_SAFE {
  Signals& outputs = *parts_.books.outputs;
  if (item.flag) {
    outputs.analog[static_cast<std::size_t>(item.number)] = item.value;
  } else {
    outputs.set(static_cast<int>(item.number), item.value != 0.0);
  }
}

void ItemWorker::stop_by_program(const Item& item) RT_SAFE {
  const bool is_optional = item.number == static_cast<std::int64_t>(lang::StopKind::optional_stop);
  if (is_optional && !parts_.switches.optional_stop()) return;
  if (!is_optional && parts_.figures.stops_go_on)
    return parts_.log.tell("", "program stop: going on at once", item.tag);
  parts_.run.hold(HoldCause::program_stop);
}

void ItemWorker::begin_probing(const Item& item) RT_SAFE {
  const bool alarms = item.number != 0;
  if (probe_.begin(item) || !alarms) return;
  parts_.run.fail("E4322",
                  probe_.until_contact() ? "the probe touches before the move"
                                         : "the probe is free before the move",
                  item.tag);
}

void ItemWorker::begin_request(const Item& item) RT_SAFE {
  request_ = item;
  activity_ = Activity::request;
  if (item.request.kind == lang::RequestKind::probe_result) answer(probe_.take_answer());
}

void ItemWorker::answer(const ChannelAnswer& answer) RT_SAFE {
  if (!request_) return;
  request_.reset();
  activity_ = Activity::none;
  parts_.link.tell(RequestAnswer{.answer = answer,
                                 .block_skip = parts_.switches.block_skip(),
                                 .axes_M = parts_.motion.axes_M()});
}

void ItemWorker::give_up() RT_SAFE {
  activity_ = Activity::none;
  request_.reset();
}

bool ItemWorker::drop_until_reset_done() RT_SAFE {
  Item item;
  while (parts_.link.items.pop(item)) {
    if (item.kind == ItemKind::reset_done) return true;
  }
  return false;
}

RunStart ItemWorker::run_start() const RT_SAFE {
  return {.run = parts_.runs.run(),
          .load = loads_.program(),
          .scheme = parts_.schemes.active_id(),
          .block_skip = parts_.switches.block_skip(),
          .axes_M = parts_.motion.axes_M()};
}

void ItemWorker::begin_search(const ShortText& target, SearchWay way, double pass) RT_SAFE {
  loads_.begin_search({.start = run_start(),
                       .way = way,
                       .passes = static_cast<std::int32_t>(std::max(1.0, pass)),
                       .target = target});
}

void ItemWorker::begin_run(Job job) RT_SAFE {
  if (job == Job::program) {
    parts_.marks.clear_marks();
    parts_.spindles.open_position_loops();
    parts_.process.restart_laws();
  }
  parts_.run.begin_run();
  if (job == Job::line) return parts_.link.tell(LineStart{run_start()});
  parts_.link.tell(ProgramStart{run_start()});
}

void ItemWorker::begin_switch(int scheme) RT_SAFE {
  // Asked for by the own program: the steps of the switch come before the answer.
  if (activity_ == Activity::request) activity_ = Activity::none;
  change_.begin(scheme);
}

const motion::BlockTag& ItemWorker::current_tag() const RT_SAFE {
  const bool is_beside = activity_ != Activity::none && item_.tag.run == parts_.runs.run();
  return is_beside ? item_.tag : parts_.motion.path().tag;
}

std::uint64_t ItemWorker::chunk_limit() const RT_SAFE {
  const std::uint64_t available = parts_.link.path.chunks.shown();
  if (activity_ != Activity::none) return parts_.motion.path().chunks_done;
  if (parts_.link.items.empty()) return available;
  return std::min(available, parts_.link.items.front().after_chunk);
}

std::uint64_t ItemWorker::riders_before_item() const RT_SAFE {
  const Ring<Item>& items = parts_.link.items;
  if (items.empty() || !is_idle() || !parts_.motion.path_is_at_rest()) return 0;
  const bool is_next = parts_.motion.path().chunks_done >= items.front().after_chunk;
  return is_next ? items.front().after_rider : 0;
}

}  // namespace stanok::channels

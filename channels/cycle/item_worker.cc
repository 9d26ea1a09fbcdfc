#include "channels/cycle/item_worker.h"

#include <algorithm>

#include "base/numeric.h"
#include "base/visit_in_cycle.h"
#include "channels/cycle/force_terms.h"

namespace stanok::channels {
namespace {

constexpr std::uint32_t only(std::int32_t channel) RT_SAFE {
  return channel >= 0 && channel < 32 ? 1U << static_cast<unsigned>(channel) : 0U;
}

Wait wait_of(const Request& request) RT_SAFE {
  if (const auto* end = std::get_if<requests::EndWait>(&request))
    return {.cause = WaitCause::end, .channels = only(end->channel)};
  if (const auto* mark = std::get_if<requests::MarkWait>(&request))
    return {.cause = WaitCause::mark, .number = mark->mark, .channels = mark->channels};
  if (const auto* input = std::get_if<requests::InputWait>(&request))
    return {.cause = WaitCause::input, .number = input->input};
  if (const auto* run = std::get_if<requests::ProgramRun>(&request))
    return {.cause = WaitCause::channel, .channels = only(run->channel)};
  if (const auto* load = std::get_if<requests::ProgramLoad>(&request))
    return {.cause = WaitCause::channel, .channels = only(load->channel)};
  if (const auto* scheme = std::get_if<requests::KinematicsSelect>(&request))
    return {.cause = WaitCause::channel, .channels = only(scheme->channel)};
  return {.cause = WaitCause::machine};
}

constexpr int items_per_cycle = 16;  // bound of work
constexpr double drives_obey_within_s = 3.0;

// What a program brings about, as opposed to what its load, reset or switch needs.
bool is_of_program(const ItemContent& content) RT_SAFE {
  return holds_one_of<lang::Dwell, lang::SpindleCommand, lang::CuttingSpeedMode,
                      lang::CoolantCommand, lang::ToolChange, lang::OverrideControl,
                      lang::ForceControl, lang::OutputCommand, lang::MachineFunction,
                      lang::ProgramStop, ProbeBegin, Request, RunEnd>(content);
}

// The axes may go back along the path before it: nothing but their frame, time and overrides.
bool can_be_undone(const Item& item) RT_SAFE {
  return !holds_one_of<lang::SpindleCommand, lang::CuttingSpeedMode, lang::CoolantCommand,
                       lang::ToolChange, lang::ForceControl, lang::OutputCommand,
                       lang::MachineFunction, ProbeBegin, Request, AxesStep, SchemeChosen>(
      item.content);
}

// In single block; frames and the like take effect with the step behind them, so that a stop shows
// the block that was done and not the next one.
bool may_begin(const Item& item, Stepper& stepper) RT_SAFE {
  return is_of_program(item.content) ? stepper.admits(item.tag) : stepper.lets_through(item.tag);
}

}  // namespace

struct ItemWorker::Execution {
  ItemWorker& worker;
  CycleParts& parts;
  const motion::BlockTag& tag;

  void operator()(const LoadDone& load) const RT_SAFE {
    worker.loads_.take(load);
    if (!parts.constants.first_run || !load.succeeded || load.number == 0) return;
    parts.switches.set_first_part(worker.loads_.has_run_before() ? Switch::off : Switch::on);
  }
  void operator()(const RunEnd& end) const RT_SAFE {
    worker.end_run(RunResult::succeeded, end.blocks);
    if (worker.loads_.runs_whole()) {
      worker.loads_.note_end();
      if (parts.constants.first_run) parts.switches.set_first_part(Switch::off);
    }
    worker.rest(end.rest);
    if (end.is_restart)
      parts.log.tell("W2099", "M99 in the main program ends the simulated run", tag);
  }
  // Spindles and overrides stay as they are.
  void operator()(const LineEnd& end) const RT_SAFE {
    parts.run.end_run(RunResult::succeeded, end.blocks);
    worker.rest(end.rest);
  }
  void operator()(const RunFailed& failed) const RT_SAFE {
    worker.end_run(RunResult::failed, failed.blocks);
    worker.rest(failed.rest);
    parts.run.raise_alarm(failed.code.view(), failed.text.view(), tag);
  }
  // Told before.
  void operator()(const BrokenOff& /*end*/) const RT_SAFE {}
  // An answer to a reset that is over.
  void operator()(const ResetDone& /*reset*/) const RT_SAFE {}
  void operator()(const Settled& settled) const RT_SAFE {
    worker.rest(settled.rest);
    worker.settling_.finish();
  }
  // The axes stand for one cycle in the new frame, so that every trace begins where they are. Where
  // a length was changed in a hold behind which this was prepared, an operator leads them to the
  // path.
  void operator()(const TransformSet& set) const RT_SAFE {
    worker.wait(Activity::frame, 0.0);
    if (parts.motion.go_on_in(*set.transform, set.start) == PathStart::at_axes) return;
    parts.run.hold(HoldCause::changed_length);
    parts.run.apply(Change::path_left);
  }
  void operator()(const lang::Dwell& dwell) const RT_SAFE {
    worker.wait(Activity::dwell, dwell.seconds);
  }
  void operator()(const lang::SpindleCommand& command) const RT_SAFE {
    parts.spindles.command(command);
    worker.wait_for_spindles();
  }
  void operator()(const lang::CuttingSpeedMode& mode) const RT_SAFE {
    parts.spindles.command(mode);
    worker.wait_for_spindles();
  }
  void operator()(const lang::CoolantCommand& coolant) const RT_SAFE { worker.coolant_ = coolant; }
  void operator()(const lang::ToolChange& change) const RT_SAFE {
    worker.tool_ = {change.tool, change.edge};
  }
  void operator()(const lang::OverrideControl& control) const RT_SAFE {
    parts.switches.admit(control);
  }
  void operator()(const lang::ForceControl& control) const RT_SAFE {
    if (!parts.process.command(command_of(control))) {
      return parts.run.fail(
          "E6062", "the command is not possible in the present state of force control", tag);
    }
    worker.wait_for_spindles();
  }
  void operator()(const lang::OutputCommand& output) const RT_SAFE {
    Signals& outputs = *parts.books.outputs;
    if (output.analog) {
      outputs.analog[output.number] = output.value;
    } else {
      outputs.set(output.number, output.value != 0.0);
    }
  }
  void operator()(const lang::MachineFunction& function) const RT_SAFE {
    parts.log.tell("", ShortText("M").append(function.code).view(), tag);
  }
  void operator()(const lang::ProgramStop& stop) const RT_SAFE {
    const bool is_optional = stop.kind == lang::StopKind::optional_stop;
    if (is_optional && !parts.switches.optional_stop()) return;
    if (!is_optional && parts.constants.stops_go_on)
      return parts.log.tell("", "program stop: continues immediately", tag);
    parts.run.hold(HoldCause::program_stop);
  }
  void operator()(const ProbeBegin& probe) const RT_SAFE {
    if (worker.probe_.begin(probe) || !probe.alarm_when_missed) return;
    parts.run.fail("E4322",
                   probe.until_contact ? "the probe is in contact before the move"
                                       : "the probe is not in contact before the move",
                   tag);
  }
  void operator()(const Request& request) const RT_SAFE {
    worker.request_ = OpenRequest{tag, request};
    worker.activity_ = Activity::request;
    if (std::holds_alternative<requests::ProbeResult>(request))
      worker.answer(worker.probe_.take_answer());
  }
  void operator()(const AxesStep& step) const RT_SAFE {
    worker.wait(Activity::brakes, worker.change_.begin_step(step));
  }
  void operator()(const SchemeChosen& chosen) const RT_SAFE {
    parts.motion.select_scheme(chosen.scheme);
  }
  void operator()(const SwitchDone& /*end*/) const RT_SAFE {
    worker.settling_.want({});
    worker.change_.succeed();
  }
  void operator()(const SwitchFailed& failed) const RT_SAFE {
    worker.settling_.want({});
    worker.change_.refuse(failed.code.view(), failed.text.view());
  }
  void operator()(const TapOutEnd& end) const RT_SAFE {
    parts.spindles.tap().end_way_out(end.code, end.text);
  }
};

ItemWorker::ItemWorker(CycleParts& parts)
    : parts_(parts),
      loads_(parts.run, parts.link),
      change_(parts.axes, parts.drives, parts.motion, parts.run, parts.link),
      probe_(parts.constants, *parts.books.inputs, parts.drives, parts.motion),
      settling_(parts.link) {}

void ItemWorker::advance() RT_SAFE {
  Ring<Item>& items = parts_.link.items;
  const RunState& state = parts_.run.state();
  for (int n = 0; n < items_per_cycle; ++n) {
    if (state.is_ending() || state.is_held()) return;
    if (stops_where_preparation_broke_off()) return;
    if (!finish_activity()) return;
    if (items.empty() || !parts_.motion.path_is_at_rest()) return;
    const Item& next = items.front();
    if (parts_.motion.path().chunks_done < next.after_chunk) return;
    if (parts_.link.riders.popped() < next.after_rider) return;
    if (!may_begin(next, parts_.run.stepper())) return parts_.run.hold(HoldCause::single_block);
    static_cast<void>(items.pop(item_));
    if (item_.tag.line != 0 && item_.tag.run == parts_.runs.run()) now_ = item_.tag;
    if (!can_be_undone(item_)) parts_.motion.cut_history();
    visit_in_cycle(Execution{*this, parts_, item_.tag}, item_.content);
  }
}

bool ItemWorker::lets_axes_leave() const RT_SAFE {
  return activity_ != Activity::brakes && activity_ != Activity::request && !probe_.is_on();
}

Wait ItemWorker::waits_for() const RT_SAFE {
  switch (activity_) {
    case Activity::dwell:
      return {.cause = WaitCause::dwell};
    case Activity::spindle:
      return {.cause = WaitCause::spindle};
    case Activity::brakes:
      return {.cause = WaitCause::brakes};
    case Activity::request:
      return request_ ? wait_of(request_->content) : Wait{};
    case Activity::none:
    case Activity::frame:
      break;
  }
  return {};
}

// The path that comes before may never be complete: the axes stop along what there is of it.
bool ItemWorker::stops_where_preparation_broke_off() RT_SAFE {
  Ring<Item>& items = parts_.link.items;
  if (items.empty() || !std::holds_alternative<BrokenOff>(items.front().content)) return false;
  static_cast<void>(items.pop(item_));
  const auto* end = std::get_if<BrokenOff>(&item_.content);
  parts_.run.fail(end->code.view(), end->text.view(), item_.tag);
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
  const AxesStep& step = *std::get_if<AxesStep>(&item_.content);
  const int axis = change_.disobedient_axis(step);
  if (axis < 0) {
    change_.finish_step(step);
    return true;
  }
  const double waited =
      static_cast<double>(parts_.runs.cycle() - began_) * parts_.constants.cycle_s;
  if (waited < drives_obey_within_s) return false;
  activity_ = Activity::none;
  change_.fail(step, axis);
  return false;
}

void ItemWorker::wait(Activity activity, double seconds) RT_SAFE {
  constexpr double rounding = 1e-9;    // cycles; a dwell of whole cycles stays whole
  constexpr double cycles_max = 1e15;  // for ever, and exact
  activity_ = activity;
  began_ = parts_.runs.cycle();
  cycles_left_ = ceiling(std::min(seconds / parts_.constants.cycle_s - rounding, cycles_max));
}

void ItemWorker::end_run(RunResult result, std::uint64_t blocks) RT_SAFE {
  if (!parts_.run.state().is_running()) return;
  end_effects();
  parts_.run.end_run(result, blocks);
}

// What programs and lines brought about is over with a program, and with a reset.
void ItemWorker::end_effects() RT_SAFE {
  coolant_ = {};
  parts_.switches.admit({});
  parts_.switches.end_interlude();
  parts_.motion.interrupt_feed({});
  static_cast<void>(parts_.process.command(motion::ForceCommand{}));
  parts_.spindles.stop();
  parts_.spindles.open_position_loops();
}

void ItemWorker::end_all() RT_SAFE {
  probe_.end();
  end_effects();
  loads_.end();
  if (change_.is_pending()) change_.end();
}

void ItemWorker::answer(const ChannelAnswer& answer) RT_SAFE {
  if (!request_) return;
  request_.reset();
  activity_ = Activity::none;
  parts_.link.tell(RequestAnswer{.answer = answer,
                                 .block_skip = parts_.switches.block_skip(),
                                 .axes_M = parts_.motion.axes_M(),
                                 .tables = parts_.books.tables->version()});
}

void ItemWorker::give_up() RT_SAFE {
  activity_ = Activity::none;
  request_.reset();
}

bool ItemWorker::drop_until_reset_done(Rest& rest) RT_SAFE {
  Item item;
  while (parts_.link.items.pop(item)) {
    const auto* const done = std::get_if<ResetDone>(&item.content);
    if (done == nullptr) continue;
    rest = done->rest;
    settling_.finish();
    return true;
  }
  return false;
}

Stand ItemWorker::stand() const RT_SAFE {
  return {.scheme = parts_.schemes.active_id(),
          .axes_M = parts_.motion.axes_M(),
          .tool = tool_,
          .situation = now_.situation,
          .tables = parts_.books.tables->version()};
}

RunStart ItemWorker::run_start() const RT_SAFE {
  return {.run = parts_.runs.run(),
          .load = loads_.program(),
          .block_skip = parts_.switches.block_skip(),
          .stand = stand()};
}

void ItemWorker::begin_search(const ShortText& target, SearchWay way, int passes) RT_SAFE {
  loads_.begin_search(
      {.start = run_start(), .way = way, .passes = std::max(1, passes), .target = target});
}

void ItemWorker::begin_run(Job job) RT_SAFE {
  if (job == Job::program) {
    loads_.begin_run();
    parts_.marks.clear_marks();
    parts_.spindles.open_position_loops();
    parts_.process.restart_laws();
  }
  parts_.run.begin_run();
  now_.run = parts_.runs.run();
  if (job == Job::line) return parts_.link.tell(LineStart{run_start()});
  parts_.link.tell(ProgramStart{run_start()});
}

void ItemWorker::begin_switch(int scheme) RT_SAFE {
  // Asked for by the own program: the steps of the switch come before the answer.
  if (activity_ == Activity::request) activity_ = Activity::none;
  change_.begin(scheme);
}

void ItemWorker::begin_tap_out() RT_SAFE {
  activity_ = Activity::none;
  parts_.spindles.tap().begin_way_out();
  parts_.link.tell(TapOut{parts_.spindles.tap().tap(), parts_.motion.axes_M()});
}

void ItemWorker::follow(const motion::BlockTag& tag) RT_SAFE {
  const bool is_new = tag.run != on_path_.run || tag.block != on_path_.block;
  on_path_ = tag;
  if (is_new && tag.run == parts_.runs.run() && parts_.run.state().is_running()) now_ = tag;
}

void ItemWorker::rest(const Rest& rest) RT_SAFE {
  parts_.motion.rest_in(rest.transform);
  now_ = {.situation = rest.situation};
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

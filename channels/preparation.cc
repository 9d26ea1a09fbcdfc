#include "channels/preparation.h"

#include <stdexcept>
#include <string>

#include "channels/channel_description.h"
#include "channels/motion_config.h"
#include "channels/scheme_switch.h"

namespace stanok::channels {
namespace {

constexpr int commands_per_step = 64;

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};

Item item_of(ItemKind kind, const motion::BlockTag& tag) {
  Item item;
  item.kind = kind;
  item.tag = tag;
  return item;
}

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    if (d.severity != Severity::error) continue;
    const std::string place = d.place.line > 0 ? d.place.file + ":" + std::to_string(d.place.line) +
                                                     ":" + std::to_string(d.place.column) + ": "
                                               : std::string();
    return d.code + " " + place + d.message;
  }
  return "";
}

}  // namespace

SchemeSet make_schemes(const ChannelConfig& channel) {
  SchemeSet schemes;
  for (const kinematics::SchemeConfig& config : channel.schemes) {
    auto scheme = kinematics::make_scheme(config);
    if (scheme == nullptr) throw std::invalid_argument("unknown scheme type " + config.type);
    schemes.emplace(config.id, std::move(scheme));
  }
  return schemes;
}

Preparation::Preparation(const MachineConfig& machine, const ChannelConfig& channel,
                         const SchemeSet& schemes, const lang::Files& files,
                         const LiveTables& tables, SharedVariables& shared, ChannelLink& link,
                         ReportBook& reports)
    : config_(channel),
      schemes_(schemes),
      files_(files),
      shared_(shared),
      link_(link),
      reports_(reports),
      motion_(motion_config(machine, channel)),
      description_(channel_description(machine, channel)),
      tables_(tables, machine, channel),
      interpreter_(description_, tables_, files),
      blocks_(motion_, channel),
      builder_(motion_),
      look_ahead_(motion_) {}

Progress Preparation::step() {
  Progress progress = Progress::blocked;
  Notice notice;
  while (link_.notices.pop(notice)) {
    obey(notice);
    progress = Progress::worked;
  }
  if (!flush()) return progress;
  if (task_ != Task::running) return progress;
  interpret();
  static_cast<void>(flush());
  return Progress::worked;
}

void Preparation::obey(const Notice& notice) {
  switch (notice.kind) {
    case NoticeKind::load:
      return load(std::string(notice.text.view()));
    case NoticeKind::load_line:
      return load_line(std::string(notice.text.view()));
    case NoticeKind::start:
    case NoticeKind::start_line:
      return start(notice);
    case NoticeKind::answer:
      return take_answer(notice);
    case NoticeKind::reset:
      return reset();
    case NoticeKind::switch_scheme:
      return switch_scheme(notice);
  }
}

void Preparation::load(const std::string& name) {
  Diagnostics diagnostics;
  auto compiled = lang::compile(name, files_, &description_, diagnostics);
  if (compiled) {
    if (auto faults = declare_shared(**compiled); !faults.empty()) {
      compiled = Unexpected<Diagnostics>(std::move(faults));
    }
  }
  if (compiled) {
    program_ = *compiled;
    program_name_ = name;
  }
  finish_load(name, compiled, std::move(diagnostics));
}

void Preparation::load_line(const std::string& line) {
  Diagnostics diagnostics;
  const auto compiled =
      lang::compile_line(line, program_.get(), files_, &description_, diagnostics);
  if (compiled) line_ = *compiled;
  finish_load(line, compiled, std::move(diagnostics));
}

void Preparation::finish_load(const std::string& name, const LoadResult& compiled,
                              Diagnostics diagnostics) {
  Item done = item_of(ItemKind::load_done, {});
  if (compiled) {
    done.flag = true;
    done.text = ShortText(name);
  } else {
    diagnostics.insert(diagnostics.end(), compiled.error().begin(), compiled.error().end());
    done.text = ShortText(first_error(compiled.error()));
  }
  reports_.add_diagnostics(config_.id, diagnostics);
  push(done);
}

Diagnostics Preparation::declare_shared(const lang::Program& program) {
  Diagnostics faults;
  for (const lang::SharedVariable& variable : lang::shared_variables(program)) {
    if (auto fault = shared_.declare(variable)) faults.push_back(std::move(*fault));
  }
  return faults;
}

void Preparation::start(const Notice& notice) {
  run_ = notice.run;
  blocks_executed_ = 0;
  scheme_ = schemes_.contains(notice.number) ? schemes_.at(notice.number).get() : nullptr;
  blocks_.restart(scheme_, notice.axes_M);
  if (scheme_ != nullptr) tables_.set_scheme_zero(scheme_->config().zero);
  chain_open_ = false;
  push_transform();
  const bool is_line = notice.kind == NoticeKind::start_line;
  running_ = is_line ? line_ : program_;
  name_files();
  reports_.name_run(config_.id, run_, is_line ? "MDI" : program_name_);
  interpreter_.set_block_skip(notice.block_skip);
  if (is_line) {
    interpreter_.start_line(running_, blocks_.position_B());
  } else {
    interpreter_.start(running_, blocks_.position_B());
  }
  scheme_switched_ = false;
  task_ = Task::running;
}

// Before anything of the run can bear a tag.
void Preparation::name_files() {
  for (std::size_t k = 0; k < link_.file_names.size(); ++k)
    link_.file_names[k] = FileName(lang::file_name(*running_, static_cast<std::uint16_t>(k)));
}

void Preparation::take_answer(const Notice& notice) {
  if (task_ != Task::waiting_answer) return;
  lang::Answer answer;
  answer.ok = notice.ok;
  answer.raises = notice.raises;
  answer.number = notice.value;
  answer.text = std::string(notice.code.view());
  if (!answer.text.empty()) answer.text += ' ';
  answer.text += notice.text.view();
  if (scheme_switched_) {
    blocks_.change_scheme(scheme_, notice.axes_M);
    tables_.set_scheme_zero(scheme_->config().zero);
    push_transform();
    scheme_switched_ = false;
  }
  answer.position_B = blocks_.position_B();
  answer.position_valid = true;
  task_ = Task::running;
  interpreter_.set_block_skip(notice.block_skip);
  interpreter_.answer(answer);
}

void Preparation::reset() {
  task_ = Task::idle;
  interpreter_.reset();
  look_ahead_.clear();
  builder_.restart({});
  builder_.built().clear();
  chain_open_ = false;
  pending_items_.clear();
  pending_remarks_.clear();
  pending_riders_.clear();
  push(item_of(ItemKind::reset_done, {}));
}

void Preparation::interpret() {
  for (int n = 0; n < commands_per_step && task_ == Task::running && pending_items_.empty(); ++n) {
    switch (interpreter_.next(command_)) {
      case lang::Step::command:
        blocks_executed_ = std::max(blocks_executed_, command_.block);
        take(command_);
        break;
      case lang::Step::working:
        return;
      case lang::Step::waiting:
        task_ = Task::waiting_answer;
        return;
      case lang::Step::stopped:
      case lang::Step::ended:
        task_ = Task::idle;
        return;
      case lang::Step::failed: {
        const Diagnostic& error = interpreter_.error();
        fail(error, {run_, blocks_executed_, static_cast<std::uint32_t>(error.place.line), 0});
        return;
      }
    }
  }
}

motion::BlockTag Preparation::tag_of(const lang::Command& command) const {
  return {run_, command.block, command.origin.line, command.origin.file};
}

void Preparation::take(const lang::Command& command) {
  const auto item = [&](ItemKind kind) { return item_of(kind, tag_of(command)); };
  std::visit(
      Overloaded{
          [&](const lang::Move& move) { add_move(command, move); },
          [&](const lang::Dwell& dwell) {
            Item next = item(ItemKind::dwell);
            next.value = dwell.seconds;
            push(next);
          },
          [&](const lang::SpindleCommand& spindle) {
            Item next = item(ItemKind::spindle);
            next.spindle = spindle;
            take_state(command);
            push(next);
          },
          [&](const lang::CoolantCommand& coolant) {
            Item next = item(ItemKind::coolant);
            next.coolant = coolant;
            push(next);
          },
          [&](const lang::ToolPrepare&) {},
          [&](const lang::ToolChange& change) {
            Item next = item(ItemKind::tool_change);
            next.number = change.tool;
            push(next);
          },
          [&](const lang::ToolLength&) { take_state(command); },
          [&](const lang::FrameChange&) { take_state(command); },
          [&](const lang::OverrideControl& control) {
            Item next = item(ItemKind::override_control);
            next.overrides = control;
            push(next);
          },
          [&](const lang::Message& message) {
            pending_remarks_.push_back({tag_of(command), message.kind, ShortText(message.text)});
          },
          [&](const lang::ModalReport&) {},
          [&](const lang::ProgramStop& stop) {
            Item next = item(ItemKind::program_stop);
            next.number = static_cast<std::int64_t>(stop.kind);
            push(next);
          },
          [&](const lang::ProgramEnd& end) {
            const bool is_line = end.kind == lang::ProgramEndKind::end_of_line;
            Item next = item(is_line ? ItemKind::line_end : ItemKind::run_end);
            next.number = static_cast<std::int64_t>(blocks_executed_);
            next.flag = end.kind == lang::ProgramEndKind::restart;
            push(next);
            task_ = Task::idle;
          },
          [&](const lang::Request& request) { add_request(command, request); },
          [&](const lang::SplineMove&) { refuse(command, "a spline block"); },
          [&](const lang::SynchronousMove&) { refuse(command, "a thread"); },
          [&](const lang::ProbeMove&) { refuse(command, "probing"); },
          [&](const lang::TransformationChange&) { refuse(command, "a face transformation"); },
          [&](const lang::CuttingSpeedMode&) { refuse(command, "constant cutting speed"); },
          [&](const lang::OutputCommand& output) { add_output(command, output); },
          [&](const lang::MachineFunction& function) {
            Item next = item(ItemKind::machine_function);
            next.text = ShortText("M" + std::to_string(function.code));
            push(next);
          },
          [&](const lang::MarkCommand& mark) { add_mark(command, mark); },
          [&](const lang::WorkpieceAnnouncement&) {},
          [&](const lang::WorkpiecePosition&) {},
      },
      command.payload);
}

void Preparation::take_state(const lang::Command& command) {
  end_chain();
  if (blocks_.take_state(command.payload)) push_transform();
}

void Preparation::add_move(const lang::Command& command, const lang::Move& move) {
  const motion::BlockTag tag = tag_of(command);
  auto block = blocks_.block(move, tag);
  if (!block) {
    Diagnostic diagnostic = block.error();
    lang::put_at_block(*running_, command.origin, diagnostic);
    return fail(diagnostic, tag);
  }
  chain_open_ = true;
  if (const auto unreachable = builder_.add(*block)) {
    Diagnostic diagnostic = unreachable_pose(*unreachable, config_);
    lang::put_at_block(*running_, command.origin, diagnostic);
    return fail(diagnostic, tag);
  }
  collect_pieces();
}

void Preparation::add_request(const lang::Command& command, const lang::Request& request) {
  Item item = item_of(ItemKind::request, tag_of(command));
  RequestData& data = item.request;
  data.kind = request.kind;
  data.channel = request.channel;
  data.number = request.number;
  data.index = request.index;
  data.analog = request.analog;
  data.channels = request.channels;
  data.seconds = request.seconds;
  data.value = request.value;
  item.text = ShortText(request.text);
  if (request.kind == lang::RequestKind::shared_read ||
      request.kind == lang::RequestKind::shared_write) {
    const SharedVariables::Cell cell = shared_.cell(request.text, request.index);
    data.number = cell.number;
    data.is_text = cell.is_text;
    item.text = ShortText(request.value_text);
  }
  push(item);
}

void Preparation::add_output(const lang::Command& command, const lang::OutputCommand& output) {
  if (!output.with_motion) {
    Item item = item_of(ItemKind::output, tag_of(command));
    item.flag = output.analog;
    item.number = output.number;
    item.value = output.value;
    return push(item);
  }
  Rider rider;
  rider.kind = output.analog ? RiderKind::analog_output : RiderKind::digital_output;
  rider.tag = tag_of(command);
  rider.before_block = command.block;
  rider.number = output.number;
  rider.value = output.value;
  push_rider(rider);
}

void Preparation::add_mark(const lang::Command& command, const lang::MarkCommand& mark) {
  using Kind = lang::MarkCommand::Kind;
  Rider rider;
  rider.kind = mark.kind == Kind::set     ? RiderKind::mark_set
               : mark.kind == Kind::clear ? RiderKind::mark_clear
                                          : RiderKind::mark_wait;
  rider.tag = tag_of(command);
  rider.before_block = command.block + 1;
  rider.number = mark.id;
  rider.channels = mark.channels;
  push_rider(rider);
}

void Preparation::fail(const Diagnostic& diagnostic, const motion::BlockTag& tag) {
  reports_.explain(config_.id, run_, diagnostic);
  Item item = item_of(ItemKind::run_failed, tag);
  item.number = static_cast<std::int64_t>(blocks_executed_);
  item.code = FixedText<8>(diagnostic.code);
  item.text = ShortText(diagnostic.message);
  push(item);
  task_ = Task::idle;
}

// What the language knows and the machine cannot do yet stops the program before it.
void Preparation::refuse(const lang::Command& command, std::string_view what) {
  const motion::BlockTag tag = tag_of(command);
  Diagnostic diagnostic;
  diagnostic.code = "E6033";
  diagnostic.message = "the machine cannot execute " + std::string(what) + " in this release";
  lang::put_at_block(*running_, command.origin, diagnostic);
  fail(diagnostic, tag);
}

void Preparation::end_chain() {
  if (!chain_open_) return;
  builder_.finish();
  collect_pieces();
  chain_open_ = false;
  riders_in_chain_ = 0;
}

void Preparation::collect_pieces() {
  for (const motion::PathBuilder::Built& built : builder_.built()) look_ahead_.add(built);
  builder_.built().clear();
}

void Preparation::push(Item item) {
  end_chain();
  item.after_rider = link_.riders.pushed() + pending_riders_.size();
  pending_items_.push_back(item);
}

// A chain with very many riders ends: its path must be delivered before the ring is full of them.
void Preparation::push_rider(const Rider& rider) {
  pending_riders_.push_back(rider);
  if (++riders_in_chain_ >= link_.riders.capacity() / 2) end_chain();
}

void Preparation::push_transform() {
  builder_.restart(blocks_.position_W());
  Item item = item_of(ItemKind::transform, {});
  item.transform = &blocks_.transform();
  push(item);
}

// True when nothing is left that waits for room in a ring.
bool Preparation::flush() {
  while (!pending_remarks_.empty() && link_.remarks.push(pending_remarks_.front()))
    pending_remarks_.pop_front();
  while (!pending_riders_.empty() && link_.riders.push(pending_riders_.front()))
    pending_riders_.pop_front();
  if (!pending_riders_.empty()) return false;
  if (!look_ahead_.deliver(link_.path)) return false;
  while (!pending_items_.empty()) {
    Item& item = pending_items_.front();
    item.after_chunk = link_.path.chunks.pushed();
    if (!link_.items.push(item)) return false;
    pending_items_.pop_front();
  }
  return pending_remarks_.empty();
}

bool Preparation::move_axis(int axis, double position, double velocity) {
  motion::PathBlock block;
  block.ending = motion::BlockEnding::exact_stop;
  block.end = builder_.end();
  block.end[static_cast<std::size_t>(axis)] = position;
  block.rapid = velocity <= 0.0;
  block.feed_per_s = velocity;
  block.transform = &machine_axes_transform();
  chain_open_ = true;
  if (builder_.add(block)) return false;
  collect_pieces();
  return true;
}

void Preparation::switch_scheme(const Notice& notice) {
  const SwitchPlan plan =
      plan_switch(config_, *schemes_.at(notice.number), notice.axes_M, notice.enabled);
  builder_.restart(notice.axes_M);
  Item frame = item_of(ItemKind::transform, {});
  frame.transform = &machine_axes_transform();
  push(frame);
  bool reached = true;
  for (const SwitchStep& step : plan) {
    if (step.kind == SwitchStepKind::move) {
      reached = reached && move_axis(step.axis, step.position, step.velocity);
      end_chain();
    } else {
      Item item = item_of(
          step.kind == SwitchStepKind::park ? ItemKind::park_axes : ItemKind::join_axes, {});
      item.axes = step.axes;
      push(item);
    }
    if (!reached) {
      Item failed = item_of(ItemKind::switch_failed, {});
      failed.code = FixedText<8>("E5204");
      failed.text = ShortText("the parked position of axis " + axis_word(config_, step.axis) +
                              " is beyond its limits");
      return push(failed);
    }
  }
  scheme_ = schemes_.at(notice.number).get();
  scheme_switched_ = true;
  Item set = item_of(ItemKind::scheme_set, {});
  set.number = notice.number;
  push(set);
  push(item_of(ItemKind::switch_done, {}));
}

}  // namespace stanok::channels

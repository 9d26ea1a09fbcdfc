// What becomes of each command of the interpreter: a block of the path, an item, a rider, a remark.
#include <string>

#include "base/overloaded.h"
#include "channels/preparation/feed_limit.h"
#include "channels/preparation/preparation.h"
#include "channels/preparation/scheme_switch.h"

namespace stanok::channels {

void Preparation::take(const lang::Command& command) {
  const auto item = [&](ItemKind kind) { return item_of(kind, tag_of(command)); };
  std::visit(Overloaded{
                 [&](const lang::Move& move) { add_move(command, move); },
                 [&](const lang::Dwell& dwell) {
                   Item next = item(ItemKind::dwell);
                   next.value = dwell.seconds;
                   push(next);
                 },
                 [&](const lang::SpindleCommand& spindle) {
                   Item next = item(ItemKind::spindle);
                   next.spindle = spindle;
                   threads_.take_spindle(spindle);
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
                   next.value = change.edge;
                   push(next);
                 },
                 [&](const lang::ToolLength&) { take_state(command); },
                 [&](const lang::FrameChange&) { take_state(command); },
                 [&](const lang::OverrideControl& control) {
                   Item next = item(ItemKind::override_control);
                   next.overrides = control;
                   push(next);
                 },
                 [&](const lang::ForceControl& force) {
                   Item next = item(ItemKind::force_control);
                   next.force = force;
                   push(next);
                 },
                 [&](const lang::Message& message) {
                   const bool warns = message.kind == lang::Message::Kind::warning;
                   push_remark({tag_of(command), SpokenText{FixedText<8>(warns ? "W0001" : ""),
                                                            ShortText(message.text)}});
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
                 [&](const lang::SplineMove& spline) { add_curve(command, spline); },
                 [&](const lang::SynchronousMove& move) { add_thread(command, move); },
                 [&](const lang::ProbeMove& move) { add_probing(command, move); },
                 [&](const lang::TransformationChange& change) {
                   if (const auto refusal = blocks_.refusal(change)) {
                     fail_at_block(command, *refusal);
                   } else {
                     take_state(command);
                   }
                 },
                 [&](const lang::FeedLawChange&) { blocks_.take_process(command.payload); },
                 [&](const lang::CuttingSpeedMode& mode) {
                   Item next = item(ItemKind::cutting_speed);
                   next.cutting = mode;
                   take_state(command);
                   push(next);
                 },
                 [&](const lang::OutputCommand& output) { add_output(command, output); },
                 [&](const lang::MachineFunction& function) {
                   Item next = item(ItemKind::machine_function);
                   next.text = ShortText("M" + std::to_string(function.code));
                   push(next);
                 },
                 [&](const lang::MarkCommand& mark) { add_mark(command, mark); },
                 [&](const lang::WorkpieceAnnouncement& shape) {
                   push_remark({tag_of(command), BlankNews{shape, blocks_.transform().frame}});
                 },
                 [&](const lang::WorkpiecePosition& position) {
                   push_remark({tag_of(command), position});
                 },
             },
             command.payload);
}

void Preparation::take_state(const lang::Command& command) {
  end_chain();
  if (blocks_.take_state(command.payload)) push_transform();
}

void Preparation::add_move(const lang::Command& command, const lang::Move& move) {
  end_thread();
  const motion::Point start = blocks_.position_W();
  const auto block = blocks_.block(move, tag_of(command));
  if (!block) return fail_at_block(command, block.error());
  if (move.is_tap) {
    if (const auto refusal = tap_refusal(*block, start, blocks_.geometry(), motion_))
      return fail_at_block(command, *refusal);
  }
  add_block(command, *block);
}

void Preparation::add_curve(const lang::Command& command, const lang::SplineMove& spline) {
  end_thread();
  const auto blocks = blocks_.curve(spline, tag_of(command));
  if (!blocks) return fail_at_block(command, blocks.error());
  for (const motion::PathBlock& block : *blocks) {
    if (!add_block(command, block)) return;
  }
}

// False when the block cannot be reached; the run has failed then.
bool Preparation::add_block(const lang::Command& command, const motion::PathBlock& block) {
  chain_open_ = true;
  block_book_.tell_end(block.tag, block.end);
  if (const auto unreachable = builder_.add(block)) {
    fail_at_block(command, unreachable_pose(*unreachable, config_));
    return false;
  }
  collect_pieces();
  return true;
}

// A tap comes back to where it begins.
void Preparation::add_thread(const lang::Command& command, const lang::SynchronousMove& move) {
  if (!threads_.continues(move)) end_chain();
  const motion::Point start = blocks_.position_W();
  const auto line = blocks_.thread_line(move.line, tag_of(command));
  if (!line) return fail_at_block(command, line.error());
  block_book_.tell_end(line->tag, line->end);
  if (const auto refusal = threads_.add(move, *line, start, blocks_.geometry()))
    return fail_at_block(command, *refusal);
  has_given_ = true;
  if (move.kind == lang::SynchronousMove::Kind::rigid_tap) blocks_.return_to(start);
}

void Preparation::fail_at_block(const lang::Command& command, Diagnostic diagnostic) {
  lang::put_at_block(*running_, command.origin, diagnostic);
  fail(diagnostic, tag_of(command));
}

void Preparation::add_probing(const lang::Command& command, const lang::ProbeMove& move) {
  if (config_.probe_input < 0) {
    Diagnostic diagnostic;
    diagnostic.code = "E4323";
    diagnostic.message = "channel " + std::to_string(config_.id) + " has no probe";
    diagnostic.help = {"give the channel of the machine file a probe_input"};
    return fail_at_block(command, std::move(diagnostic));
  }
  Item probe = item_of(ItemKind::probe, tag_of(command));
  probe.flag = move.until_contact;
  probe.number = move.alarm_when_missed ? 1 : 0;
  push(probe);
  add_move(command, move.line);
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
  data.combination = request.combination;
  item.text = ShortText(request.text);
  axes_change_ = axes_change_ || request.kind == lang::RequestKind::spindle_to_axis;
  if (request.kind == lang::RequestKind::shared_read ||
      request.kind == lang::RequestKind::shared_write ||
      request.kind == lang::RequestKind::shared_combine) {
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
  if (mark.kind == Kind::wait_soft) end_thread();
  push_rider(rider);
}

}  // namespace stanok::channels

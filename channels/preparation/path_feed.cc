#include "channels/preparation/path_feed.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/overloaded.h"
#include "channels/messages/channel_link.h"
#include "channels/preparation/feed_limit.h"
#include "channels/preparation/plain_item.h"
#include "channels/preparation/scheme_switch.h"

namespace stanok::channels {
namespace {

SpokenText spoken(const lang::Message& message) {
  const bool warns = message.kind == lang::Message::Kind::warning;
  return {FixedText<8>(warns ? "W0001" : ""), ShortText(message.text)};
}

// Back to the sink before at its end, whatever is thrown.
class OtherSink {
 public:
  OtherSink(FeedSink*& place, FeedSink& sink) : place_(place), own_(std::exchange(place, &sink)) {}
  ~OtherSink() { place_ = own_; }
  OtherSink(const OtherSink&) = delete;
  OtherSink& operator=(const OtherSink&) = delete;

 private:
  FeedSink*& place_;
  FeedSink* own_;
};

Diagnostic no_probe(int channel, int input) {
  const bool is_first = input == 1;
  Diagnostic diagnostic;
  diagnostic.code = "E4323";
  diagnostic.message = "channel " + std::to_string(channel) + " has no probe";
  if (!is_first) diagnostic.message += " P" + std::to_string(input);
  diagnostic.help = {is_first
                         ? "add probe_input to the channel in the machine file"
                         : "add skip_inputs (for P2, P3, P4) to the channel in the machine file"};
  return diagnostic;
}

// The digital input of P1 to P4; -1: there is none.
int digital_input(const ChannelConfig& channel, int input) {
  if (input == 1) return channel.probe_input;
  const auto place = static_cast<std::size_t>(input - 2);
  return place < channel.skip_inputs.size() ? channel.skip_inputs[place] : -1;
}

// A block without length does not.
bool takes_time(const motion::Point& start, const motion::PathBlock& block) {
  return block.kind != motion::BlockKind::line || block.end != start;
}

// A chain has one transform.
void stand_for(PathFeed& feed, const lang::Command& command, const lang::Move& move) {
  if (!feed.blocks().stand_for(move)) return;
  feed.end_chain();
  feed.give_transform(feed.tag_of(command));
}

}  // namespace

PathFeed::PathFeed(const MachineConfig& machine, const ChannelConfig& channel,
                   const motion::MotionConfig& motion, FeedSink& sink, const ChannelTables* tables)
    : channel_(channel),
      motion_(motion),
      sink_(&sink),
      blocks_(machine, channel, motion, tables),
      builder_(motion),
      threads_(machine, channel, motion) {}

void PathFeed::begin_run(std::uint32_t run) {
  run_ = run;
  blocks_.begin_run();
  blocks_executed_ = 0;
  chain_open_ = false;
}

Expected<Taken, Diagnostic> PathFeed::take(const lang::Command& command) {
  blocks_executed_ = std::max(blocks_executed_, command.block);
  has_given_ = false;
  sink_->begin_command(command);
  Taken taken;
  if (auto refusal = dispatch(command, taken)) {
    if (program_ != nullptr) lang::put_at_block(*program_, command.origin, *refusal);
    end_chain();
    builder_.restart(blocks_.position_W(), blocks_.geometry());
    return Unexpected<Diagnostic>(std::move(*refusal));
  }
  taken.gives = has_given_;
  return taken;
}

Expected<Taken, Diagnostic> PathFeed::pass(const lang::Command& command, FeedSink& sink) {
  const OtherSink other(sink_, sink);
  return take(command);
}

PathFeed::Refusal PathFeed::dispatch(const lang::Command& command, Taken& taken) {
  return std::visit(
      Overloaded{
          [&](const lang::Move& move) { return take_move(command, move); },
          [&](const lang::SplineMove& spline) { return take_curve(command, spline); },
          [&](const lang::SynchronousMove& move) { return take_thread(command, move); },
          [&](const lang::ProbeMove& move) { return take_probing(command, move); },
          [&](const lang::TransformationChange& change) {
            return take_transformation(command, change);
          },
          [&](const auto&) {
            if (const auto content = plain_content(command.payload)) {
              take_plain(command, *content);
            } else {
              take_other(command, taken);
            }
            return Refusal();
          },
      },
      command.payload);
}

// The state for the motion behind it comes first.
void PathFeed::take_plain(const lang::Command& command, const ItemContent& content) {
  const auto* spindle = std::get_if<lang::SpindleCommand>(&content);
  const auto* mode = std::get_if<lang::CuttingSpeedMode>(&content);
  if (spindle != nullptr || mode != nullptr) take_state(command);
  if (spindle != nullptr) threads_.take_spindle(*spindle);
  if (mode != nullptr)
    threads_.take_cutting_speed(*mode, blocks_.position_W(), blocks_.geometry()[0]);
  give({.tag = tag_of(command), .content = content});
}

void PathFeed::take_other(const lang::Command& command, Taken& taken) {
  const motion::BlockTag tag = tag_of(command);
  std::visit(Overloaded{
                 [&](const lang::ToolLength&) { take_state(command); },
                 [&](const lang::FrameChange&) { take_state(command); },
                 [&](const lang::FeedLawChange&) { blocks_.take_process(command.payload); },
                 [&](const lang::Message& message) { give_remark({tag, spoken(message)}); },
                 [&](const lang::WorkpieceAnnouncement& blank) {
                   give_remark({tag, BlankNews{blank.shape, std::string_view(blank.file),
                                               blocks_.transform().frame}});
                 },
                 [&](const lang::WorkpiecePosition& position) { give_remark({tag, position}); },
                 [&](const lang::ProgramRequest& request) {
                   taken.changes_axes = request.kind == lang::RequestKind::spindle_to_axis;
                   take_request(command, request);
                 },
                 [&](const lang::OutputCommand& output) { take_output(command, output); },
                 [&](const lang::MarkCommand& mark) { take_mark(command, mark); },
                 [&](const lang::ProgramEnd& end) {
                   taken.ends = true;
                   take_end(command, end);
                 },
                 [](const auto&) {},
             },
             command.payload);
}

void PathFeed::take_state(const lang::Command& command) {
  end_chain();
  if (blocks_.take_state(command.payload)) give_transform(tag_of(command));
}

PathFeed::Refusal PathFeed::take_transformation(const lang::Command& command,
                                                const lang::TransformationChange& change) {
  if (auto refusal = blocks_.refusal(change)) return refusal;
  take_state(command);
  return std::nullopt;
}

PathFeed::Refusal PathFeed::take_move(const lang::Command& command, const lang::Move& move) {
  end_thread();
  stand_for(*this, command, move);
  const motion::Point start = blocks_.position_W();
  const auto block = blocks_.block(move, tag_of(command));
  if (!block) return block.error();
  sink_->take_motion(command, {&*block, 1});
  if (sink_->depth() == FeedDepth::positions) {
    has_given_ = has_given_ || takes_time(start, *block);
    return std::nullopt;
  }
  if (move.is_tap) {
    if (auto refusal = tap_refusal(*block, start, blocks_.geometry(), motion_)) return refusal;
  }
  return follow(*block);
}

PathFeed::Refusal PathFeed::take_curve(const lang::Command& command,
                                       const lang::SplineMove& spline) {
  end_thread();
  stand_for(*this, command, spline.base);
  const motion::Point start = blocks_.position_W();
  const auto blocks = blocks_.curve(spline, tag_of(command));
  if (!blocks) return blocks.error();
  sink_->take_motion(command, *blocks);
  if (sink_->depth() == FeedDepth::positions) {
    has_given_ = has_given_ || takes_time(start, blocks->back());
    return std::nullopt;
  }
  for (const motion::PathBlock& block : *blocks) {
    if (auto refusal = follow(block)) return refusal;
  }
  return std::nullopt;
}

PathFeed::Refusal PathFeed::follow(const motion::PathBlock& block) {
  chain_open_ = true;
  if (const auto pose = builder_.add(block)) return unreachable_pose(*pose, channel_);
  collect_segments();
  return std::nullopt;
}

// A tap comes back to where it begins.
PathFeed::Refusal PathFeed::take_thread(const lang::Command& command,
                                        const lang::SynchronousMove& move) {
  if (!threads_.continues(move)) {
    end_chain();
    stand_for(*this, command, move.line);
  }
  const motion::Point start = blocks_.position_W();
  const auto line = blocks_.thread_line(move.line, tag_of(command));
  if (!line) return line.error();
  sink_->take_motion(command, {&*line, 1});
  if (move.kind == lang::SynchronousMove::Kind::rigid_tap) blocks_.return_to(start);
  has_given_ = true;
  if (sink_->depth() == FeedDepth::positions) return std::nullopt;
  return threads_.add(move, *line, start, blocks_.geometry());
}

PathFeed::Refusal PathFeed::take_probing(const lang::Command& command,
                                         const lang::ProbeMove& move) {
  const int input = digital_input(channel_, move.input);
  if (input < 0) return no_probe(channel_.id, move.input);
  give({.tag = tag_of(command),
        .content = ProbeBegin{.input = input,
                              .until_contact = move.until_contact,
                              .alarm_when_missed = move.alarm_when_missed}});
  // The request behind it ends the path. A line that ended it by itself (G9, G61.1) would be on its
  // way before the item that watches the probe.
  lang::Move line = move.line;
  line.stop_at_end = false;
  if (line.path.mode == lang::PathMode::exact_stop) line.path.mode = lang::PathMode::exact_path;
  return take_move(command, line);
}

void PathFeed::take_request(const lang::Command& command, const lang::ProgramRequest& request) {
  has_given_ = true;
  end_chain();
  sink_->take_request(tag_of(command), request);
}

void PathFeed::take_output(const lang::Command& command, const lang::OutputCommand& output) {
  Rider rider{.tag = tag_of(command), .before_block = command.block};
  if (output.analog) {
    rider.content = riders::AnalogOutput{.number = output.number, .value = output.value};
  } else {
    rider.content = riders::DigitalOutput{.number = output.number, .is_on = output.value != 0.0};
  }
  give_rider(rider);
}

void PathFeed::take_mark(const lang::Command& command, const lang::MarkCommand& mark) {
  using Kind = lang::MarkCommand::Kind;
  Rider rider{.tag = tag_of(command), .before_block = command.block + 1};
  if (mark.kind == Kind::wait_soft) {
    end_thread();
    rider.content = riders::SoftMark{.mark = mark.id, .channels = mark.channels};
  } else {
    rider.content = riders::MarkChange{.mark = mark.id, .is_set = mark.kind == Kind::set};
  }
  give_rider(rider);
}

void PathFeed::take_end(const lang::Command& command, const lang::ProgramEnd& end) {
  const motion::BlockTag tag = tag_of(command);
  if (end.kind == lang::ProgramEndKind::end_of_line)
    return give({.tag = tag, .content = LineEnd{blocks_executed_, rest()}});
  const bool is_restart = end.kind == lang::ProgramEndKind::restart;
  give({.tag = tag,
        .content = RunEnd{.blocks = blocks_executed_, .is_restart = is_restart, .rest = rest()}});
}

void PathFeed::settle(const lang::MeaningTerms& standing) {
  end_chain();
  blocks_.settle(standing);
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

void PathFeed::give(const Item& item) {
  has_given_ = true;
  end_chain();
  sink_->take_item(item);
}

// A chain with very many riders ends: its path must be delivered before the ring is full of them.
void PathFeed::give_rider(const Rider& rider) {
  has_given_ = true;
  builder_.keep_end();
  sink_->take_rider(rider);
  if (++riders_in_chain_ >= riders_in_chain_max) end_chain();
}

void PathFeed::give_remark(const Remark& remark) {
  has_given_ = true;
  builder_.keep_end();
  sink_->take_remark(remark);
}

void PathFeed::give_transform(const motion::BlockTag& tag) {
  builder_.restart(blocks_.position_W(), blocks_.geometry());
  give({.tag = tag,
        .content = TransformSet{.transform = &blocks_.transform(), .start = blocks_.position_W()}});
}

void PathFeed::end_chain() {
  end_thread();
  if (!chain_open_) return;
  builder_.finish();
  collect_segments();
  chain_open_ = false;
  riders_in_chain_ = 0;
}

void PathFeed::end_thread() {
  if (threads_.is_empty()) return;
  sink_->take_thread(threads_.finish());
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

void PathFeed::collect_segments() {
  for (const motion::PathBuilder::Built& built : builder_.built()) {
    has_given_ = true;
    sink_->take_segment(built);
  }
  builder_.built().clear();
}

void PathFeed::begin_machine_path(const motion::Point& axes_M) {
  builder_.restart(axes_M);
  give({.content = TransformSet{.transform = &machine_axes_transform(), .start = axes_M}});
}

bool PathFeed::move_axis(int axis, double position, double velocity) {
  motion::PathBlock block;
  block.ending = motion::BlockEnding::exact_stop;
  block.end = builder_.end();
  block.end[axis] = position;
  block.rapid = velocity <= 0.0;
  block.feed_per_s = velocity;
  block.transform = &machine_axes_transform();
  return !follow(block);
}

std::optional<Diagnostic> PathFeed::take_tap_out(const HeldTap& tap, const motion::Point& axes_M) {
  end_chain();
  const auto programmed = [this](const motion::Point& at_M) {
    blocks_.stand_at(at_M);
    return blocks_.position_W();
  };
  const TapWay way{.start = programmed(tap.start_M),
                   .deepest = programmed(tap.deepest_M),
                   .now = programmed(axes_M),
                   .transform = &blocks_.transform()};
  const auto end = threads_.take_out(tap, way, blocks_.geometry());
  if (!end) return end.error();
  blocks_.return_to(*end);
  return std::nullopt;
}

void PathFeed::pass_switch(const kinematics::Scheme& scheme) {
  blocks_.change_scheme(&scheme, axes_behind_switch(scheme, blocks_.axes_M()));
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

void PathFeed::forget_path() {
  builder_.restart({});
  builder_.built().clear();
  threads_.forget();
  chain_open_ = false;
}

motion::BlockTag PathFeed::tag_of(const lang::Command& command) const {
  return {run_, command.block, command.origin.line, command.origin.file, situation_};
}

motion::BlockTag PathFeed::tag_at(int line, std::uint16_t file) const {
  return {run_, blocks_executed_, static_cast<std::uint32_t>(std::max(0, line)), file, situation_};
}

}  // namespace stanok::channels

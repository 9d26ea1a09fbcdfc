// PathFeed: what becomes of each command of the interpreter, for a run, a dry run and a block
// search alike: a block of the path, an item, a rider, a remark, or a refusal.
//
// Everything that is decided about a command is decided here, once: frames, feed, axis limits,
// where a chain of the path ends, what is refused. The results go to a sink. Thread: that of its
// owner, never the cycle. Owner: the preparation of a channel, or a dry run. Invariant: at the
// depth `path` every item comes after the path before it, and a chain begins at the end of the
// chain before.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "channels/contract/machine_config.h"
#include "channels/preparation/block_preparation.h"
#include "channels/preparation/feed_sink.h"
#include "channels/preparation/thread_preparation.h"
#include "lang/program/compile.h"
#include "motion/segments/path_builder.h"

namespace stanok::channels {

// What a command came to.
struct Taken {
  bool gives = false;         // something came out: the program does not compute only
  bool ends = false;          // the program is at its end
  bool changes_axes = false;  // the answer to it tells where a spindle stands as an axis
};

class PathFeed {
 public:
  // All arguments outlive the feed; `tables` as of BlockPreparation.
  PathFeed(const MachineConfig& machine, const ChannelConfig& channel,
           const motion::MotionConfig& motion, FeedSink& sink,
           const ChannelTables* tables = nullptr);

  // Blocks are counted afresh and carry `run` in their tags.
  void begin_run(std::uint32_t run);
  // The texts of the commands that follow, for the places of diagnostics.
  void set_program(std::shared_ptr<const lang::Program> program) { program_ = std::move(program); }

  // What the command comes to, or why it cannot be carried out, with its place. Behind a refusal
  // the path begins anew at the position that is then reached.
  [[nodiscard]] Expected<Taken, Diagnostic> take(const lang::Command& command);
  // The same into another sink.
  [[nodiscard]] Expected<Taken, Diagnostic> pass(const lang::Command& command, FeedSink& sink);

  // An item that no command asks for, behind the path so far.
  void give(const Item& item);
  // The transform is another one: the path goes on in it from the position.
  void give_transform(const motion::BlockTag& tag = {});
  void end_chain();
  // Nothing runs any more, or not yet: the position is that of the axes, in what is in force then.
  void settle(const lang::MeaningTerms& standing);
  [[nodiscard]] Rest rest() const { return {&blocks_.transform(), situation_}; }
  // The number of the situation in which the commands that follow were read.
  void set_situation(std::uint32_t number) { situation_ = number; }

  // A path in machine axes, of a switch of kinematics: from where they stand, each block to where
  // one axis goes. False: it cannot get there.
  void begin_machine_path(const motion::Point& axes_M);
  [[nodiscard]] bool move_axis(int axis, double position, double velocity);

  // A tap that stands at `axes_M` comes out of its hole; the position is then where it began. Or
  // why it cannot.
  [[nodiscard]] std::optional<Diagnostic> take_tap_out(const HeldTap& tap,
                                                       const motion::Point& axes_M);

  // Another scheme is active at once, its axes standing where a switch leaves them.
  void pass_switch(const kinematics::Scheme& scheme);

  void forget_path();
  void forget_threads() { threads_.forget(); }

  [[nodiscard]] BlockPreparation& blocks() { return blocks_; }
  [[nodiscard]] const BlockPreparation& blocks() const { return blocks_; }
  [[nodiscard]] std::uint64_t blocks_executed() const { return blocks_executed_; }
  [[nodiscard]] motion::BlockTag tag_of(const lang::Command& command) const;
  // Of a line of the program that no command stands for.
  [[nodiscard]] motion::BlockTag tag_at(int line, std::uint16_t file = 0) const;

 private:
  using Refusal = std::optional<Diagnostic>;

  [[nodiscard]] Refusal dispatch(const lang::Command& command, Taken& taken);
  void take_plain(const lang::Command& command, const ItemContent& content);
  void take_other(const lang::Command& command, Taken& taken);
  [[nodiscard]] Refusal take_move(const lang::Command& command, const lang::Move& move);
  [[nodiscard]] Refusal take_curve(const lang::Command& command, const lang::SplineMove& spline);
  [[nodiscard]] Refusal take_thread(const lang::Command& command,
                                    const lang::SynchronousMove& move);
  [[nodiscard]] Refusal take_probing(const lang::Command& command, const lang::ProbeMove& move);
  [[nodiscard]] Refusal take_transformation(const lang::Command& command,
                                            const lang::TransformationChange& change);
  void take_state(const lang::Command& command);
  void take_request(const lang::Command& command, const lang::ProgramRequest& request);
  void take_output(const lang::Command& command, const lang::OutputCommand& output);
  void take_mark(const lang::Command& command, const lang::MarkCommand& mark);
  void take_end(const lang::Command& command, const lang::ProgramEnd& end);
  [[nodiscard]] Refusal follow(const motion::PathBlock& block);
  void give_rider(const Rider& rider);
  void give_remark(const Remark& remark);
  void end_thread();
  void collect_segments();

  const ChannelConfig& channel_;
  const motion::MotionConfig& motion_;
  FeedSink* sink_;
  BlockPreparation blocks_;
  motion::PathBuilder builder_;
  ThreadPreparation threads_;
  std::shared_ptr<const lang::Program> program_;
  std::uint32_t run_ = 0;
  std::uint64_t blocks_executed_ = 0;
  std::uint32_t situation_ = 0;
  bool chain_open_ = false;
  bool has_given_ = false;  // since the command began
  std::size_t riders_in_chain_ = 0;
};

}  // namespace stanok::channels

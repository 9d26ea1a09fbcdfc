// BlockPreparation: commands of motion in the workpiece system to blocks of the path.
//
// Applies what the program has set up around its motion: the frame W -> B, tool length, path mode
// and tolerance, feed mode. Owner: the channel's preparation. Positions in W are in the order of
// the channel's axes.
#pragma once

#include <deque>
#include <optional>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "channels/contract/machine_config.h"
#include "channels/preparation/face_transformation.h"
#include "channels/preparation/process_preparation.h"
#include "channels/stores/channel_tables.h"
#include "lang/contract/command.h"
#include "lang/contract/meaning.h"
#include "motion/path/path.h"

namespace stanok::channels {

// Of a part turned around Z, mm; 0: the channel has no X.
[[nodiscard]] double diameter_of(const motion::MotionConfig& motion, const motion::Point& point_W);

class BlockPreparation {
 public:
  // `tables`: where changes of lengths that count at once are read; nullptr: there are none.
  BlockPreparation(const MachineConfig& machine, const ChannelConfig& channel,
                   const motion::MotionConfig& motion, const ChannelTables* tables = nullptr);

  // A run begins. Transforms of the run before the latest one become invalid: until the new run has
  // given its first one to the cycle, the cycle stands in those of the latest.
  void begin_run();

  // Begins afresh with `scheme`, frame and tool at zero, the axes standing at `axes_M`.
  void restart(const kinematics::Scheme* scheme, const motion::Point& axes_M);

  // Another scheme is active, the axes stand at `axes_M`; frame and tool stay.
  void change_scheme(const kinematics::Scheme* scheme, const motion::Point& axes_M);

  // Takes changes of lengths into account; the programmed point stays. Where the chain has ended.
  // True: the transform is a new one, as behind take_state().
  [[nodiscard]] bool take_lengths();
  // Machine positions are not those of a tool: before a move to them, and before others behind it,
  // the transform is one without a row of the tool table, or with it. True: it is a new one, as
  // behind take_state().
  [[nodiscard]] bool stand_for(const lang::Move& move);

  // Takes over what a command sets up for the motion after it: frame, tool length, what feed and
  // spindle do.
  // True when the transform is a new one: the chain must have ended before, and a new one begins at
  // position_W().
  [[nodiscard]] bool take_state(const lang::Payload& command);

  // What is in force while nothing runs; the axes stay. Behind the end of a chain, or of restart().
  void settle(const lang::MeaningTerms& standing);

  // A feed law for the motion that follows; the path goes on.
  void take_process(const lang::Payload& command) {
    process_.take_state(command, diameter_of(motion_, position_W_));
  }

  [[nodiscard]] double steady_speed() const { return process_.steady_speed(); }

  // At the start of a program; lines of an operator go on with the current law.
  void forget_laws() { process_.forget_laws(); }
  void reset_process() { process_.reset(); }

  // Why a face or cylinder transformation cannot begin here, or nothing.
  [[nodiscard]] std::optional<Diagnostic> refusal(const lang::TransformationChange& change) const;
  // X, Y, Z of the current workpiece space, by index in the channel; -1: none.
  [[nodiscard]] std::array<int, 3> geometry() const { return face_.geometry(); }
  [[nodiscard]] const kinematics::Transform& transform() const { return transforms_.back(); }
  [[nodiscard]] const motion::Point& position_W() const { return position_W_; }
  // A point of the path as programmed: on a cylinder the path has a length where the word is in
  // deg.
  [[nodiscard]] motion::Point programmed(const motion::Point& point_W) const {
    return face_.to_program(point_W);
  }
  // The axes of the machine at the end of the path.
  [[nodiscard]] motion::Point axes_M() const;
  // The programmed point in B: what the interpreter keeps as its position.
  [[nodiscard]] motion::Point position_B() const;

  // The programmed point in B where the axes of the machine stand so.
  [[nodiscard]] motion::Point base_of(const motion::Point& axes_M) const;

  // The path goes on from where the axes stand, in the current frame.
  void stand_at(const motion::Point& axes_M);

  // The block of a move, or why it cannot be made; the position moves to its end. `tag` goes into
  // the block.
  [[nodiscard]] Expected<motion::PathBlock, Diagnostic> block(const lang::Move& move,
                                                              const motion::BlockTag& tag);

  // The line of a thread, whose feed comes from the spindle; the position moves to its end.
  [[nodiscard]] Expected<motion::PathBlock, Diagnostic> thread_line(const lang::Move& move,
                                                                    const motion::BlockTag& tag);

  // A tap is back where it began, `point_W`.
  void return_to(const motion::Point& point_W) { position_W_ = point_W; }

  // The same for a spline, in stretches that the path can hold.
  [[nodiscard]] Expected<std::vector<motion::PathBlock>, Diagnostic> curve(
      const lang::SplineMove& spline, const motion::BlockTag& tag);

 private:
  [[nodiscard]] bool set_frame(const lang::FrameChange& change);
  [[nodiscard]] bool set_tool_length(const lang::ToolLength& length);
  [[nodiscard]] bool set_transformation(const lang::TransformationChange& change);
  [[nodiscard]] bool take_programmed(const kinematics::Transform& next);
  [[nodiscard]] double face_axis_at(const motion::PathBlock& block, double part) const;
  [[nodiscard]] double face_turn(const motion::PathBlock& block, double from, double to) const;
  [[nodiscard]] std::optional<Diagnostic> refuse_pole(const motion::PathBlock& block) const;
  [[nodiscard]] motion::Point end_of(const lang::Move& move) const;
  [[nodiscard]] std::array<int, 2> plane_axes(lang::Plane plane) const;
  void shape_arc(const lang::Move& move, motion::PathBlock& block) const;
  void shape_ending(const lang::Move& move, motion::PathBlock& block) const;
  [[nodiscard]] double length_of(const motion::Point& from_W, const motion::PathBlock& block) const;
  [[nodiscard]] std::optional<Diagnostic> refuse_parked_axes(const lang::Move& move) const;
  [[nodiscard]] Expected<motion::PathBlock, Diagnostic> block_without_feed(
      const lang::Move& move, const motion::BlockTag& tag) const;
  [[nodiscard]] ProcessPreparation::Travel travel_of(const motion::PathBlock& block,
                                                     double length) const;

  const motion::MotionConfig& motion_;
  const ChannelConfig& channel_;
  kinematics::Transform programmed_;  // without face or cylinder transformation
  ProcessPreparation process_;
  FaceTransformation face_;
  kinematics::ToolRow row_;  // of the length that is in force
  const ChannelTables* tables_;
  double face_axis_M_ = 0.0;  // on a face: where its rotary axis stands, with all its turns; deg
  std::deque<kinematics::Transform> transforms_;         // segments in the queue point into it
  std::deque<kinematics::Transform> transforms_before_;  // of the run before
  motion::Point position_W_{};                           // of the path
};

}  // namespace stanok::channels

// SpindleGroup: the spindles of a channel: what programs, feed laws and taps ask of them, their
// angles as encoders tell them, a tap that one of them has left in its hole, and spindles that are
// axes for a while (M902, M903).
//
// The drive of such an axis follows a velocity while it is a spindle: its setpoint is the angle of
// the spindle in [0, 360) deg and its speed. After M902 the axis goes on from where the drive
// stands, and its position loop is closed; M903 opens it again. Thread: the real-time cycle. Owner:
// the channel. Invariant: the first spindle is the master; a spindle id of 0 means it.
#pragma once

#include <optional>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/axes/axis_motion.h"
#include "channels/axes/spindle.h"
#include "channels/axes/spindle_motion.h"
#include "channels/axes/tap_in_hole.h"
#include "motion/threads/spindle_observer.h"

namespace stanok::channels {

class SpindleGroup {
 public:
  // All outlive the group.
  SpindleGroup(const ChannelConstants& constants, AxisGroup& axes, const DriveGuard& drives,
               AxisMotion& motion);

  // What a program says.
  void command(const lang::SpindleCommand& command) RT_SAFE;
  void command(const lang::CuttingSpeedMode& mode) RT_SAFE;
  void stop() RT_SAFE;  // all of them
  // All stand whatever they are commanded, until they may turn again.
  void rest() RT_SAFE;
  void turn_again() RT_SAFE;
  void set_override(double factor) RT_SAFE;
  [[nodiscard]] bool any_turns() const RT_SAFE;
  // All have the speed that the next step of the program waits for.
  [[nodiscard]] bool are_settled() const RT_SAFE;

  // What a tap asks for. go_on: the next step of the program waits for the speed.
  void obey(const motion::SpindleOrder& order) RT_SAFE {
    channels::obey(spindles_[order.spindle], order);
  }
  // The speeds of feed laws and constant cutting speed, at the path as it is.
  void follow_process() RT_SAFE;
  // Periods passed without a cycle: what the drives tell now may be as old as they.
  void see_gap() RT_SAFE { angles_are_old_ = true; }
  // Tells the path how the spindles turn: before it goes on in the cycle.
  void observe() RT_SAFE;
  // One cycle; setpoints of axes that are spindles take the place of what the path says of them.
  void turn() RT_SAFE;

  [[nodiscard]] const Spindle& master() const RT_SAFE { return spindles_[0]; }
  // Once a cycle, behind the path. True: the path was given up while its tap is in the hole.
  [[nodiscard]] bool follow_tap(const motion::InterpolatorOutput& path) RT_SAFE {
    return tap_.follow(path, spindles_[path.tap.spindle].commanded());
  }
  [[nodiscard]] TapInHole& tap() RT_SAFE { return tap_; }
  [[nodiscard]] const TapInHole& tap() const RT_SAFE { return tap_; }
  // It is an axis now.
  [[nodiscard]] bool is_axis(int index) const RT_SAFE {
    return position_loop_is_closed(constants_.spindles[index].id);
  }
  // rev/min, clockwise > 0. Nothing: the channel has no such spindle.
  [[nodiscard]] std::optional<double> speed(int id) const RT_SAFE;

  // Spindles that become axes; `id` of a spindle of the channel that is one.
  [[nodiscard]] int axis_of(int id) const RT_SAFE;  // index in the channel; -1: none
  void stop(int id) RT_SAFE;
  [[nodiscard]] bool stands(int id) const RT_SAFE;
  void close_position_loop(int id) RT_SAFE;  // of a spindle that stands
  [[nodiscard]] bool position_loop_is_closed(int id) const RT_SAFE;
  void open_position_loop(int id) RT_SAFE;
  void open_position_loops() RT_SAFE;  // M2, M30, reset and the start of a program do M903

  void show(ProcessOutput& output) const RT_SAFE;

 private:
  struct AskedSpeed {
    motion::LawSpeed unit = motion::LawSpeed::unchanged;
    double value = 0.0;  // 0: none
  };
  struct EncoderNews {
    double angle_deg = 0.0;
    double age_s = 0.0;
  };

  [[nodiscard]] std::span<Spindle> spindles() RT_SAFE;
  [[nodiscard]] int index_of(int id) const RT_SAFE;  // -1: none
  [[nodiscard]] Spindle& spindle(int id) RT_SAFE;
  [[nodiscard]] bool means(int id, const Spindle& spindle) const RT_SAFE;
  void ask_speed(const AskedSpeed& speed) RT_SAFE;
  [[nodiscard]] bool is_told_by_drive(std::size_t spindle) const RT_SAFE;
  [[nodiscard]] std::optional<double> measured_angle(std::size_t spindle) RT_SAFE;

  const ChannelConstants& constants_;
  AxisGroup& axes_;
  const DriveGuard& drives_;
  AxisMotion& motion_;
  NumberedArray<Spindle, spindles_max> spindles_{};
  NumberedArray<motion::SpindleObserver, spindles_max> observers_{};
  NumberedArray<EncoderNews, spindles_max> encoder_news_{};  // the latest of each spindle
  bool angles_are_old_ = false;                              // in this cycle
  TapInHole tap_;
  AskedSpeed speed_behind_law_;  // when the present law is over
};

}  // namespace stanok::channels

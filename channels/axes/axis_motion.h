// AxisMotion: moves the axes of a channel: along the path, or by hand.
//
// The path has the axes unless they are jogged or homed; then it begins anew from where they come
// to. What no axis can do never reaches its drive: the axes stay where they were commanded last.
// Thread: the real-time cycle. Owner: the channel. Invariant: while the path is at rest and no axis
// moves by hand, path().axes are the setpoints of the axes that are no spindles.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "channels/axes/axis_group.h"
#include "channels/axes/drive_guard.h"
#include "channels/axes/manual_motion.h"
#include "channels/axes/position_loops.h"
#include "channels/axes/retrace_by_hand.h"
#include "channels/axes/scheme_table.h"
#include "channels/axes/way_aside.h"
#include "motion/interpolation/interpolator.h"
#include "motion/profile/feed_control.h"

namespace stanok::channels {

// Soft limits are guarded while a program moves the axes; moves by hand keep their own.
enum class SoftLimits : std::uint8_t { guarded, not_guarded };

enum class PathStart : std::uint8_t { at_axes, elsewhere };

class AxisMotion {
 public:
  // All outlive the motion. The axes stand at their start in the frame of the active scheme.
  AxisMotion(const motion::MotionConfig& config, const ChannelConstants& constants,
             SchemeTable& schemes, AxisGroup& axes, const DriveGuard& drives);

  // One cycle: chains that begin with a chunk below `chunk_limit` may be entered.
  [[nodiscard]] std::optional<Fault> advance(motion::PathQueue& queue,
                                             const motion::FeedControl& control,
                                             std::uint64_t chunk_limit, SoftLimits limits) RT_SAFE;
  // Behind the setpoints of the cycle.
  void close_loops() RT_SAFE { loops_.advance(path_.axes, drives_, axes_); }

  [[nodiscard]] const motion::InterpolatorOutput& path() const RT_SAFE { return path_; }
  [[nodiscard]] bool path_is_at_rest() const RT_SAFE { return interpolator_.at_rest(); }
  [[nodiscard]] bool is_in_thread() const RT_SAFE { return interpolator_.is_synchronous(); }
  [[nodiscard]] bool is_standing() const RT_SAFE {
    return interpolator_.at_rest() && !moves_by_hand();
  }
  // Jogged, homed, or led along the path that lies behind.
  [[nodiscard]] bool moves_by_hand() const RT_SAFE {
    return manual_.is_active() || retrace_.is_moving();
  }
  [[nodiscard]] motion::Point axes_M() const RT_SAFE;
  [[nodiscard]] const motion::MotionConfig& config() const RT_SAFE { return config_; }

  // In which the axes stand.
  [[nodiscard]] const kinematics::Transform& frame() const RT_SAFE { return frame_; }
  // The frame in which the axes stand; only at rest.
  void select_scheme(int scheme) RT_SAFE;
  // In the frame in which the path goes on from `start_W`. It may begin elsewhere than the axes are
  // where a length has changed behind it: they stay, away from the path.
  [[nodiscard]] PathStart go_on_in(const kinematics::Transform& frame, const motion::Point& start_W)
      RT_SAFE;
  // Another frame while nothing runs. Nothing is done where it is the frame already; nullptr: it
  // is.
  void rest_in(const kinematics::Transform* frame) RT_SAFE;
  void stand_in_scheme() RT_SAFE;  // the active one, without offsets
  // An axis is elsewhere than the path believed.
  void stand_with(int axis, double position) RT_SAFE;
  // Since it was asked last.
  [[nodiscard]] bool takes_new_frame() RT_SAFE;

  // What is left of the path is given up where it stands.
  void drop_path(motion::PathQueue& queue) RT_SAFE;
  // What moves stops where it is, without a ramp: the drives have lost their power.
  void break_off(motion::PathQueue& queue) RT_SAFE;
  void forget_path(motion::PathQueue& queue) RT_SAFE;
  // A drive that does not hold its axis knows better where it stands; only while no program runs.
  void adopt_positions(Power machine) RT_SAFE;

  [[nodiscard]] ManualMotion& manual() RT_SAFE { return manual_; }
  [[nodiscard]] const ManualMotion& manual() const RT_SAFE { return manual_; }
  void stop_by_hand() RT_SAFE;
  // While the path is held: from now on moves by hand lead the axes away from it, and back.
  void leave_path() RT_SAFE;
  // Along the path that lies behind the held one in `queue`, as RetraceByHand::go.
  [[nodiscard]] std::string_view retrace(const motion::PathQueue& queue, const RetraceOrder& order)
      RT_SAFE;
  [[nodiscard]] const RetraceByHand& retracing() const RT_SAFE { return retrace_; }
  // What was passed cannot be undone.
  void cut_history() RT_SAFE { retrace_.history().cut(); }
  // While the path is held, and the axes are where it is or aside: a length counts at once, so that
  // the path is elsewhere. The axes stay.
  void change_length(const kinematics::LengthChange& change) RT_SAFE;
  [[nodiscard]] kinematics::LengthChanges& lengths() RT_SAFE { return lengths_; }
  // The axes are not where the path is held.
  [[nodiscard]] bool is_off_path() const RT_SAFE { return aside_.is_on() || retrace_.is_on(); }
  // The next part of the way back begins; false: the axes are on the path again.
  [[nodiscard]] bool go_back(double speed) RT_SAFE;
  [[nodiscard]] const WayAside& aside() const RT_SAFE { return aside_; }
  // To where the active scheme parks its axes.
  void return_to_parking() RT_SAFE;

  void interrupt_feed(const motion::InterruptionLengths& lengths) RT_SAFE {
    interpolator_.interrupt(lengths);
  }
  void see_spindle(std::size_t index, const motion::SpindleMotion& motion) RT_SAFE {
    interpolator_.see_spindle(index, motion);
  }

  void show(ChannelOutput& output) const RT_SAFE;

 private:
  void stand() RT_SAFE;
  void move_by_hand(const motion::FeedControl& control) RT_SAFE;
  void stay_where_commanded(motion::PathQueue& queue) RT_SAFE;

  const motion::MotionConfig& config_;
  const ChannelConstants& constants_;
  SchemeTable& schemes_;
  AxisGroup& axes_;
  const DriveGuard& drives_;
  kinematics::LengthChanges lengths_;
  RetraceByHand retrace_;
  motion::Interpolator interpolator_;
  motion::InterpolatorOutput path_;
  kinematics::Transform frame_;
  bool frame_is_new_ = true;
  ManualMotion manual_;
  WayAside aside_;
  PositionLoops loops_;
};

// Of a part turned around Z, at the tool; mm. 0: the channel has no X.
[[nodiscard]] double diameter_at_tool(const AxisMotion& motion) RT_SAFE;

}  // namespace stanok::channels

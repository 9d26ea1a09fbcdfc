// AxisGroup: what the drives of a channel's axes are told: setpoints, power and brakes; and which
// of the axes are its own now, and which are spindles.
//
// An axis that another channel has keeps its last setpoint here, which nobody is shown. Thread:
// the real-time cycle. Owner: the channel. Invariant: position_code belongs to position, but for an
// axis that has just become a spindle or an axis.
#pragma once

#include <array>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/axes/channel_constants.h"
#include "channels/axes/spindle.h"
#include "channels/contract/output.h"
#include "lang/contract/environment.h"

namespace stanok::channels {

enum class Power : std::uint8_t { off, on };

// How an axis is handed from one channel to another.
struct YieldedAxis {
  double position = 0.0;
  DriveCommand drive;
};

class AxisGroup {
 public:
  // `constants` outlive the group. All axes stand at their start, without power.
  explicit AxisGroup(const ChannelConstants& constants);

  [[nodiscard]] int count() const RT_SAFE { return constants_.axis_count; }
  [[nodiscard]] lang::AxisSet all() const RT_SAFE {
    return static_cast<lang::AxisSet>((1U << count()) - 1U);
  }
  [[nodiscard]] const FixedText<16>& name(int axis) const RT_SAFE { return constants(axis).name; }
  [[nodiscard]] int named(std::string_view name) const RT_SAFE;  // -1: none
  [[nodiscard]] int machine_axis(int axis) const RT_SAFE { return constants_.machine_axis[axis]; }
  [[nodiscard]] NumberedSpan<const int> machine_axes() const RT_SAFE {
    return {constants_.machine_axis.begin(), constants_.machine_axis.begin() + count()};
  }
  [[nodiscard]] int of_machine_axis(int machine_axis) const RT_SAFE;  // -1: none
  [[nodiscard]] const AxisConstants& constants(int axis) const RT_SAFE {
    return constants_.axes[axis];
  }

  [[nodiscard]] bool owns(int axis) const RT_SAFE { return (owned_ >> axis & 1U) != 0; }
  void set_owned(int axis, bool owned) RT_SAFE;
  [[nodiscard]] YieldedAxis yield(int axis) RT_SAFE;
  void take(int axis, const YieldedAxis& yielded) RT_SAFE;

  [[nodiscard]] bool is_spindle(int axis) const RT_SAFE {
    return axis >= 0 && (spindles_ >> axis & 1U) != 0;
  }
  void become_spindle(int axis, double angle_deg) RT_SAFE;
  void become_axis(int axis, double position) RT_SAFE;

  // Power and brakes of the own axes: the free ones get power, the others a brake.
  void power(lang::AxisSet free) RT_SAFE;
  void release(lang::AxisSet axes) RT_SAFE;
  void brake(lang::AxisSet axes) RT_SAFE;
  // The first step of a change, whoever owns the axes.
  void close_brakes(lang::AxisSet axes) RT_SAFE;
  void switch_on(lang::AxisSet axes) RT_SAFE;
  [[nodiscard]] const DriveCommand& drive(int axis) const RT_SAFE { return drives_[axis]; }
  [[nodiscard]] lang::AxisSet enabled() const RT_SAFE;

  // The setpoints of this cycle from the path, or of a spindle that turns.
  void follow(const motion::JetPoint& axes_M) RT_SAFE;
  void turn(int axis, const Spindle& spindle, double speed_before) RT_SAFE;
  // Stands elsewhere than it was thought to.
  void place(int axis, double position) RT_SAFE;
  void demand_velocity(int axis, double velocity) RT_SAFE { at(axis).velocity_demand = velocity; }
  [[nodiscard]] const AxisSetpoint& setpoint(int axis) const RT_SAFE { return setpoints_[axis]; }

  void show(ChannelOutput& output) const RT_SAFE;

 private:
  [[nodiscard]] AxisSetpoint& at(int axis) RT_SAFE { return setpoints_[axis]; }
  void command(lang::AxisSet axes, const DriveCommand& drive) RT_SAFE;

  const ChannelConstants& constants_;
  AxisArray<AxisSetpoint> setpoints_{};
  AxisArray<DriveCommand> drives_{};
  lang::AxisSet owned_ = 0;
  lang::AxisSet spindles_ = 0;
};

// Those that look for a home switch, and that this channel moves now.
[[nodiscard]] lang::AxisSet axes_to_home(const AxisGroup& axes) RT_SAFE;

}  // namespace stanok::channels

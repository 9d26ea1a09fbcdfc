// What one cycle of the machine gives: setpoints of every channel, drive commands, status. Plain
// data, made in the real-time cycle.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

#include "base/axis_index.h"
#include "base/fixed_text.h"
#include "base/numbered.h"
#include "base/signals.h"
#include "channels/contract/tool_row.h"
#include "kinematics/scheme.h"
#include "lang/contract/command.h"
#include "motion/interpolation/automatic_feed.h"
#include "motion/interpolation/feed_interruption.h"
#include "motion/path/path.h"
#include "motion/segments/feed_modifier.h"

namespace stanok::channels {

inline constexpr int channels_max = 16;

enum class ChannelState : std::uint8_t {
  idle,
  ready,
  running,
  held,
  alarm
};  // CH_IDLE ... CH_ALARM

// Why a channel is held.
enum class HoldCause : std::uint8_t {
  none,
  operator_hold,
  program_stop,  // M0, M1, M60
  channel_stop,  // of another channel
  owner_failed,  // on_owner_failure
  single_block,
  sensor_fault,    // of force control
  clock_gap,       // for longer than drives go on by themselves there was no cycle
  changed_length,  // in a hold, behind which the path was prepared
};
// For people: "feed hold by an operator"; empty for none.
[[nodiscard]] std::string_view text_of(HoldCause cause);

// What a channel waits for; for displays.
enum class WaitCause : std::uint8_t {
  nothing,
  dwell,
  spindle,  // its speed
  brakes,
  end,      // of the run of another channel
  mark,     // partners
  input,    // a signal
  channel,  // what was asked of another channel
  machine,  // an answer that takes no time to speak of
};
struct Wait {
  WaitCause cause = WaitCause::nothing;
  std::int32_t number = 0;     // of the mark or input
  std::uint32_t channels = 0;  // that are waited for, bit k: channel with id k
};
// For people: "end", "mark"; empty for nothing.
[[nodiscard]] std::string_view name_of(WaitCause cause);

// Setpoint of one axis at the cycle instant, machine axes M: mm or deg, per s, s^2, s^3; and the
// integer codes of docs/developer/motion.md#codes.
struct AxisSetpoint {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
  std::int64_t position_code = 0;  // increments
  std::int64_t velocity_code =
      0;  // increments per cycle x kmv, mean velocity of the cycle that ends at position_code
  // What the drive is asked for: the velocity, or, where the cycle closes the position loop, U of
  // the position controller.
  double velocity_demand = 0.0;
};

// What the drive of an axis shall take for its position: an offset to what it counts.
struct DriveReference {
  bool accepted = false;  // from this cycle on
  double offset = 0.0;    // mm or deg
};

// Power and brake of one axis, as its drive shall have them.
struct DriveCommand {
  bool enabled = false;
  bool brake_closed = true;
  bool follows_velocity = false;  // the axis is a spindle now; else its position loop is closed
  DriveReference reference{};
};

// What the drives told, as far as it changes the outcome.
struct AxisFeedback {
  double position = 0.0;
  double setpoint = 0.0;  // what the drive was told in the exchange that brought this position
  double velocity = 0.0;
  bool valid = false;  // an answer not older than the bus timeout
  bool fault = false;
  bool enabled = false;     // the drive holds the axis (CiA 402: operation enabled)
  bool referenced = false;  // the position belongs to the machine
  bool brake_closed = true;
  bool home_switch = false;  // it stands on its home switch
  bool limit_negative = false;
  bool limit_positive = false;
  bool strays = false;            // too far from its setpoint for longer than a disturbance lasts
  double position_offset = 0.0;   // of what the drive counts
  double index_position = 0.0;    // at the latest index pulse
  std::uint32_t index_count = 0;  // pulses so far

  friend bool operator==(const AxisFeedback&, const AxisFeedback&) = default;
};

// What the sensors of one spindle tell; not a number: no trustworthy value.
struct SpindleSensors {
  double power_w = std::numeric_limits<double>::quiet_NaN();
  double vibration_um = std::numeric_limits<double>::quiet_NaN();
  double vibration_hz = std::numeric_limits<double>::quiet_NaN();
};

// What the programs of a channel announced with #workpiece and #workpiece_pos; for displays, no
// effect on motion.
struct Workpiece {
  std::uint32_t announcements = 0;  // of either kind so far
  std::uint32_t shapes = 0;         // #workpiece alone
  bool has_shape = false;
  bool has_position = false;
  lang::WorkpieceShape shape;
  FixedText<lang::blank_path_max + 1> file;  // of the shape
  kinematics::Frame frame;                   // W in B where the shape was announced
  lang::WorkpiecePosition position;
};

// The tool in the spindle or at the working place of the turret; number 0: none.
struct ToolAtWork {
  std::int32_t number = 0;
  std::int32_t edge = 1;

  friend bool operator==(const ToolAtWork&, const ToolAtWork&) = default;
};

// What a spindle of the channel is asked for in this cycle: its ramps are made.
struct SpindleSetpoint {
  std::int32_t id = 0;              // 0: there is none
  double rev_per_min = 0.0;         // clockwise > 0
  double target_rev_per_min = 0.0;  // to which the ramp leads
};
inline constexpr int spindles_max = 4;

// Feed and speed of the cutting process, and the law that they follow.
struct ProcessOutput {
  motion::LawKind law = motion::LawKind::none;
  std::uint64_t increments = 0;  // that the law has made
  bool stands = false;           // on the equivalent dwell path of an interrupted feed
  motion::InterruptionLengths interruption{};  // by the operator
  std::uint64_t interruptions = 0;             // so far
  // Laws formed in the cycle, as far as the channel has them.
  struct Automatic {
    motion::LawKind law = motion::LawKind::none;
    motion::ModuleState state = motion::ModuleState::reset;
    double part = 1.0;  // of the programmed feed
  };
  std::array<Automatic, 2> automatic{};
  double feed_mm_per_min = 0.0;          // S, programmed, before override; 0 in rapid
  double feed_mm_per_rev = 0.0;          // S_0 = S / n; 0: the spindle stands
  double spindle_rev_per_min = 0.0;      // n of the master spindle; clockwise > 0
  double cutting_speed_m_per_min = 0.0;  // v at the diameter on which the tool stands
  NumberedArray<SpindleSetpoint, spindles_max> spindles{};
  bool has_force_control = false;
  motion::ForceStatus force;
};

// What the cycle has seen of the work of a preparation. `resets` counts the resets that are over;
// all else is counted since the latest of them, so that two runs can be compared however far ahead
// the preparation was at a reset.
struct Arrivals {
  static constexpr std::uint64_t everything = std::numeric_limits<std::uint64_t>::max() / 2;

  std::uint64_t resets = 0;
  std::uint64_t chunks = 0;
  std::uint64_t items = 0;
  std::uint64_t riders = 0;
  std::uint64_t remarks = 0;

  friend bool operator==(const Arrivals&, const Arrivals&) = default;
};

// The way back along a path.
struct RetraceState {
  std::uint64_t blocks_back = 0;  // that the axes can go back, the current one included
  std::uint32_t oldest_line = 0;  // how far: a line of the program; 0: no way
  std::uint32_t line = 0;         // where the axes are on it; 0: on the path itself
};

struct ChannelOutput {
  std::int32_t id = 0;
  std::int32_t axis_count = 0;
  ChannelState state = ChannelState::idle;
  bool moving = false;
  bool running = false;   // a program run is under way, held or not
  std::uint32_t run = 0;  // of the channel, from 1
  bool waiting = false;   // in channel_wait, a mark, a dwell
  Wait wait;              // for what
  HoldCause hold_cause = HoldCause::none;
  // Of a held program: what an operator did to it.
  bool aside = false;  // axes were moved away from where the path is held
  RetraceState retrace;
  bool spindles_off = false;  // its spindles are stopped, its coolant is off
  bool coolant_off = false;
  bool tap_in_hole = false;  // a tap was stopped there, and no run has it
  std::int32_t scheme = 0;
  // Of what took effect last, a block of the path or an item beside it; line 0: no program runs.
  // Its situation is that of everything here, also while nothing runs.
  motion::BlockTag tag;
  FixedText<96> program;        // of the run, from its first current block on, also when it is over
  double feed_commanded = 0.0;  // mm/s before override; 0 in rapid
  double path_speed = 0.0;      // mm/s
  bool on_arc = false;          // the path is an arc or a helix here
  double feed_override = 1.0;
  ProcessOutput process;
  Workpiece workpiece;
  lang::CoolantCommand coolant;
  ToolAtWork tool;
  ToolRow tool_row;              // of that tool, as the table has it in this cycle
  motion::JetPoint point_W{};    // programmed point in W with time derivatives, channel axis order
  kinematics::Frame work_frame;  // W in B, for displays
  kinematics::PointMode point_mode = kinematics::PointMode::axes;  // B turns with the table: tip
  AxisArray<AxisSetpoint> axes{};
  AxisArray<DriveCommand> drives{};
  Arrivals arrivals{};                 // that this cycle saw
  bool has_feedback = false;           // of drives; without, ideal ones are assumed
  AxisArray<AxisFeedback> feedback{};  // that this cycle acted on
};

// Something that happened, for logs and operators; text is made elsewhere from the code
// (base/catalogue.h).
struct Event {
  std::int64_t cycle = 0;
  std::int32_t channel = 0;  // 0: the machine
  FixedText<8> code;         // "E6010", "A1001"; "" = information
  motion::BlockTag tag;
  FixedText<240> text;
};

struct CycleOutput {
  std::int64_t cycle = 0;
  std::int32_t channel_count = 0;
  NumberedArray<ChannelOutput, channels_max> channels{};
  Signals signals;

  // Of the channels that the machine has, in their order.
  [[nodiscard]] std::span<const ChannelOutput> of_channels() const {
    return {channels.begin(), channels.begin() + channel_count};
  }
  // nullptr: the machine does not have it.
  [[nodiscard]] const ChannelOutput* of_channel(int id) const {
    for (const ChannelOutput& channel : of_channels()) {
      if (channel.id == id) return &channel;
    }
    return nullptr;
  }
};

static_assert(std::is_trivially_copyable_v<CycleOutput> && std::is_trivially_copyable_v<Event>);

}  // namespace stanok::channels

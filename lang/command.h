// Commands: what a program asks of its channel, as data. The interpreter makes them, channels
// executes them.
//
// All modal state that matters to a command is resolved into it: a Move holds absolute ends in mm
// and deg, the arc's centre, the feed and the path mode. A command knows nothing of motion planning
// or kinematics. Frames: W active workpiece system, B base of the kinematic scheme (W without work
// offset, G52, G92, rotation), M machine axes. Without tip transformation M = B + zero of the
// scheme + tool length. Lengths mm, angles deg, feeds in the unit of their FeedMode, in the frame W
// (the active workpiece system: work offset, G52, G92, rotation) unless `machine_coordinates` says
// M. Axis values stand in the order of the channel's axes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace stanok::lang {

inline constexpr int axes_max = 8;

using AxisValues = std::array<double, axes_max>;

// Bit k stands for axis k of the channel.
using AxisSet = std::uint16_t;

enum class Plane : std::uint8_t { xy, zx, yz };                                   // G17, G18, G19
enum class FeedMode : std::uint8_t { per_minute, per_revolution, inverse_time };  // G94, G95, G93
enum class PathMode : std::uint8_t { exact_path, exact_stop, continuous };        // G61, G61.1, G64

// How a path may be rounded and where it stops. A tolerance below zero means "the channel's
// default".
struct PathControl {
  PathMode mode = PathMode::continuous;
  double tolerance_mm = -1.0;      // G64 P
  double straightening_mm = -1.0;  // G64 Q
};

enum class MoveKind : std::uint8_t { rapid, line, arc };

struct Move {
  MoveKind kind = MoveKind::rapid;
  bool machine_coordinates = false;  // G53: `end` is in M for the words named
  bool stop_at_end = false;          // G9 in this block
  AxisSet words = 0;                 // axes programmed in this block
  AxisValues end{};                  // all axes, programmed or not
  double feed = 0.0;  // mm/min (deg/min without linear words), mm/rev or 1/min; rapid: unused
  FeedMode feed_mode = FeedMode::per_minute;
  PathControl path;
  // Arc only. The two axes of the plane follow G17/G18/G19; every other programmed axis moves
  // linearly along (helix).
  Plane plane = Plane::xy;
  bool counter_clockwise = false;  // seen from the positive third axis of the plane
  int turns = 1;                   // P: 1 = the arc itself, +1 per additional full turn
  std::array<double, 2> centre{};  // absolute, in the plane's (first, second) axes: XY, ZX, YZ
};

struct Dwell {
  double seconds = 0.0;
};

enum class SpindleAction : std::uint8_t { set_speed, clockwise, counter_clockwise, stop, orient };

struct SpindleCommand {
  int spindle = 0;  // id of the machine file; 0 = the channel's master spindle, -1 = all
  SpindleAction action = SpindleAction::stop;
  double speed_rev_per_min = 0.0;
  double angle_deg = 0.0;  // orient
};

struct CoolantCommand {
  bool mist = false;   // M7
  bool flood = false;  // M8
};

struct ToolPrepare {
  int tool = 0;
};
struct ToolChange {
  int tool = 0;
};

enum class LengthMode : std::uint8_t { off, length, tip };  // G49, G43/G43.1/G43.2, G43.4

// Tool length compensation as resolved from the tool table. The axes do not move; without
// LengthMode::tip before and after, the interpreter moves its own position by the change of
// `offset_mm`; else it follows up with RequestKind::sync.
struct ToolLength {
  LengthMode mode = LengthMode::off;
  int tool = 0;                       // H, or the active tool
  std::array<double, 3> offset_mm{};  // along X, Y, Z of the machine when not tilted
};

// The complete frame W -> base of the scheme: p_B = rotation * p_W + offset. Sent whenever it
// changes.
struct FrameChange {
  int work_offset = 1;        // 1 = G54 ... 9 = G59.3, 10.. = G54.1 P1..
  AxisValues offset{};        // work offset + G52 + G92, per axis (deg for rotary axes)
  double rotation_deg = 0.0;  // G68 in `rotation_plane`
  Plane rotation_plane = Plane::xy;
};

struct OverrideControl {
  bool feed_enabled = true;
  bool spindle_enabled = true;
};

struct Message {
  std::string text;
  enum class Kind : std::uint8_t { message, warning, log } kind = Kind::message;
};

// Modal state for displays and `interpret`; sent when it changed, no effect on motion.
struct ModalReport {
  std::string text;
};

enum class StopKind : std::uint8_t { program_stop, optional_stop, pallet_stop };  // M0, M1, M60

struct ProgramStop {
  StopKind kind = StopKind::program_stop;
};

enum class ProgramEndKind : std::uint8_t {
  end,
  end_and_rewind,
  end_of_text,
  restart
};  // M2, M30, -, M99

struct ProgramEnd {
  ProgramEndKind kind = ProgramEndKind::end;
};

// A request drains the channel's queue; the interpreter then waits for an Answer (sync point).
enum class RequestKind : std::uint8_t {
  sync,          // nothing but waiting for standstill; the answer carries the position
  kinematics,    // number = scheme, channel
  channel_load,  // channel, text = program
  channel_start,
  channel_run,
  channel_wait,  // seconds: timeout, < 0 = none
  channel_stop,
  channel_reset,
  channel_state,
  spindle_to_axis,   // M902: number = spindle
  axis_to_spindle,   // M903
  terminate,         // number = code, text
  tool_table_write,  // effects of settable_tool, settable_zs: text = parameter, number = index,
                     // value
  offset_table_write,
  machine_value,  // text = system variable, number = index
};

struct Request {
  RequestKind kind = RequestKind::sync;
  int channel = 0;
  int number = 0;
  int index = 0;
  double seconds = -1.0;
  double value = 0.0;
  std::string text;
  bool statement = false;  // statement form: a false answer raises an alarm in the calling channel
};

// What the channel answers to a Request. `position_B` is where the programmed point (tool tip)
// stands, so that incremental programming goes on from where the axes really are.
struct Answer {
  bool ok = true;
  double number = 0.0;
  std::string text;  // string value, or the reason of a false: "E7001 file not found: a.nc"
  AxisValues position_B{};
  bool position_valid = false;
};

using Payload = std::variant<Move, Dwell, SpindleCommand, CoolantCommand, ToolPrepare, ToolChange,
                             ToolLength, FrameChange, OverrideControl, Message, ModalReport,
                             ProgramStop, ProgramEnd, Request>;

// Where a command comes from: the program file (index in the job's file list) and the line,
// 1-based.
struct Origin {
  std::uint16_t file = 0;
  std::uint32_t line = 0;
};

struct Command {
  Origin origin;
  std::uint64_t block = 0;  // running number of the ISO block in this run, from 1
  Payload payload;
};

}  // namespace stanok::lang

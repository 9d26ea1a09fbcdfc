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

#include "base/axis_index.h"
#include "base/rotation.h"

namespace stanok::lang {

using stanok::axes_max;

using AxisValues = AxisArray<double>;

// Bit k stands for axis k of the channel.
using AxisSet = std::uint16_t;
[[nodiscard]] constexpr AxisSet axis_bit(AxisIndex axis) {
  return static_cast<AxisSet>(axis.bit());
}

enum class Plane : std::uint8_t { xy, zx, yz };                                   // G17, G18, G19
enum class FeedMode : std::uint8_t { per_minute, per_revolution, inverse_time };  // G94, G95, G93
enum class PathMode : std::uint8_t { exact_path, exact_stop, continuous };        // G61, G61.1, G64

// How a path may be rounded and where it stops. A tolerance below zero means "the channel's
// default".
struct PathControl {
  PathMode mode = PathMode::continuous;
  double tolerance_mm = -1.0;      // G64 P
  double straightening_mm = -1.0;  // G64 Q
  double orientation_deg = -1.0;   // of rotary axes, within a move on the great circle
};

enum class MoveKind : std::uint8_t { rapid, line, arc };

// How the feed, and with it perhaps the speed of the spindle, steps along the path.
// Feeds in mm/min or mm/rev as `feed_mode` says, lengths of path in mm, speeds of the master
// spindle in rev/min or m/min as `speed` says. Each value by itself is checked: steps and lengths
// are multiples of the increments of the machine. Whether feed and speed stay positive over the
// path is known only where the path is.
struct FeedLaw {
  enum class Kind : std::uint8_t {
    off,
    linear,       // S_n, then a step of dS after every |dl|; with or without speed
    modulated,    // Smin, n_s steps of dS up, n_s down, and so on
    interrupted,  // a way L_B at the programmed feed, then the time that L_A would take, standing
    curve,        // feeds over points of the path
  };
  enum class Speed : std::uint8_t { unchanged, rev_per_min, m_per_min };
  struct CurvePoint {
    double path_mm = 0.0;
    double feed = 0.0;
    double speed = 0.0;

    bool operator==(const CurvePoint&) const = default;
  };

  Kind kind = Kind::off;
  FeedMode feed_mode = FeedMode::per_minute;
  double feed_first = 0.0;    // S_n, Smin; 0: the law leaves the feed to F
  double feed_step = 0.0;     // dS > 0; linear: its direction is that of `falls`; 0: S_k = S_n
  bool falls = false;         // linear: dl < 0, or S_k < S_n
  double path_step_mm = 0.0;  // |dl|; 0: follows from the length of the block and `feed_last`
  double feed_last = 0.0;     // S_k, where the steps end; 0: not given; modulated: Smax
  int steps = 0;              // n_s of the modulated law
  double stand_mm = 0.0;      // L_A
  double cut_mm = 0.0;        // L_B
  Speed speed = Speed::unchanged;
  double speed_first = 0.0;       // n_n, v_n
  double speed_step = 0.0;        // dn, dv, signed
  double speed_last = 0.0;        // n_k, v_k, from which the step follows; 0: `speed_step` is given
  std::vector<CurvePoint> curve;  // the first at way 0

  bool operator==(const FeedLaw&) const = default;
  // Whether the law says the feed itself, instead of F.
  [[nodiscard]] bool gives_feed() const { return feed_first > 0.0; }
};

// A law for the motion that follows: until the next change, or for the next Move or SplineMove
// only. The feed of a move under a law that gives the feed is the first one of the law.
struct FeedLawChange {
  FeedLaw law;
  bool of_next_block = false;  // the modal law is suspended meanwhile and its path does not count

  bool operator==(const FeedLawChange&) const = default;
};

struct Move {
  MoveKind kind = MoveKind::rapid;
  bool machine_coordinates = false;  // G53: `end` is in M for the words named
  bool stop_at_end = false;          // G9 in this block
  AxisSet words = 0;                 // axes programmed in this block
  AxisValues end{};                  // all axes, programmed or not
  double feed = 0.0;  // mm/min (deg/min without linear words), mm/rev or 1/min; rapid: unused
  FeedMode feed_mode = FeedMode::per_minute;
  bool aligns_tool = false;  // G53.1, G53.6: the rotary axes of `words` turn it to the plane
  bool is_tap = false;       // with a floating chuck: the feed must be that of lead and spindle
  PathControl path;
  // Arc only. The two axes of the plane follow G17/G18/G19; every other programmed axis moves
  // linearly along (helix).
  Plane plane = Plane::xy;
  bool counter_clockwise = false;  // seen from the positive third axis of the plane
  int turns = 1;                   // P: 1 = the arc itself, +1 per additional full turn
  // Absolute, in the plane's (first, second) axes: XY, ZX, YZ; XC in mm on the polar face; on the
  // cylinder Plane::yz is its surface, C as mm along it and Z.
  std::array<double, 2> centre{};
};

// G5, G5.1, G5.2: one NURBS curve in the plane of `base`, from its start to base.end. Other axes
// move linearly with the parameter. Knots are uniform, clamped at both ends.
struct SplineMove {
  Move base;  // kind, end, feed, path mode, plane
  int degree = 3;
  std::vector<std::array<double, 2>> points;  // control points after the start, absolute in W
  std::vector<double> weights;                // start first; empty: all 1
};

// G33, G33.1, G74, G84 and thread cycles: a line on which the path follows the angle of a spindle.
// The lead is measured along the path. A rigid tap goes to the end, reverses the spindle there and
// comes back to where it began.
struct SynchronousMove {
  enum class Kind : std::uint8_t { thread, rigid_tap };
  Move line;  // end and path mode; the feed comes from the spindle
  Kind kind = Kind::thread;
  int spindle = 0;  // as in SpindleCommand
  double lead_mm_per_rev = 0.0;
  double start_angle_deg = 0.0;      // Q
  double return_speed_factor = 1.0;  // G33.1 I
  double dwell_s = 0.0;              // rigid_tap: at the end of the way in
  bool runs_out = false;             // thread: out of it; only its end has to be reached
};

// G38.2 to G38.5: a line that ends when the probe changes. RequestKind::probe_result follows it.
inline constexpr int skip_inputs_last = 4;

struct ProbeMove {
  Move line;
  int input = 1;                  // P of G31: 1, the probe, to skip_inputs_last
  bool until_contact = true;      // .2, .3; else until contact is lost
  bool alarm_when_missed = true;  // .2, .4
};

enum class Transformation : std::uint8_t { off, polar_face, cylinder };  // G13.1, G12.1, G7.1

// Off, the rotary axis is one in deg. On the polar face it is programmed in mm and is, after X, the
// second axis of Plane::xy; on the cylinder it stays in deg. RequestKind::sync follows.
struct TransformationChange {
  Transformation kind = Transformation::off;
  double radius_mm = 0.0;  // cylinder
  int rotary_axis = -1;    // index in the channel
  // Whose place in the planes the rotary axis has. Cylinder: 1 of Y (about Z or X), 0 of X (about
  // Y); face: the one behind the linear axis across it, 1 about Z, 2 about X, 0 about Y.
  int replaced = 1;
};

struct Dwell {
  double seconds = 0.0;
};

enum class SpindleAction : std::uint8_t { set_speed, clockwise, counter_clockwise, stop, orient };

// M19 P: the direction of the turn to the angle.
enum class OrientWay : std::uint8_t { shortest, clockwise, counter_clockwise };

struct SpindleCommand {
  int spindle = 0;  // id of the machine file; 0 = the channel's master spindle, -1 = all
  SpindleAction action = SpindleAction::stop;
  double speed_rev_per_min = 0.0;
  double cutting_speed_m_per_min = 0.0;  // G96 holds and gives the speed; 0: it does not
  double angle_deg = 0.0;                // orient
  OrientWay way = OrientWay::shortest;
  double timeout_s = -1.0;  // orient, M19 Q; below zero: none
};

// G96 and G97.
struct CuttingSpeedMode {
  int spindle = 0;        // as in SpindleCommand
  bool constant = false;  // G96
  double speed_m_per_min = 0.0;
  double limit_rev_per_min = 0.0;  // D; 0: none
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
  bool by_number_only = false;  // M61: nothing moves
  int edge = 1;
};

enum class LengthMode : std::uint8_t { off, length, tip };  // G49, G43/G43.1/G43.2, G43.4/G43.5

// Tool length compensation: `offset_mm` is in force, the rest says where it came from. Kept, saved
// and restored as one value; never put together again from its parts but by an operator's change
// of the row. The axes do not move; without LengthMode::tip before and after, the interpreter moves
// its own position by the change of `offset_mm`; else it follows up with RequestKind::sync.
struct ToolLength {
  enum class Row : std::uint8_t { none, added, subtracted };  // G43.1, H0; G43; G44

  LengthMode mode = LengthMode::off;
  int tool = 0;  // H, or the active tool; 0 with H0
  int edge = 1;
  Row row = Row::none;                // how the row of `tool` and `edge` is in `offset_mm`
  std::array<double, 3> base_mm{};    // to which it was added (G43.2)
  std::array<double, 3> offset_mm{};  // along X, Y, Z of the machine when not tilted
  // Number of the newest write of the tables behind which the row was read (Tables::in_force).
  std::uint64_t version = std::numeric_limits<std::uint64_t>::max();

  // Whether both say the same, whenever they were read.
  friend bool operator==(const ToolLength& a, const ToolLength& b) {
    return a.mode == b.mode && a.tool == b.tool && a.edge == b.edge && a.row == b.row &&
           a.base_mm == b.base_mm && a.offset_mm == b.offset_mm;
  }
};

// The complete frame W -> base of the scheme: p_B = rotation * p_W + offset. Sent whenever it
// changes.
struct FrameChange {
  int work_offset = 1;  // 1 = G54 ... 9 = G59.3, 10.. = G54.1 P1..
  AxisValues offset{};  // per axis (deg for rotary axes)
  Rotation rotation;    // of the channel's X, Y, Z (G68, G10 L2 R)
};

struct OverrideControl {
  bool feed_enabled = true;       // M48 M49 M50
  bool spindle_enabled = true;    // M48 M49 M51
  bool adaptive_enabled = false;  // M52
  bool feed_stop_enabled = true;  // M53
};

// #adaptive: a command to force control. Values that are not given are 0.
struct ForceControl {
  enum class Kind : std::uint8_t { off, force, oscillate, vibration_on, vibration_off, depth };
  Kind kind = Kind::off;
  double force_n = 0.0;   // P_z
  double feed_min = 0.0;  // clamps, mm/min, or mm per revolution
  double feed_max = 0.0;
  bool per_revolution = false;
  double oscillation_n = 0.0;   // P_osc
  double oscillation_hz = 0.0;  // f
  double level_um = 0.0;        // permissible vibration
  double reduced_mass_kg = 0.0;
  double depth_mm = 0.0;  // of the cut
};

// M62 to M65, M67, M68.
struct OutputCommand {
  bool analog = false;
  bool with_motion = false;  // M62, M63, M67: at the start of the next move
  int number = 0;            // P, E
  double value = 0.0;        // digital: 1 on, 0 off
};

// M100 to M899: an output of the machine builder's.
struct MachineFunction {
  int code = 0;
  double p = 0.0;
  double q = 0.0;
};

// mark_set, mark_clear, mark_wait_soft: they travel in the queue.
struct MarkCommand {
  enum class Kind : std::uint8_t { set, clear, wait_soft };
  Kind kind = Kind::set;
  int id = 0;
  std::uint32_t channels = 0;  // wait_soft: bit k stands for channel k, the own one included
};

// The blank of #workpiece without the name of its file.
struct WorkpieceShape {
  int type = 0;            // 0 box, 1 cylinder along Z, 2 the solid of an STL file
  int machining_type = 0;  // 0 milling, 1 turning
  double screen_resolution_mm = 0.0;
  std::array<double, 3> size_mm{};  // cylinder: diameter, inner diameter, length; file: its box
  // Program zero from the corner with the smallest coordinates; file: in its coordinates.
  std::array<double, 3> zero_mm{};
  double scale = 1.0;             // mm for a unit of the file
  std::uint64_t fingerprint = 0;  // of the file as it was when the program was loaded
};

// The longest path of an STL file, bytes.
inline constexpr std::size_t blank_path_max = 255;

// #workpiece, for displays and simulation.
struct WorkpieceAnnouncement {
  WorkpieceShape shape;
  std::string file;  // path; of type 2
};

// #workpiece_pos: in the machine system.
struct WorkpiecePosition {
  std::array<double, 3> position_mm{};
  std::array<double, 3> angles_deg{};  // Euler, intrinsic Z-X'-Z''
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
  restart,
  end_of_line
};  // M2, M30, -, M99, line of an operator

struct ProgramEnd {
  ProgramEndKind kind = ProgramEndKind::end;
  bool compensated = false;  // radius compensation is active there
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
  spindle_to_axis,     // M902: number = spindle
  axis_to_spindle,     // M903
  tap_out,             // G30 P99
  terminate,           // number = code, text
  tool_table_write,    // number = tool, index = edge, channel = number of the value, value
  offset_table_write,  // channel = table, number = page, index = axis of the channel, -1 (there is
                       // none) or rotation_of_offset, value
  tool_table_read,     // as the writes; the answer carries the value
  offset_table_read,
  machine_value,    // text = system variable, number = index
  probe_result,     // after a ProbeMove; ok: the probe changed, probe_B is where
  input_wait,       // M66: number = input, index = mode L, flag analog, seconds; number: the value
  mark_wait,        // number = id, channels
  mark_state,       // channel, number = id
  shared_read,      // text = name, index = element
  shared_write,     // the same, value or value_text
  program_restart,  // M99 in the main program: it begins again, or with a false answer ends
  shared_combine,   // as shared_write: the value that is there and this one, by `combination`
};

// What += and its like make of the value that a shared variable has; of texts add joins them.
enum class Combination : std::uint8_t { add, subtract, multiply, divide };

// Stands for the rotation of a work offset (G10 L2 R) where its axes have indices.
inline constexpr int rotation_of_offset = -2;

struct ProgramRequest {
  RequestKind kind = RequestKind::sync;
  int channel = 0;
  int number = 0;
  int index = 0;
  bool analog = false;
  std::uint32_t channels = 0;  // bit k stands for channel k
  double seconds = -1.0;
  double value = 0.0;
  std::string text;
  std::string value_text;
  Combination combination = Combination::add;
  bool statement = false;  // statement form: a false answer raises an alarm in the calling channel
};

// What the channel answers to a ProgramRequest. `position_B` is where the programmed point (tool
// tip) stands, so that incremental programming goes on from where the axes really are.
struct Answer {
  bool ok = true;
  bool raises = false;  // the call itself was an error: it ends the program, whatever its form
  double number = 0.0;
  std::string text;  // string value, or the reason of a false: "E7001 file not found: a.nc"; lines
                     // after the first are notes to it
  AxisValues position_B{};
  bool position_valid = false;
  AxisValues probe_B{};
  bool rehearsed = false;  // no probe was there: it is taken to change at the end of its way
};

using Payload =
    std::variant<Move, SplineMove, SynchronousMove, ProbeMove, FeedLawChange, TransformationChange,
                 Dwell, SpindleCommand, CuttingSpeedMode, CoolantCommand, ToolPrepare, ToolChange,
                 ToolLength, FrameChange, OverrideControl, ForceControl, OutputCommand,
                 MachineFunction, MarkCommand, WorkpieceAnnouncement, WorkpiecePosition, Message,
                 ModalReport, ProgramStop, ProgramEnd, ProgramRequest>;

// The Move in a payload that moves axes along a path, or nullptr.
[[nodiscard]] inline const Move* move_of(const Payload& payload) {
  if (const auto* move = std::get_if<Move>(&payload)) return move;
  if (const auto* spline = std::get_if<SplineMove>(&payload)) return &spline->base;
  if (const auto* synchronous = std::get_if<SynchronousMove>(&payload)) return &synchronous->line;
  if (const auto* probe = std::get_if<ProbeMove>(&payload)) return &probe->line;
  return nullptr;
}

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

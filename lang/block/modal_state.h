// The modal state of a channel program: what earlier blocks left in force.
//
// A value: copied to be saved, replaced to be reset. Frames: the position is kept in the active
// workpiece system W, so that a programmed coordinate stays what was programmed to the last bit;
// p_B = rotation * p_W + offset, see frame(). Between the words of a program and W stand scaling
// and mirror (lang/block/coordinate_map.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/diagnostic.h"
#include "lang/block/coordinate_map.h"
#include "lang/block/work_frame.h"
#include "lang/contract/active_codes.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"

namespace stanok::lang {

// Coordinates closer than this (mm or deg) are the same: far below any axis resolution, far above
// the rounding of sums of offsets.
inline constexpr double position_noise = 1e-9;
inline constexpr double mm_per_inch = 25.4;
inline constexpr double m_per_foot = 0.3048;
inline constexpr std::size_t spindles_max = 16;

// A sequence of drilling cycles: what stays valid from hole to hole. Levels along the tool axis in
// W, mm.
struct DrillingCycle {
  double initial_level = 0.0;
  double retract_level = 0.0;  // R
  double bottom = 0.0;         // Z
  double peck = 0.0;           // Q
  double dwell_s = -1.0;       // P; below zero: none
  double lead = 0.0;           // K of tapping; 0: from F
  bool has_retract_level = false;
  bool has_bottom = false;
};

// A sequence of G77, G78 or G79: W, radii, mm.
struct TurningCycle {
  double x = 0.0;
  double z = 0.0;
  double taper = 0.0;  // R
  double lead = 0.0;   // F of G78
  bool has_x = false;
  bool has_z = false;
};

// First block of G76 without K, mm.
struct ThreadSettings {
  int spring_passes = 0;
  int run_out_tenths = 0;  // length of the run-out in tenths of the lead
  double angle_deg = 0.0;  // of the tool
  double smallest_cut = 0.0;
  double last_cut = 0.0;
};

// First block of G71 or G72, mm.
struct RoughingSettings {
  double depth = 0.0;    // U of G71 (a radius), W of G72
  double retract = 0.0;  // R
};

// G68: W is turned about a centre in the system that G54, G52 and G92 make.
struct ProgrammedRotation {
  Rotation rotation;  // by `angle_deg` about `axis`
  std::array<double, 3> axis{};
  double angle_deg = 0.0;
  std::array<double, 3> centre{};  // X, Y, Z
};

// G41 and G42 as selected: the tool is `radius_mm` off the contour, on its left or right side in
// `plane`.
struct RadiusCompensation {
  enum class Side : std::uint8_t { off, left, right };
  Side side = Side::off;
  Plane plane = Plane::xy;
  int orientation = 0;  // of a lathe tool, 0 to 9
  double radius_mm = 0.0;

  [[nodiscard]] bool on() const { return side != Side::off; }
  bool operator==(const RadiusCompensation&) const = default;
};

// First and second coordinate in the plane of an arc or curve, mm.
using CurvePoint = std::array<double, 2>;

// What a spline leaves to the next block.
struct ProgrammedCurve {
  CurvePoint arrival{};  // G5: from the end to its second control point, in W

  // G5.2, until G5.3: control points with the start, in W.
  int order = 0;
  std::vector<CurvePoint> points;
  std::vector<double> weights;

  [[nodiscard]] bool open() const { return !points.empty(); }
};

struct ModalState {
  // The active code of each group in tenths (G1 = 10), and the line that set it; 0 = default.
  ActiveCodes codes{};
  GroupArray<std::uint32_t> lines{};

  // F as programmed, and with lengths in mm. Not known at start and after a change of feed mode.
  bool feed_known = false;
  double feed_programmed = 0.0;
  double feed_mm = 0.0;
  // The modal feed law. While it gives the feed, F counts as not known, and is known again behind
  // it.
  FeedLaw feed_law;
  bool feed_behind_law = false;

  double speed_rev_per_min = 0.0;                         // of the master spindle
  bool spindle_running = false;                           // any
  std::array<double, spindles_max> speeds_rev_per_min{};  // in the order of the channel's spindles
  std::uint16_t running_spindles = 0;                     // bit k: the k-th of them turns
  AxisSet converted_axes = 0;                             // that spindles have become with M902
  double orient_angle_deg = 0.0;                          // of the last M19
  int cutting_spindle = 0;                                // of G96, as in SpindleCommand
  double cutting_speed_m_per_min = 0.0;
  double speed_limit_rev_per_min = 0.0;  // of G96: D, G50 S, G92 S; 0: none
  bool mist = false;
  bool flood = false;
  bool feed_override = true;
  bool spindle_override = true;
  bool adaptive_feed = false;  // M52
  bool feed_stop = true;       // M53

  int tool_prepared = -1;  // T; -1: none since the program started
  int tool_active = 0;
  int tool_edge = 1;

  ToolLength length;
  std::array<double, 3> length_base_mm{};  // to which the length of the edge was added (G43.2)
  int length_edge = 1;                     // of length.tool
  // #tool_overhang: what it adds to the programmed position of `overhang_axis` (-1: none), mm.
  int overhang_axis = -1;
  double overhang_shift_mm = 0.0;
  RadiusCompensation compensation;
  PathControl path;
  DrillingCycle cycle;
  TurningCycle turning;
  ThreadSettings thread;
  RoughingSettings turning_roughing;  // G71
  RoughingSettings facing_roughing;   // G72

  int work_offset_number = 1;     // 1 = G54
  AxisValues work_offset{};       // of the table
  Rotation work_offset_rotation;  // G10 L2 R, of the table
  AxisValues local_shift{};       // G52
  AxisValues axis_shift{};        // G92
  bool axis_shift_active = true;  // false after G92.2
  ProgrammedRotation rotation;    // G68
  CoordinateMap map;              // G51, G51.1
  GeometryAxes geometry{};
  int transformed_axis = -1;        // rotary axis of G12.1 or G7.1; -1: off
  double cylinder_radius_mm = 0.0;  // G7.1
  ProgrammedCurve curve;
  AxisValues position_W{};

  [[nodiscard]] CodeNumber code(Group group) const { return codes[group]; }
  void set(Group group, CodeNumber number, std::uint32_t line) {
    codes[group] = number;
    lines[group] = line;
  }
  // "G17 is active since line 4"
  [[nodiscard]] Note origin_of(Group group) const;

  [[nodiscard]] bool incremental() const { return code(Group::distance) == g(91); }
  [[nodiscard]] bool inches() const { return code(Group::units) == g(20); }
  [[nodiscard]] bool diameters() const { return code(Group::diameter) == g(7); }
  [[nodiscard]] Plane plane() const;
  [[nodiscard]] FeedMode feed_mode() const;
  // The rotary axis that is programmed in mm (G12.1), or none.
  [[nodiscard]] AxisIndex face_axis() const {
    return code(Group::transformation) == g(12, 1) ? transformed_axis : -1;
  }
  // Everything between W and B:
  // p_B = work offset - overhang + its rotation * (G52 + G92 + G68 * p_W).
  [[nodiscard]] WorkFrame frame() const;
  // What an absolute word would have to say, in mm and deg, for the axis to stay where it is.
  [[nodiscard]] double programmed_position(AxisIndex axis) const {
    return map.to_program(axis, position_W[axis]);
  }

  // Keeps the point in B where it is while the frame changes from `before` to frame().
  void reexpress_position(const WorkFrame& before);
  // Takes the point from B. Coordinates that agree to 1e-9 keep their programmed bits.
  void adopt_position(const AxisValues& position_B);
  // Moves the point in B, by a distance along the axes of B.
  void shift_position(const AxisValues& distance_B);
};

// The state at the start of a program, after M2, M30 and reset. Position and offsets are zero.
[[nodiscard]] ModalState default_modal_state(ChannelKind kind);

}  // namespace stanok::lang

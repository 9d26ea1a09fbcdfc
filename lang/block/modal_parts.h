// The parts of the modal state: what earlier blocks left in force of the feed, the spindles, the
// tool, the cycles and the frames.
//
// Values without an owner of their own: each is a member of a ModalState, on the thread of its
// channel's preparation, and is copied and set back with it. Lengths mm, angles deg; an axis is one
// of the channel, -1: none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lang/block/work_frame.h"
#include "lang/contract/code_number.h"
#include "lang/contract/command.h"
#include "lang/contract/tool_alignment.h"
#include "lang/planes/set_up_error.h"
#include "lang/planes/tilted_plane.h"

namespace stanok::lang {

inline constexpr std::size_t spindles_max = 16;

// Pecks of Haas that become less: the first one, by how much each next one is smaller, the
// smallest.
struct VariablePecks {
  double first = 0.0;  // I; 0: all pecks are Q
  double less = 0.0;   // J
  double last = 0.0;   // K; beside Q the depth after which G73 goes back to R
};

// The way of the tool off the wall in the plane, mm; else it is Q, away from the edge.
struct HoleShift {
  bool is_given = false;
  double first = 0.0;
  double second = 0.0;
};

// A sequence of drilling cycles: what stays valid from hole to hole. Levels along the tool axis in
// W, mm.
struct DrillingCycle {
  double initial_level = 0.0;
  double retract_level = 0.0;  // R
  double bottom = 0.0;         // Z
  double retract_word = 0.0;   // the numbers of R and Z
  double bottom_word = 0.0;
  double peck = 0.0;           // Q
  VariablePecks variable;      // I J K of Haas
  HoleShift shift;             // I J of G76 and G87
  double dwell_s = -1.0;       // P; below zero: none
  double lead = 0.0;           // K of tapping; 0: from F
  double return_factor = 1.0;  // J of tapping on Haas
  bool has_retract_level = false;
  bool has_bottom = false;
  AxisValues hole{};            // G88: where the tool is bored out by hand
  AxisValues pattern_centre{};  // of holes whose cycle is not done yet
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

// First block of G73 on lathes, mm (X a radius).
struct RepeatingSettings {
  double relief_x = 0.0;  // U: from the last pass to the first one
  double relief_z = 0.0;  // W
  int passes = 0;         // R; 0: not known
};

// G68: W is turned about a centre in the system that G54, G52, G92 and a tilted plane make.
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
  bool arc_leads_in = true;  // not in the dialects of Fanuc

  [[nodiscard]] bool on() const { return side != Side::off; }
  bool operator==(const RadiusCompensation&) const = default;
};

// First and second coordinate in the plane of an arc or curve, mm.
using CurvePoint = std::array<double, 2>;

// What a spline leaves to the next block.
struct ProgrammedCurve {
  CurvePoint arrival{};  // G5: from the end to its second control point, in W

  // G5.2, until G5.3: control points with the start, in W. G6.2, until there are as many knots as
  // points and order together: the control points, in W.
  int order = 0;
  std::vector<CurvePoint> points;
  std::vector<double> weights;
  std::vector<double> knots;  // G6.2

  [[nodiscard]] bool open() const { return !points.empty(); }
  [[nodiscard]] bool has_knots() const { return !knots.empty(); }
  // How many knots are missing.
  [[nodiscard]] int knots_to_come() const {
    return static_cast<int>(points.size()) + order - static_cast<int>(knots.size());
  }
  void close() {
    points.clear();
    weights.clear();
    knots.clear();
  }
};

// Feed. Invariant: F is known, or waits behind a law, or neither.
struct ModalFeed {
  // F as programmed, and with lengths in mm. Not known at start and after a change of feed mode.
  bool known = false;
  double programmed = 0.0;
  double mm = 0.0;
  // The modal feed law. While it gives the feed, F counts as not known, and is known again behind
  // it.
  FeedLaw law;
  bool behind_law = false;

  // F was programmed in the current feed mode, whether or not a law gives the feed.
  [[nodiscard]] bool is_set() const { return known || behind_law; }
  // The law that is in force from now on; off: F is again.
  void put_under(FeedLaw given);
};

struct ModalSpindles {
  double speed_rev_per_min = 0.0;  // of the master spindle
  bool any_runs = false;
  std::array<double, spindles_max> speeds_rev_per_min{};  // in the order of the channel's spindles
  std::uint16_t running = 0;                              // bit k: the k-th of them turns
  AxisSet converted_axes = 0;                             // that spindles have become with M902
  double orient_angle_deg = 0.0;                          // of the last M19
  int cutting_spindle = 0;                                // of G96, as in SpindleCommand
  double cutting_speed_m_per_min = 0.0;
  double speed_limit_rev_per_min = 0.0;  // of G96: D, G50 S, G92 S; 0: none

  [[nodiscard]] bool runs(std::size_t spindle) const { return (running >> spindle & 1U) != 0; }
  // `which`: bits of spindles.
  void start(std::uint16_t which);
  void stop(std::uint16_t which);
};

// Modes that are on or off.
struct ModalSwitches {
  bool mist = false;
  bool flood = false;
  bool feed_override = true;
  bool spindle_override = true;
  bool adaptive_feed = false;  // M52
  bool feed_stop = true;       // M53
  bool thread_chamfer = true;  // M23 and M24 of Haas lathes: their cycles run out of a thread
};

// Whether the programmed point of this code of tool length is the tip, wherever the tool leans.
[[nodiscard]] constexpr bool leads_tip(CodeNumber code) {
  return code == g(43, 4) || code == g(43, 5);
}

struct ModalTool {
  int prepared = -1;  // T; -1: none since the program started
  int active = 0;
  int edge = 1;
  ToolLength length;
  int radius_offset = -1;  // last D of the Fanuc dialect; -1: none
  // #tool_overhang: what it adds to the programmed position of its axis.
  int overhang_axis = -1;
  double overhang_shift_mm = 0.0;
  TurningWay turning = TurningWay::of_code;
};

// What cycles leave to the next block of their sequence.
struct CycleSettings {
  DrillingCycle drilling;
  double peck_back = 0.0;        // R of G74 and G75 on lathes, mm
  CodeNumber motion_before = 0;  // that was active before the sequence of holes
  TurningCycle turning;
  ThreadSettings thread;
  RoughingSettings turning_roughing;  // G71
  RoughingSettings facing_roughing;   // G72
  RepeatingSettings repeating;        // G73
};

// G16: radius (mm) and angle of the last block that had them, about a centre in the plane.
struct PolarInput {
  bool is_known = false;  // since G16
  Plane plane = Plane::xy;
  std::array<double, 2> centre{};
  double radius = 0.0;
  double angle_deg = 0.0;
  // What the last block adds when it is repeated: an angle in G91, and a radius from the position;
  // with the words `@` and `^` an angle and a radius.
  double step_deg = 0.0;
  double step_radius = 0.0;
  bool from_position = false;
};

// Under G54.4: the angles of the rotary axes for the workpiece as it is drawn, and where the tool
// stands for them as it lies. W, deg.
struct SetUpAngles {
  bool are_known = false;
  AxisValues drawn_W{};
  AxisValues lying_W{};
};

inline constexpr int first_extended_offset = 10;  // G54.1 P1

// Where the program has put W.
struct FrameSettings {
  int work_offset_number = 1;     // 1 = G54
  AxisValues work_offset{};       // of the table of offsets
  Rotation work_offset_rotation;  // G10 L2 R, of the table
  bool is_carried = false;        // G54.2: the work offset is where the rotary table has brought it
  SetUpError set_up;              // G54.4
  SetUpAngles set_up_angles;
  AxisValues local_shift{};       // G52
  AxisValues axis_shift{};        // G92
  bool axis_shift_active = true;  // false after G92.2
  TiltedPlane plane;              // G68.2 to G68.4
  PlaneDefinition definition;     // of the plane that G68.2 P2 or P3 has begun to say
  ProgrammedRotation rotation;    // G68
  PolarInput polar;               // G16

  // Of the work offset as the workpiece lies in it.
  [[nodiscard]] Rotation base_rotation() const;
  // p_B = work offset + its rotation * set-up error * (G52 + G92 + plane * (its G52 + G68 * p_W)),
  // for a channel with these X, Y, Z.
  [[nodiscard]] WorkFrame frame(const GeometryAxes& geometry) const;
};

struct ActiveTransformation {
  TransformationChange change;      // as the channel has been given it
  int axis = -1;                    // the rotary one of G12.1 or G7.1; -1: off
  double cylinder_radius_mm = 0.0;  // G7.1
  // G7.1: the linear coordinate along the axis of the cylinder, 2 of C, 0 of A, 1 of B.
  std::size_t along = 2;
  std::size_t radial = 0;  // G12.1: the linear coordinate across, 0 of C, 1 of A, 2 of B
};

}  // namespace stanok::lang

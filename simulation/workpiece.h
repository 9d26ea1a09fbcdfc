// The virtual workpiece: a blank, what tools have left of it, and the report of the cut.
//
// Tools come as places in the frame K of the blank, milling tools with their axis, inserts in the
// plane through the axis of the spindle. The part that a rapid, a shank or a holder meets is taken
// away as well, so that it is reported once. Not for the real-time cycle.
#pragma once

#include "simulation/cutting_report.h"
#include "simulation/milling_cut.h"
#include "simulation/turning_cut.h"

namespace stanok::simulation {

// A block that a motion belongs to, and its part of it.
struct Share {
  Origin origin;
  double part = 1.0;
};

// How a motion is made, and where it comes from.
struct Circumstances {
  std::vector<Share> shares;  // in their order; findings count for the last one
  int tool = 0;
  bool rapid = false;
  bool spindle_turns = true;
  double time_s = 0.0;  // at its begin
};

// A rotating tool, and the same set back a little: material that only this one's skin touches is
// what the steps of an earlier cut have left, no collision.
struct MillingTool {
  ToolSolid solid;
  ToolSolid core;
};

struct TurningTool {
  Polygon insert;
  Polygon core;
};

// Deviations are parts of the resolution: of steps while the tool turns, of the straight ways that
// stand for a bent one, of rounded corners, and of the core of a tool.
inline constexpr double sweep_deviation = 0.1;
inline constexpr double chord_deviation = 0.004;
inline constexpr double rounding_deviation = 0.02;
inline constexpr double core_depth = 0.3;

// Z of K against the Z in which the shape of a turning tool is described.
enum class DirectionOfZ : std::uint8_t { same, opposite };

class Workpiece {
 public:
  Workpiece(const Blank& blank, const Grid& grid);

  [[nodiscard]] MillingTool milling_tool(const ToolShape& shape) const;
  [[nodiscard]] TurningTool turning_tool(const ToolShape& shape, DirectionOfZ direction) const;

  void mill(const MillingTool& tool, const ToolPlace& from, const ToolPlace& to,
            const Circumstances& circumstances);
  void find_probe_at_rapid(const Vector& place_K, const Circumstances& circumstances);
  // Whether ball or stylus of a probe touches what is left. The ball finds a face late by what it
  // reaches over the nearest ray: at most resolution² / (4 radius).
  [[nodiscard]] bool touches(const ToolSolid& probe, const ToolPlace& place) const;
  // z along K, x the distance from the axis.
  void turn(const TurningTool& tool, const SpindleAxis& axis, PlanePoint from, PlanePoint to,
            const Circumstances& circumstances);
  void add_time(const Origin& origin, double seconds) { report_.add_time(origin, seconds); }

  [[nodiscard]] const Blank& blank() const { return blank_; }
  [[nodiscard]] const Material& material() const { return material_; }
  // From now on it is noted where which tool cuts (cut_marks.h).
  void mark_cuts() { material_.mark_cuts(); }
  // nullptr: it is not noted.
  [[nodiscard]] CutMarks* marks() { return material_.marks(); }
  [[nodiscard]] const CuttingReport& report() const { return report_; }
  // How far what is swept may be from what a turning tool swept, mm.
  [[nodiscard]] double deviation() const { return sweep_deviation * blank_.resolution; }
  // How far the ways that are swept may be from those of the tool, mm.
  [[nodiscard]] double way_deviation() const { return chord_deviation * blank_.resolution; }

 private:
  void mill_along(const MillingTool& tool, const ToolMove& move,
                  const Circumstances& circumstances);
  void count(double removed_mm3, const Circumstances& circumstances);
  void find(FindingKind kind, double volume, const Vector& place_K,
            const Circumstances& circumstances);

  Blank blank_;
  Material material_;
  CuttingReport report_;
};

}  // namespace stanok::simulation

// Moves of a turning cycle in X and Z, emitted one after the other from where the tool stands.
//
// W, radii, mm. A move to where the tool already stands is left out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/block/turned_contour.h"

namespace stanok::lang {

// Radii, mm.
struct TurningArc {
  TurningPoint end;
  TurningPoint centre;
  bool counter_clockwise = false;
};

class CycleMoves {
 public:
  // Fails the block when the channel lacks X or Z.
  [[nodiscard]] static std::optional<CycleMoves> of(ActiveBlock& block, CodeNumber code);

  [[nodiscard]] TurningPoint position() const;
  // The programmed end, where not programmed the position.
  [[nodiscard]] TurningPoint programmed_end() const;
  [[nodiscard]] bool names_x() const;
  [[nodiscard]] bool names_z() const;

  void rapid(TurningPoint end) { go(MoveKind::rapid, end); }
  void feed(TurningPoint end) { go(MoveKind::line, end); }
  // In the plane ZX.
  void arc(const TurningArc& arc);
  // With the lead along the axis that travels farther, from the angle of the block's first pass.
  void thread(TurningPoint end, double lead_mm, int spindle, double start_angle_deg = 0.0) {
    follow_spindle(end, lead_mm, spindle, start_angle_deg, ThreadPart::cut);
  }
  // Out of a thread, from full depth to its end.
  void run_out(TurningPoint end, double lead_mm, int spindle, double start_angle_deg) {
    follow_spindle(end, lead_mm, spindle, start_angle_deg, ThreadPart::run_out);
  }
  // The same, and out of the thread to `clear_x`: at rapid, behind M23 of Haas over a chamfer of
  // one lead at 45 degrees.
  void thread_and_out(TurningPoint end, double clear_x, double lead_mm, int spindle,
                      double start_angle_deg = 0.0);

 private:
  enum class ThreadPart : std::uint8_t { cut, run_out };
  void follow_spindle(TurningPoint end, double lead_mm, int spindle, double start_angle_deg,
                      ThreadPart part);
  CycleMoves(ActiveBlock& block, AxisIndex x, AxisIndex z) : block_(block), x_(x), z_(z) {}

  [[nodiscard]] Move move_to(MoveKind kind, TurningPoint end) const;
  void go(MoveKind kind, TurningPoint end);

  ActiveBlock& block_;
  AxisIndex x_;
  AxisIndex z_;
};

void fail_contour(ActiveBlock& block, CodeNumber code, const std::string& why);

// The moves of a contour; G0, G1 and arcs in ZX may be in it, else the block fails.
[[nodiscard]] std::vector<PlaneMove> plane_moves(ActiveBlock& block, CodeNumber code,
                                                 const ContourCommands& made);

// Which passes are cut.
enum class PassChoice : std::uint8_t { all, pockets };
// Where the tool stands behind the pass along the contour.
enum class EndOfRoughing : std::uint8_t { start_point, over_its_end };

// Passes of a roughing cycle, from the start point to a contour and along it. Every pass is left at
// 45 degrees by the retract; into a pocket behind a shoulder the tool goes down where the level
// above is cut.
class Roughing {
 public:
  // All outlive it.
  Roughing(CycleMoves& moves, const TurnedContour& contour, const RoughingSettings& settings);

  void cut_levels(PassChoice choice = PassChoice::all);
  // Along the contour, of which `moves` are those behind the allowance.
  void follow(const std::vector<PlaneMove>& moves, TurningPoint allowance,
              EndOfRoughing end = EndOfRoughing::start_point);

 private:
  void cut(const TurnedStretch& stretch, double depth, double above);
  void rapid(TurnedPoint p) { moves_.rapid(contour_.point(p)); }
  void feed(TurnedPoint p) { moves_.feed(contour_.point(p)); }

  CycleMoves& moves_;
  const TurnedContour& contour_;
  const RoughingSettings& settings_;
  double clear_;         // a level on which nothing is in the way
  double lifted_ = 0.0;  // where the tool stands
  double along_ = 0.0;
};

}  // namespace stanok::lang

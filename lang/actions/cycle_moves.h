// Moves of a turning cycle in X and Z, emitted one after the other from where the tool stands.
//
// W, radii, mm. A move to where the tool already stands is left out.
#pragma once

#include <optional>

#include "lang/actions/actions.h"
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
  void thread(TurningPoint end, double lead_mm, int spindle, double start_angle_deg = 0.0);

 private:
  CycleMoves(ActiveBlock& block, AxisIndex x, AxisIndex z) : block_(block), x_(x), z_(z) {}

  [[nodiscard]] Move move_to(MoveKind kind, TurningPoint end) const;
  void go(MoveKind kind, TurningPoint end);

  ActiveBlock& block_;
  AxisIndex x_;
  AxisIndex z_;
};

}  // namespace stanok::lang

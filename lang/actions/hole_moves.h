// Moves of one hole of a drilling, tapping or boring cycle.
//
// Levels stand along the tool axis, the third axis of the plane; W, mm. The hole belongs to a block
// and its cycle (CycleSettings::drilling).
#pragma once

#include "lang/actions/actions.h"

namespace stanok::lang {

class HoleMoves {
 public:
  // `axis`: of the channel, along which the tool goes.
  HoleMoves(ActiveBlock& block, AxisIndex axis) : block_(block), axis_(axis) {}

  [[nodiscard]] AxisIndex axis() const { return axis_; }

  // Over the hole: up to R first when the tool is below it.
  void approach(const Move& positioning);
  // Over the hole, at the height where the tool is.
  void go_over(const Move& positioning);
  void rapid(double level);
  void feed(double level);
  void dwell();
  // To the level that G98 or G99 asks for.
  void retract();

  void peck(CodeNumber code);      // G73 G83
  void bore_out(CodeNumber code);  // G81 G82 G85 G86 G89
  void tap(CodeNumber code);       // G74 G84
  void bore_finely();              // G76
  void bore_from_behind();         // G87
  // G88: down, and the spindle and the program stop; the operator takes the tool out. Then on from
  // wherever it stands: up to R, over the hole, the spindle on, and to the level of G98 or G99.
  void bore_up_to_hand();
  void go_on_behind_hand();

 private:
  [[nodiscard]] double peck_depth(int n) const;
  void go(Move move, double level);
  void tap_rigidly(int spindle, double lead_mm);
  void tap_with_floating_chuck(int spindle, SpindleAction turning, double lead_mm);
  void shift(double first, double second);
  void orient();
  void turn_again();
  void shift_off_wall();
  void shift_to(const AxisValues& over_hole);

  ActiveBlock& block_;
  AxisIndex axis_;
};

}  // namespace stanok::lang

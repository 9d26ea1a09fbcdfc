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

  // Over the hole: up to R first when the tool is below it.
  void approach(const Move& positioning);
  void rapid(double level);
  void feed(double level);
  void dwell();
  // To the level that G98 or G99 asks for.
  void retract();

  void peck(CodeNumber code);      // G73 G83
  void bore_out(CodeNumber code);  // G81 G82 G85 G86 G89
  void tap(CodeNumber code);       // G74 G84
  void bore_finely();              // G76

 private:
  void go(Move move, double level);
  void tap_rigidly(int spindle, double lead_mm);
  void tap_with_floating_chuck(int spindle, SpindleAction turning, double lead_mm);
  void shift(double first, double second);

  ActiveBlock& block_;
  AxisIndex axis_;
};

}  // namespace stanok::lang

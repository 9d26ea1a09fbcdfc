// Actions of the peck cycles of lathe channels: G74 into the face, G75 into the diameter.
//
// A block with R alone says how far the tool goes back between two pecks. In the next one G74 pecks
// along Z in steps of Q and goes on along X in steps of P, G75 pecks along X in steps of P and goes
// on along Z in steps of Q; at the bottom the tool moves R to the side that is cut already, in the
// first groove not at all. Haas controls have one block, with I K D in place of P Q R. Steps are
// radii without a sign. The tool comes back to the start point. Source: Fanuc operator's manual
// B-64304EN-1, 4.2.5 and 4.2.6; Haas lathe operator's manual, G74 and G75.
#include <algorithm>
#include <cmath>

#include "lang/actions/cycle_moves.h"
#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

// Moves that one block may make; all of them are held at once.
constexpr double peck_moves_max = 100000.0;

// Along the pecks and across them.
struct PeckPoint {
  double along = 0.0;
  double across = 0.0;
};

enum class PeckAxis : std::uint8_t { x, z };

struct Pecking {
  PeckAxis along = PeckAxis::z;
  PeckPoint start;
  PeckPoint end;
  double peck = 0.0;    // 0: the depth in one cut
  double step = 0.0;    // across
  double back = 0.0;    // between two pecks
  double relief = 0.0;  // at the bottom, across
};

double signed_step(double from, double to, double step) {
  return to < from ? -step : step;
}

int steps_of(double from, double to, double step) {
  constexpr double rounding = 1e-9;
  return step <= 0.0 ? 1 : static_cast<int>(std::ceil(std::abs(to - from) / step - rounding));
}

PeckPoint peck_point(TurningPoint p, PeckAxis along) {
  return along == PeckAxis::z ? PeckPoint{p.z, p.x} : PeckPoint{p.x, p.z};
}

class PeckMoves {
 public:
  PeckMoves(CycleMoves& moves, const Pecking& pecking) : moves_(moves), pecking_(pecking) {}

  void run() {
    const PeckPoint start = pecking_.start;
    const PeckPoint end = pecking_.end;
    const int steps =
        start.across == end.across ? 0 : steps_of(start.across, end.across, pecking_.step);
    const double step = signed_step(start.across, end.across, pecking_.step);
    for (int k = 0; k <= steps; ++k) {
      const double across = k == steps ? end.across : start.across + k * step;
      rapid({start.along, across});
      cut(across);
      const double side = k == 0 ? 0.0 : signed_step(end.across, start.across, pecking_.relief);
      rapid({end.along, across + side});
      rapid({start.along, across + side});
    }
    rapid(start);
  }

 private:
  void cut(double across) {
    const PeckPoint start = pecking_.start;
    const PeckPoint end = pecking_.end;
    const int pecks = std::max(steps_of(start.along, end.along, pecking_.peck), 1);
    const double peck = signed_step(start.along, end.along, pecking_.peck);
    const double back = signed_step(end.along, start.along, pecking_.back);
    for (int k = 1; k < pecks; ++k) {
      feed({start.along + k * peck, across});
      rapid({start.along + k * peck + back, across});
    }
    feed({end.along, across});
  }

  [[nodiscard]] TurningPoint turning_point(PeckPoint p) const {
    return pecking_.along == PeckAxis::z ? TurningPoint{p.across, p.along}
                                         : TurningPoint{p.along, p.across};
  }
  void rapid(PeckPoint p) { moves_.rapid(turning_point(p)); }
  void feed(PeckPoint p) { moves_.feed(turning_point(p)); }

  CycleMoves& moves_;
  const Pecking& pecking_;
};

// The words of a step: of two blocks, and of the one block that Haas controls have.
struct StepWords {
  char usual;
  char of_one_block;
};
double step_of(const ActiveBlock& block, const StepWords& words) {
  if (block.has(words.of_one_block)) return std::abs(block.length(words.of_one_block));
  if (!block.has(words.usual)) return 0.0;
  const bool counted = words.usual != 'R';
  const double value =
      counted ? value_or_thousandths(block, words.usual) : block.value(words.usual);
  return std::abs(value) * block.length_unit();
}

void check_pecking(ActiveBlock& block, CodeNumber code, const Pecking& pecking) {
  const bool along_z = pecking.along == PeckAxis::z;
  const char step_word = along_z ? 'P' : 'Q';
  const std::string name = "`" + code_text('G', code) + "`";
  if (pecking.start.along == pecking.end.along) {
    block.fail("E4007", code_word(code),
               name + (along_z ? " needs Z, the depth" : " needs X, the depth"), "no depth");
  } else if (pecking.start.across != pecking.end.across && pecking.step <= 0.0) {
    block.fail("E4063", code_word(code),
               name + " needs " + step_word + ", the step from groove to groove", "no step");
  }
  const double pecks = steps_of(pecking.start.along, pecking.end.along, pecking.peck);
  const double grooves = 1.0 + steps_of(pecking.start.across, pecking.end.across, pecking.step);
  if (pecks * grooves * 2.0 > peck_moves_max)
    block.fail("E4063", code_word(code), "P and Q result in too many pecks", "too small");
}

}  // namespace

void peck_or_tap(ActiveBlock& block, CodeNumber code) {
  if (block.channel.kind != ChannelKind::lathe) return drill_hole(block, code);
  peck_groove(block, code);
}

void peck_groove(ActiveBlock& block, CodeNumber code) {
  block.kept_groups |= group_bit(Group::motion);
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  double& back = block.modal.cycles.peck_back;
  const bool only_settings = block.programmed == 0 && block.has('R');
  if (only_settings) {
    back = block.length('R');
    if (back < 0.0) block.fail("E4008", {'R', -1, {}}, "the retract must not be negative", "");
    return;
  }
  Pecking pecking;
  const bool face = code == g(74);
  pecking.along = face ? PeckAxis::z : PeckAxis::x;
  pecking.start = peck_point(moves->position(), pecking.along);
  pecking.end = peck_point(moves->programmed_end(), pecking.along);
  const double along_x = step_of(block, {'P', 'I'});
  const double along_z = step_of(block, {'Q', 'K'});
  pecking.peck = face ? along_z : along_x;
  pecking.step = face ? along_x : along_z;
  pecking.back = back;
  pecking.relief = step_of(block, {'R', 'D'});
  check_pecking(block, code, pecking);
  if (!block.failed()) PeckMoves(*moves, pecking).run();
}

}  // namespace stanok::lang

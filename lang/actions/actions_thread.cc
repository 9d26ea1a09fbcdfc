// Actions of threads by single blocks: G33 (G32) and G33.1.
//
// K is the lead along the path, as in LinuxCNC; F the lead along the axis that travels farther, as
// on Fanuc controls. Both are the same on a thread along one axis. Q, where the spindle begins,
// holds for its block alone; Fanuc controls count it in thousandths of a degree (B-64304EN-1,
// multiple threading).
#include <algorithm>
#include <cmath>

#include "base/vector3.h"
#include "lang/actions/actions.h"
#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

struct Travel {
  double path = 0.0;     // of the linear axes
  double longest = 0.0;  // of one of them
};

Travel travel_of(const ActiveBlock& block, const Move& move) {
  Travel travel;
  double square = 0.0;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (block.channel.axes[i].rotary) continue;
    const double along = std::abs(move.end[i] - block.modal.position_W[i]);
    square += along * along;
    travel.longest = std::max(travel.longest, along);
  }
  travel.path = std::sqrt(square);
  return travel;
}

// Lead along the path; fails the block without one.
double lead_of_thread(ActiveBlock& block, const Move& move, CodeNumber code) {
  const std::string name = "`" + code_text('G', code) + "`";
  if (block.has('K') && block.has('F') && code != g(33, 1)) {
    block.fail("E4066", {'F', -1, {}}, name + " has K and F, and both are the lead", "one too many")
        .help.push_back("keep K, the lead along the path, or F, that along the longer axis");
    return 0.0;
  }
  const char letter = block.has('K') || code == g(33, 1) ? 'K' : 'F';
  const double lead = block.has(letter) ? block.length(letter) : 0.0;
  if (lead <= 0.0) {
    block
        .fail("E4066", {block.has(letter) ? letter : 'G', block.has(letter) ? -1 : code, {}},
              name + " needs a positive lead in its block", "no lead")
        .help.push_back(code == g(33, 1) ? "add the lead per revolution, e.g. `K1.5`"
                                         : "add the lead per revolution, e.g. `K1.5` or `F1.5`");
    return 0.0;
  }
  const Travel travel = travel_of(block, move);
  if (travel.path == 0.0) {
    block.fail("E4067", {'G', code, {}}, name + " does not move a linear axis", "no path")
        .help.push_back("program an end of the thread that is not the current position");
    return 0.0;
  }
  return letter == 'K' ? lead : lead * travel.path / travel.longest;
}

std::optional<SynchronousMove> synchronous_move(ActiveBlock& block, CodeNumber code) {
  const auto spindle = named_spindle(block);
  if (!spindle) return std::nullopt;
  SynchronousMove move;
  move.spindle = *spindle;
  move.line.kind = MoveKind::line;
  resolve_ends(block, move.line);
  move.line.path = block.modal.path;
  move.lead_mm_per_rev = lead_of_thread(block, move.line, code);
  check_spindle_turns(block, *spindle, code);
  if (block.failed()) return std::nullopt;
  return move;
}

// Along one axis, or along the tool as it leans at the start: on any other way a tap breaks.
bool taps_straight(const ActiveBlock& block, const Move& move) {
  if (block.modal.transformation.axis >= 0) return true;
  const WorkFrame frame = block.modal.frame();
  const AxisValues start_B = frame.base_from_work(block.modal.position_W);
  const AxisValues end_B = frame.base_from_work(move.end);
  Vector3<double> way_B;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.channel_words.geometry_axis(k);
    if (axis.exists()) way_B[static_cast<Eigen::Index>(k)] = end_B[axis] - start_B[axis];
  }
  const double along_tool = stanok::dot(way_B, vector3(block.tables.spindle_axes(start_B)[2]));
  const double along = std::max(
      {std::abs(way_B.x()), std::abs(way_B.y()), std::abs(way_B.z()), std::abs(along_tool)});
  constexpr double rounding_mm = 0.002;  // of three coordinates with three decimals
  return std::sqrt(std::max(stanok::dot(way_B, way_B) - along * along, 0.0)) <= rounding_mm;
}

}  // namespace

void check_spindle_turns(ActiveBlock& block, int spindle, CodeNumber code) {
  if (refuse_spindle_that_is_axis(block, spindle, {'G', code, {}})) return;
  if (spindle_turns(block, spindle)) return;
  block
      .fail("E4064", {'G', code, {}}, "`" + code_text('G', code) + "` needs a spindle that turns",
            "no M3 or M4 before this")
      .help.push_back("program S and `M3` or `M4` first");
}

double thread_start_angle_deg(ActiveBlock& block) {
  constexpr double whole_turn_deg = 360.0;
  if (!block.has('Q')) return 0.0;
  const double angle = value_or_thousandths(block, 'Q');
  if (std::abs(angle) > whole_turn_deg) {
    block
        .fail("E4016", {'Q', -1, {}}, "`Q`, the angle of the spindle, is more than a turn",
              "thousandths?")
        .help.emplace_back("give degrees with a decimal point, e.g. `Q180.0`");
  }
  return angle;
}

void cut_thread(ActiveBlock& block, CodeNumber code) {
  auto move = synchronous_move(block, code);
  if (!move) return;
  move->start_angle_deg = thread_start_angle_deg(block);
  if (block.failed()) return;
  advance_position(block, move->line);
  block.queue.emit(*move);
}

// The spindle is reversed at the end, and the tool comes back to where it started.
void tap_rigidly(ActiveBlock& block, CodeNumber code) {
  auto move = synchronous_move(block, code);
  if (!move) return;
  if (!taps_straight(block, move->line)) {
    block
        .fail("E4070", {'G', code, {}}, "`G33.1` would tap at an angle",
              "moves several axes, and not along the tool")
        .help.emplace_back(
            "move over the hole first, e.g. `G0 X10 Y0`, then tap with the end of the thread "
            "alone");
    return;
  }
  move->kind = SynchronousMove::Kind::rigid_tap;
  if (block.has('I')) {
    move->return_speed_factor = block.value('I');
    if (move->return_speed_factor <= 0.0) {
      block.fail("E4008", {'I', -1, {}}, "the factor of the return speed must be positive", "");
      return;
    }
  }
  block.queue.emit(*move);
}

}  // namespace stanok::lang

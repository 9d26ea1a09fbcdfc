// Action of circular pockets: G12 clockwise, G13 counter-clockwise.
//
// The tool stands over the centre. It goes down to Z at feed, by half a circle to the first radius
// I, around, with K and Q on to larger circles, Q apart up to K, and by half a circle back to the
// centre, where it stays in the depth. D is the tool whose radius the circles are smaller by (D0:
// none). In G91 L makes as many levels, Z deeper each. Source: Haas mill operator's manual, G12 and
// G13; where the first circle begins (along the first axis) the manual leaves open.
#include <cmath>
#include <string>
#include <vector>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

constexpr double circles_max = 10000.0;  // of a block; all of them are held at once
constexpr double coordinate_noise = 1e-9;

struct Pocket {
  AxisIndex first;  // axes of the plane, and of the depth
  AxisIndex second;
  AxisIndex depth;
  bool counter_clockwise = false;
  std::vector<double> radii_mm;  // of the tool's centre
  std::vector<double> levels;    // along the depth, W
};

class PocketMoves {
 public:
  PocketMoves(ActiveBlock& block, const Pocket& pocket)
      : block_(block), pocket_(pocket), centre_(block.modal.position_W) {}

  void run() {
    for (const double level : pocket_.levels) {
      AxisValues down = centre_;
      down[pocket_.depth] = level;
      centre_[pocket_.depth] = level;
      line(down, axis_bit(pocket_.depth));
      const double first = pocket_.radii_mm.front();
      arc(first, first / 2.0);
      for (std::size_t k = 0; k < pocket_.radii_mm.size(); ++k) {
        if (k > 0) line(point(pocket_.radii_mm[k]), axis_bit(pocket_.first));
        arc(pocket_.radii_mm[k], 0.0);
      }
      arc(0.0, pocket_.radii_mm.back() / 2.0);
    }
  }

 private:
  // On the first axis, `away` from the centre.
  [[nodiscard]] AxisValues point(double away) const {
    AxisValues p = centre_;
    p[pocket_.first] += away;
    return p;
  }

  void line(const AxisValues& end, AxisSet words) {
    Move move;
    move.kind = MoveKind::line;
    move.end = end;
    move.words = words;
    emit(move);
  }

  // To `end_away`, about a point on the first axis.
  void arc(double end_away, double centre_away) {
    Move move;
    move.kind = MoveKind::arc;
    move.end = point(end_away);
    move.words = static_cast<AxisSet>(axis_bit(pocket_.first) | axis_bit(pocket_.second));
    move.plane = block_.modal.plane();
    move.counter_clockwise = pocket_.counter_clockwise;
    move.centre = {centre_[pocket_.first] + centre_away, centre_[pocket_.second]};
    emit(move);
  }

  void emit(Move& move) {
    if (block_.failed()) return;
    resolve_feed(block_, move);
    if (block_.failed()) return;
    advance_position(block_, move);
    block_.queue.emit(move);
  }

  ActiveBlock& block_;
  const Pocket& pocket_;
  AxisValues centre_;
};

bool find_axes(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  pocket.first = block.channel_words.geometry_axis(plane.first);
  pocket.second = block.channel_words.geometry_axis(plane.second);
  pocket.depth = block.channel_words.geometry_axis(plane.normal);
  if (pocket.first.exists() && pocket.second.exists() && pocket.depth.exists()) return true;
  block.fail("E4036", code_word(code), "the channel lacks an axis of the pocket", "")
      .notes.push_back(block.modal.origin_of(Group::plane));
  return false;
}

// Lengths in the plane, by scaling and mirror; 0, with the block failed, when a circle is none.
double gain_of_plane(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  const double first = block.modal.map.gain(pocket.first);
  const double second = block.modal.map.gain(pocket.second);
  if (first * second < 0.0) pocket.counter_clockwise = !pocket.counter_clockwise;
  if (std::abs(first) == std::abs(second)) return std::abs(first);
  block.fail("E4303", code_word(code), "the axes of the circle are scaled by different factors",
             "no circle");
  return 0.0;
}

bool find_radii(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  const std::string name = "`" + code_text('G', code) + "`";
  const auto refuse = [&](char letter, const std::string& why) {
    block.fail(block.has(letter) ? "E4008" : "E4007",
               block.has(letter) ? WordName{letter, -1, {}} : code_word(code),
               name + " needs " + why, "");
    return false;
  };
  const double gain = gain_of_plane(block, code, pocket);
  const auto tool = tool_of_radius(block, code);
  if (block.failed() || !tool) return false;
  const double first = block.has('I') ? gain * block.length('I') : 0.0;
  const double last = block.has('K') ? gain * block.length('K') : first;
  const double step = block.has('Q') ? gain * block.length('Q') : 0.0;
  if (first <= 0.0) return refuse('I', "I, the radius of the first circle, above zero");
  if (last < first) return refuse('K', "K, the radius of the last circle, of at least I");
  if (last > first && step <= 0.0) return refuse('Q', "Q, the way from circle to circle");
  if (block.has('Q') && !block.has('K')) return refuse('K', "K beside Q, the last radius");
  if (first <= tool->radius_mm) return refuse('I', "a circle that is larger than the tool");
  if (step > 0.0 && (last - first) / step > circles_max) return refuse('Q', "a larger step Q");
  for (int n = 0; first + n * step < last - coordinate_noise; ++n)
    pocket.radii_mm.push_back(first + n * step - tool->radius_mm);
  pocket.radii_mm.push_back(last - tool->radius_mm);
  return true;
}

bool find_levels(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  if (!only_axes(block, code, axis_bit(pocket.depth))) return false;
  Move move;
  resolve_ends(block, move);
  const double start = block.modal.position_W[pocket.depth];
  const double step = move.end[pocket.depth] - start;
  const auto count = block.has('L') ? block.integer('L', 1, 9999) : 1;
  if (!count) return false;
  if (*count > 1 && !block.modal.incremental()) {
    block.fail("E4016", {'L', -1, {}}, "levels of a pocket are counted from the position",
               "needs `G91`");
    return false;
  }
  if (*count * static_cast<double>(pocket.radii_mm.size()) > circles_max) {
    block.fail("E4063", {'L', -1, {}}, "the pocket has too many circles", "too many");
    return false;
  }
  for (int k = 1; k <= *count; ++k) pocket.levels.push_back(start + k * step);
  return true;
}

}  // namespace

void mill_circular_pocket(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(
          block, code,
          {Exclusion::radius_compensation, Exclusion::transformation, Exclusion::inverse_time}))
    return;
  Pocket pocket;
  pocket.counter_clockwise = code == g(13);
  if (!find_axes(block, code, pocket) || !find_radii(block, code, pocket) ||
      !find_levels(block, code, pocket))
    return;
  PocketMoves(block, pocket).run();
}

}  // namespace stanok::lang

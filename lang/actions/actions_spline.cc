// Actions of splines in the plane XY: G5 cubic, G5.1 quadratic, G5.2 ... G5.3 NURBS.
//
// All become one SplineMove of control points. G5 and G5.1 are Bezier curves; a G5 that follows
// another one without I and J leaves in the direction in which that one arrived. Between G5.2 and
// G5.3 every block is a control point with its weight P; the point where the axes stand is the
// first. Source of words and rules: LinuxCNC, "G-Code Reference", G5 to G5.3.
#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

constexpr int order_default = 3;
constexpr int order_max = 6;

struct CurvePlane {
  AxisIndex first;  // axes of the plane
  AxisIndex second;
};

BlockFault& fail_missing(ActiveBlock& block, CodeNumber code, const std::string& words) {
  return block.fail("E4007", code_word(code), "`" + code_text('G', code) + "` needs " + words,
                    "incomplete");
}

// What all curves ask for: G17, X and Y only, no radius compensation, no face or cylinder.
std::optional<CurvePlane> curve_plane_of(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation, Exclusion::transformation})) {
    return std::nullopt;
  }
  if (block.modal.plane() != Plane::xy) {
    block.fail("E4311", code_word(code), "splines lie in the plane XY", "needs G17")
        .notes.push_back(block.modal.origin_of(Group::plane));
    return std::nullopt;
  }
  const CurvePlane plane{block.modal.geometry[0], block.modal.geometry[1]};
  if (!plane.first.exists() || !plane.second.exists()) {
    block.fail("E4306", code_word(code), "the channel has no plane XY for a spline", "");
    return std::nullopt;
  }
  const auto allowed = static_cast<AxisSet>(axis_bit(plane.first) | axis_bit(plane.second));
  if (!only_axes(block, code, allowed)) return std::nullopt;
  return plane;
}

CurvePoint point_in(const CurvePlane& plane, const AxisValues& values) {
  return {values[plane.first], values[plane.second]};
}

// A distance given by two words, 0 where one is missing, in W.
CurvePoint distance_of(const ActiveBlock& block, const CurvePlane& plane, char first, char second) {
  const CoordinateMap& map = block.modal.map;
  return {block.has(first) ? map.gain(plane.first) * block.length(first) : 0.0,
          block.has(second) ? map.gain(plane.second) * block.length(second) : 0.0};
}

CurvePoint sum(const CurvePoint& a, const CurvePoint& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

SplineMove curve_to_words(ActiveBlock& block) {
  SplineMove spline;
  spline.base.kind = MoveKind::line;
  resolve_ends(block, spline.base);
  return spline;
}

void emit(ActiveBlock& block, SplineMove& spline) {
  resolve_feed(block, spline.base);
  if (block.failed()) return;
  advance_position(block, spline.base);
  block.queue.emit(spline);
}

}  // namespace

void move_in_cubic(ActiveBlock& block, CodeNumber code) {
  const auto plane = curve_plane_of(block, code);
  if (!plane) return;
  if (!block.has('P') || !block.has('Q')) {
    fail_missing(block, code, "P and Q, from its end to the second control point");
    return;
  }
  const bool follows = block.modal.code(Group::motion) == code;
  const bool has_start = block.has('I') && block.has('J');
  if (!has_start && (block.has('I') || block.has('J') || !follows)) {
    fail_missing(block, code, "I and J, from its start to the first control point");
    return;
  }
  SplineMove spline = curve_to_words(block);
  const CurvePoint start = point_in(*plane, block.modal.position_W);
  const CurvePoint end = point_in(*plane, spline.base.end);
  const CurvePoint arrival = distance_of(block, *plane, 'P', 'Q');
  const CurvePoint& before = block.modal.curve.arrival;
  const CurvePoint departure =
      has_start ? distance_of(block, *plane, 'I', 'J') : CurvePoint{-before[0], -before[1]};
  spline.degree = 3;
  spline.points = {sum(start, departure), sum(end, arrival), end};
  block.modal.curve.arrival = arrival;
  emit(block, spline);
}

void move_in_quadratic(ActiveBlock& block, CodeNumber code) {
  const auto plane = curve_plane_of(block, code);
  if (!plane) return;
  const CurvePoint control = distance_of(block, *plane, 'I', 'J');
  if (control == CurvePoint{}) {
    fail_missing(block, code, "I or J, from its start to the control point");
    return;
  }
  SplineMove spline = curve_to_words(block);
  spline.degree = 2;
  spline.points = {sum(point_in(*plane, block.modal.position_W), control),
                   point_in(*plane, spline.base.end)};
  emit(block, spline);
}

// Without axis words: the weight of the first point, and the order.
void collect_nurbs_point(ActiveBlock& block, CodeNumber code) {
  const auto plane = curve_plane_of(block, code);
  if (!plane) return;
  ProgrammedCurve& curve = block.modal.curve;
  const double weight = block.has('P') ? block.value('P') : 1.0;
  if (weight <= 0.0) {
    block.fail("E4008", {'P', -1, {}}, "the weight of a control point must be greater than zero",
               "out of range");
    return;
  }
  if (!curve.open()) {
    curve.order = order_default;
    curve.points = {point_in(*plane, block.modal.position_W)};
    curve.weights = {block.programmed == 0 ? weight : 1.0};
  } else if (block.has('L')) {
    block.fail("E4312", {'L', -1, {}}, "the order belongs into the first block of the curve",
               "too late");
    return;
  }
  if (block.has('L')) {
    const auto order = block.integer('L', 2, order_max);
    if (!order) return;
    curve.order = *order;
  }
  if (block.programmed == 0) return;
  const CoordinateMap& map = block.modal.map;
  CurvePoint point = curve.points.back();
  const std::array axes{plane->first, plane->second};
  for (std::size_t k = 0; k < 2; ++k) {
    const AxisIndex axis = axes[k];
    if (!is_programmed(block, axis)) continue;
    const double value = block.values[axis];
    point[k] =
        block.modal.incremental() ? point[k] + map.gain(axis) * value : map.to_work(axis, value);
  }
  curve.points.push_back(point);
  curve.weights.push_back(weight);
}

void end_nurbs(ActiveBlock& block, CodeNumber code) {
  ProgrammedCurve& curve = block.modal.curve;
  if (!curve.open()) {
    block.fail("E4312", code_word(code), "`G5.3` has no `G5.2` before it", "no curve to end");
    return;
  }
  const auto order = static_cast<std::size_t>(curve.order);
  if (curve.points.size() < order) {
    block.fail("E4313", code_word(code),
               "a curve of order " + std::to_string(order) + " needs as many control points",
               "only " + std::to_string(curve.points.size()) + " with the start point");
    return;
  }
  const auto plane = curve_plane_of(block, code);
  if (!plane) return;
  SplineMove spline = curve_to_words(block);
  spline.base.words = static_cast<AxisSet>(axis_bit(plane->first) | axis_bit(plane->second));
  spline.base.end[plane->first] = curve.points.back()[0];
  spline.base.end[plane->second] = curve.points.back()[1];
  spline.degree = curve.order - 1;
  spline.points.assign(curve.points.begin() + 1, curve.points.end());
  spline.weights = curve.weights;
  curve.points.clear();
  emit(block, spline);
}

// G5 P10000/P0 and G5.1 Q1/Q0 switch look-ahead of other controls; here it is always on.
void accept_high_speed(ActiveBlock& block, CodeNumber code) {
  const char letter = code == g(5) ? 'P' : 'Q';
  const double on = code == g(5) ? 10000.0 : 1.0;
  const double value = block.has(letter) ? block.value(letter) : -1.0;
  if (value == 0.0 || value == on) return;
  if (!block.has(letter)) {
    fail_missing(block, code, code == g(5) ? "X, Y, I, J, P and Q" : "X, Y, I and J");
    return;
  }
  block.fail("E4008", {letter, -1, {}},
             code == g(5) ? "`G5` without axis words takes P10000 or P0"
                          : "`G5.1` without axis words takes Q1 or Q0",
             "out of range");
}

}  // namespace stanok::lang

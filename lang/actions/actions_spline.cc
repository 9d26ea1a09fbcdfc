// Actions of splines in the active plane: G5 cubic, G5.1 quadratic, G5.2 ... G5.3 NURBS, G6.2 NURBS
// with knots.
//
// All but G6.2 become one SplineMove of control points. G5 and G5.1 are Bezier curves; a G5 that
// follows another one without I and J leaves in the direction in which that one arrived. Between
// G5.2 and G5.3 every block is a control point with its weight P; the point where the axes stand is
// the first. Source of words and rules: LinuxCNC, "G-Code Reference", G5 to G5.3.
//
// Every block of G6.2 is a control point with its knot K and its weight R; the last blocks, as many
// as the order P, have a knot only. The first point is where the axes stand. Such a curve becomes a
// SplineMove for each of the Bezier curves in it. Source: Fanuc, operator's manual B-63944EN, NURBS
// interpolation (G06.2). Q, the method of interpolation of LinuxCNC, changes nothing: the feed is
// constant along the curve, which is what every method wants.
#include <algorithm>
#include <cmath>

#include "lang/actions/actions.h"
#include "lang/elements/knotted_curve.h"

namespace stanok::lang {
namespace {

constexpr int order_default = 3;
constexpr int order_max = 6;
constexpr int knotted_order_default = 4;
constexpr double start_tolerance = 0.01;  // mm: as of arcs

struct CurvePlane {
  Plane name;
  AxisIndex first;  // axes of the plane
  AxisIndex second;
  char first_distance;  // I, J or K: distances along these axes
  char second_distance;
};

BlockFault& fail_missing(ActiveBlock& block, CodeNumber code, const std::string& words) {
  return block.fail("E4007", code_word(code), "`" + code_text('G', code) + "` needs " + words,
                    "incomplete");
}

// Of I, J and K a plane has two, as for the centre of an arc.
bool check_distance_words(ActiveBlock& block, const CurvePlane& plane, CodeNumber code) {
  if (code != g(5) && code != g(5, 1)) return true;
  for (const char letter : {'I', 'J', 'K'}) {
    const bool in_plane = letter == plane.first_distance || letter == plane.second_distance;
    if (in_plane || !block.has(letter)) continue;
    block
        .fail("E4030", {letter, -1, {}},
              std::string("`") + letter + "` is not in the plane of the spline",
              "not used in " + code_text('G', block.modal.code(Group::plane)))
        .notes.push_back(block.modal.origin_of(Group::plane));
    return false;
  }
  return true;
}

// What all curves ask for: the axes of the plane only, no radius compensation, no face or cylinder.
std::optional<CurvePlane> curve_plane_of(ActiveBlock& block, CodeNumber code) {
  static constexpr std::array distance_words{'I', 'J', 'K'};
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation, Exclusion::transformation})) {
    return std::nullopt;
  }
  const PlaneCoordinates& coordinates = plane_coordinates[block.modal.plane()];
  const CurvePlane plane{block.modal.plane(), block.channel_words.geometry_axis(coordinates.first),
                         block.channel_words.geometry_axis(coordinates.second),
                         distance_words[coordinates.first], distance_words[coordinates.second]};
  if (!plane.first.exists() || !plane.second.exists()) {
    block.fail("E4306", code_word(code), "the channel lacks an axis of the spline's plane", "")
        .notes.push_back(block.modal.origin_of(Group::plane));
    return std::nullopt;
  }
  const auto allowed = static_cast<AxisSet>(axis_bit(plane.first) | axis_bit(plane.second));
  if (!only_axes(block, code, allowed) || !check_distance_words(block, plane, code)) {
    return std::nullopt;
  }
  return plane;
}

// "X and Y", "I and J": the names of both directions of the plane.
std::string named(char first, const char* between, char second) {
  return std::string(1, first) + between + second;
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

CurvePoint sum_of_points(const CurvePoint& a, const CurvePoint& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

// The point of the axis words, `before` where they are missing or increments.
CurvePoint programmed_point(const ActiveBlock& block, const CurvePlane& plane,
                            const CurvePoint& before) {
  const CoordinateMap& map = block.modal.map;
  CurvePoint point = before;
  const std::array axes{plane.first, plane.second};
  for (std::size_t k = 0; k < 2; ++k) {
    const AxisIndex axis = axes[k];
    if (!is_programmed(block, axis)) continue;
    const double value = block.values[axis];
    point[k] =
        block.modal.incremental() ? point[k] + map.gain(axis) * value : map.to_work(axis, value);
  }
  return point;
}

SplineMove curve_to_words(ActiveBlock& block, const CurvePlane& plane) {
  SplineMove spline;
  spline.base.kind = MoveKind::line;
  spline.base.plane = plane.name;
  resolve_ends(block, spline.base);
  return spline;
}

void emit(ActiveBlock& block, SplineMove& spline) {
  resolve_feed(block, spline.base);
  if (block.failed()) return;
  advance_position(block, spline.base);
  block.queue.emit(spline);
}

void aim_at(SplineMove& spline, const CurvePlane& plane, const CurvePoint& end) {
  spline.base.words = static_cast<AxisSet>(axis_bit(plane.first) | axis_bit(plane.second));
  spline.base.end[plane.first] = end[0];
  spline.base.end[plane.second] = end[1];
}

BlockFault& fail_knot(ActiveBlock& block, const std::string& message, const char* label) {
  return block.fail("E4008", {'K', -1, {}}, message, label);
}

// The first block of G6.2: the order, and where the curve begins.
bool begin_knotted(ActiveBlock& block, const CurvePlane& plane, CodeNumber code) {
  ProgrammedCurve& curve = block.modal.curve;
  if (block.programmed == 0) {
    fail_missing(block, code, "its first control point");
    return false;
  }
  int order = knotted_order_default;
  if (block.has('P')) {
    const auto given = block.integer('P', 2, order_max);
    if (!given) return false;
    order = *given;
  }
  const CurvePoint stands = point_in(plane, block.modal.position_W);
  const CurvePoint first = programmed_point(block, plane, stands);
  if (std::hypot(first[0] - stands[0], first[1] - stands[1]) > start_tolerance) {
    block
        .fail("E4312", code_word(code), "the first control point must be the current position",
              "it begins elsewhere")
        .help.emplace_back("move to the first control point first");
    return false;
  }
  curve.order = order;
  return true;
}

// Whether the next knot may follow those that are there.
bool knot_fits(ActiveBlock& block, double knot) {
  const ProgrammedCurve& curve = block.modal.curve;
  const auto order = static_cast<std::size_t>(curve.order);
  if (curve.knots.empty()) return true;
  if (knot < curve.knots.back()) {
    fail_knot(block, "knots must not decrease", "less than the previous one");
    return false;
  }
  const std::size_t before = curve.knots.size();
  const bool too_often = before >= order && curve.knots[before - order] == knot;
  if (too_often) {
    fail_knot(block, "a knot may be repeated at most as often as the order", "one too many");
    return false;
  }
  return true;
}

// The gap in the middle of the curve that a knot of full multiplicity makes.
bool is_torn(const KnottedCurve& curve) {
  for (std::size_t k = 1; k < curve.points.size(); ++k) {
    const bool full = curve.knots[k] == curve.knots[k + curve.order - 1];
    if (full && curve.points[k - 1] != curve.points[k]) return true;
  }
  return false;
}

void emit_knotted(ActiveBlock& block, const CurvePlane& plane, CodeNumber code) {
  ProgrammedCurve& programmed = block.modal.curve;
  const int degree = programmed.order - 1;
  const auto order = static_cast<std::size_t>(programmed.order);
  const KnottedCurve curve{order, programmed.points, programmed.weights, programmed.knots};
  programmed.close();
  if (curve.points.size() < order) {
    block.fail(
        "E4313", code_word(code),
        "a curve of order " + std::to_string(order) + " needs at least that many control points",
        "only " + std::to_string(curve.points.size()));
    return;
  }
  const std::vector<BezierPiece> pieces = bezier_pieces(curve);
  if (pieces.empty() || is_torn(curve)) {
    fail_knot(block, "these knots do not give a connected curve", "the last of the knots");
    return;
  }
  const CurvePoint stands = point_in(plane, block.modal.position_W);
  const CurvePoint& first = pieces.front().points.front();
  if (std::hypot(first[0] - stands[0], first[1] - stands[1]) > start_tolerance) {
    fail_knot(block, "the curve does not begin at its first control point",
              "the first knot must be repeated as often as the order");
    return;
  }
  for (const BezierPiece& piece : pieces) {
    SplineMove spline = curve_to_words(block, plane);
    aim_at(spline, plane, piece.points.back());
    spline.degree = degree;
    spline.points.assign(piece.points.begin() + 1, piece.points.end());
    spline.weights = piece.weights;
    emit(block, spline);
    if (block.failed()) return;
  }
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
  const char first = plane->first_distance;
  const char second = plane->second_distance;
  const bool has_start = block.has(first) && block.has(second);
  if (!has_start && (block.has(first) || block.has(second) || !follows)) {
    fail_missing(block, code,
                 named(first, " and ", second) + ", from its start to the first control point");
    return;
  }
  SplineMove spline = curve_to_words(block, *plane);
  const CurvePoint start = point_in(*plane, block.modal.position_W);
  const CurvePoint end = point_in(*plane, spline.base.end);
  const CurvePoint arrival = distance_of(block, *plane, 'P', 'Q');
  const CurvePoint& before = block.modal.curve.arrival;
  const CurvePoint departure =
      has_start ? distance_of(block, *plane, first, second) : CurvePoint{-before[0], -before[1]};
  spline.degree = 3;
  spline.points = {sum_of_points(start, departure), sum_of_points(end, arrival), end};
  block.modal.curve.arrival = arrival;
  emit(block, spline);
}

void move_in_quadratic(ActiveBlock& block, CodeNumber code) {
  const auto plane = curve_plane_of(block, code);
  if (!plane) return;
  const char first = plane->first_distance;
  const char second = plane->second_distance;
  const CurvePoint control = distance_of(block, *plane, first, second);
  if (control == CurvePoint{}) {
    fail_missing(block, code,
                 named(first, " or ", second) + ", from its start to the control point");
    return;
  }
  SplineMove spline = curve_to_words(block, *plane);
  spline.degree = 2;
  spline.points = {sum_of_points(point_in(*plane, block.modal.position_W), control),
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
    block.fail("E4312", {'L', -1, {}}, "the order belongs in the first block of the curve",
               "too late");
    return;
  }
  if (block.has('L')) {
    const auto order = block.integer('L', 2, order_max);
    if (!order) return;
    curve.order = *order;
  }
  if (block.programmed == 0) return;
  curve.points.push_back(programmed_point(block, *plane, curve.points.back()));
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
    block.fail(
        "E4313", code_word(code),
        "a curve of order " + std::to_string(order) + " needs at least that many control points",
        "only " + std::to_string(curve.points.size()) + " with the start point");
    return;
  }
  const auto plane = curve_plane_of(block, code);
  if (!plane) return;
  SplineMove spline = curve_to_words(block, *plane);
  aim_at(spline, *plane, curve.points.back());
  spline.degree = curve.order - 1;
  spline.points.assign(curve.points.begin() + 1, curve.points.end());
  spline.weights = curve.weights;
  curve.close();
  emit(block, spline);
}

void collect_knot(ActiveBlock& block, CodeNumber code) {
  const auto plane = curve_plane_of(block, code);
  if (!plane || excluded_by_mode(block, code, {Exclusion::inverse_time})) return;
  ProgrammedCurve& curve = block.modal.curve;
  if (!block.has('K')) {
    fail_missing(block, code, "K, the knot, in each of its blocks");
    return;
  }
  const double weight = block.has('R') ? block.value('R') : 1.0;
  if (weight <= 0.0) {
    block.fail("E4008", {'R', -1, {}}, "the weight of a control point must be greater than zero",
               "out of range");
    return;
  }
  if (!curve.open()) {
    if (!begin_knotted(block, *plane, code)) return;
  } else if (block.has('P')) {
    block.fail("E4312", {'P', -1, {}}, "the order belongs in the first block of the curve",
               "too late");
    return;
  }
  if (!knot_fits(block, block.value('K'))) return;
  if (block.programmed != 0) {
    const CurvePoint before =
        curve.open() ? curve.points.back() : point_in(*plane, block.modal.position_W);
    curve.points.push_back(programmed_point(block, *plane, before));
    curve.weights.push_back(weight);
  }
  curve.knots.push_back(block.value('K'));
  if (block.programmed == 0 && curve.knots_to_come() == 0) emit_knotted(block, *plane, code);
}

// G5 P10000/P0, G5.1 Q1/Q0 and G8 P1/P0 switch look-ahead of other controls; here it is always on.
void accept_high_speed(ActiveBlock& block, CodeNumber code) {
  const char letter = code == g(5, 1) ? 'Q' : 'P';
  const double on = code == g(5) ? 10000.0 : 1.0;
  const double value = block.has(letter) ? block.value(letter) : -1.0;
  if (value == 0.0 || value == on) return;
  if (!block.has(letter)) {
    fail_missing(
        block, code,
        code == g(5) ? "an end, I J K in its plane, P and Q" : "an end, and I J K in its plane");
    return;
  }
  const std::string name = "`" + code_text('G', code) + "` without axis words takes ";
  block.fail("E4008", {letter, -1, {}},
             name + letter + (code == g(5) ? "10000" : "1") + " or " + letter + "0",
             "out of range");
}

}  // namespace stanok::lang

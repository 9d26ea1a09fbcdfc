#include "lang/block/turned_contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lang/elements/plane_element.h"

namespace stanok::lang {
namespace {

// Where `segment` comes to the level `depth`, which lies between those of its ends.
double along_at(const TurnedSegment& segment, double depth) {
  const double low = std::min(segment.start.along, segment.end.along);
  const double high = std::max(segment.start.along, segment.end.along);
  if (!segment.arc) {
    const double part = (depth - segment.start.depth) / (segment.end.depth - segment.start.depth);
    return std::clamp(segment.start.along + part * (segment.end.along - segment.start.along), low,
                      high);
  }
  const double radius = std::hypot(segment.start.depth - segment.centre.depth,
                                   segment.start.along - segment.centre.along);
  const double up = depth - segment.centre.depth;
  const double reach = std::sqrt(std::max((radius - up) * (radius + up), 0.0));
  const bool before = (low + high) / 2.0 < segment.centre.along;
  return std::clamp(segment.centre.along + (before ? -reach : reach), low, high);
}

TurningPoint sum(TurningPoint a, TurningPoint b) {
  return {a.x + b.x, a.z + b.z};
}

// Points at which an arc is at a quarter of its circle: it is monotonic between them.
std::vector<TurningPoint> quarters(const PlaneMove& move, TurningPoint start) {
  const PlaneElement arc = with_sweep({{start.z, start.x},
                                       {move.end.z, move.end.x},
                                       true,
                                       {move.centre.z, move.centre.x},
                                       move.counter_clockwise,
                                       0.0},
                                      1);
  const double radius = norm(arc.start - arc.centre);
  const double from = std::atan2(start.x - move.centre.x, start.z - move.centre.z);
  const double sign = move.counter_clockwise ? 1.0 : -1.0;
  std::vector<TurningPoint> points;
  int quarter = static_cast<int>(std::floor(sign * from / quarter_turn)) + 1;
  for (; quarter * quarter_turn < sign * from + arc.sweep - same_point; ++quarter) {
    if (quarter * quarter_turn < sign * from + same_point) continue;
    const double angle = sign * quarter * quarter_turn;
    points.push_back(
        {move.centre.x + radius * std::sin(angle), move.centre.z + radius * std::cos(angle)});
  }
  points.push_back(move.end);
  return points;
}

}  // namespace

TurnedContour::TurnedContour(const std::vector<PlaneMove>& moves, TurningPoint start,
                             TurningPoint allowance, PassAxis along)
    : start_(start), along_z_(along == PassAxis::z) {
  if (moves.size() < 2 || moves.front().arc) {
    problem_ =
        "its first block must lead to the contour with G0 or G1, and one more move must follow";
    problem_line_ = moves.empty() ? 0 : moves.front().line;
    return;
  }
  const TurnedPoint first = turned(moves.front().end);
  const TurnedPoint last = turned(moves.back().end);
  const double extreme = std::abs(first.depth) >= std::abs(last.depth) ? first.depth : last.depth;
  depth_sign_ = extreme < 0.0 ? -1.0 : 1.0;
  along_sign_ = last.along < first.along ? -1.0 : 1.0;
  TurningPoint at = moves.front().end;
  for (std::size_t k = 1; k < moves.size() && problem_.empty(); ++k) {
    add(moves[k], at, allowance);
    at = moves[k].end;
  }
  if (problem_.empty() && segments_.empty()) problem_ = "it has no length";
}

TurnedPoint TurnedContour::turned(TurningPoint p) const {
  const double x = p.x - start_.x;
  const double z = p.z - start_.z;
  return {depth_sign_ * (along_z_ ? x : z), along_sign_ * (along_z_ ? z : x)};
}

TurningPoint TurnedContour::point(TurnedPoint p) const {
  const double depth = depth_sign_ * p.depth;
  const double along = along_sign_ * p.along;
  return along_z_ ? TurningPoint{start_.x + depth, start_.z + along}
                  : TurningPoint{start_.x + along, start_.z + depth};
}

void TurnedContour::add(const PlaneMove& move, TurningPoint start, TurningPoint allowance) {
  TurningPoint from = start;
  const std::vector<TurningPoint> ends =
      move.arc ? quarters(move, start) : std::vector<TurningPoint>{move.end};
  for (const TurningPoint& to : ends) {
    add_segment({turned(sum(from, allowance)), turned(sum(to, allowance)), move.arc,
                 turned(sum(move.centre, allowance)), move.counter_clockwise, move.line});
    from = to;
  }
}

void TurnedContour::add_segment(const TurnedSegment& segment) {
  const double along = segment.end.along - segment.start.along;
  if (along < -same_point && problem_.empty()) {
    problem_ = along_z_ ? "it goes back along Z" : "it goes back along X";
    problem_line_ = segment.line;
  }
  if (std::hypot(along, segment.end.depth - segment.start.depth) > same_point)
    segments_.push_back(segment);
}

double TurnedContour::deepest() const {
  double depth = segments_.front().start.depth;
  for (const TurnedSegment& segment : segments_) depth = std::max(depth, segment.end.depth);
  return depth;
}

double TurnedContour::shallowest() const {
  double depth = segments_.front().start.depth;
  for (const TurnedSegment& segment : segments_) depth = std::min(depth, segment.end.depth);
  return depth;
}

std::vector<TurnedStretch> TurnedContour::stretches(double depth) const {
  std::vector<TurnedStretch> list;
  const TurnedPoint first = first_point();
  TurnedStretch open{std::min(first.along, 0.0), 0.0, true};
  bool is_open = first.depth >= depth;
  const auto close = [&](double along) {
    open.end = along;
    if (open.end - open.begin > same_point) list.push_back(open);
    is_open = false;
  };
  for (const TurnedSegment& segment : segments_) {
    const bool deep = segment.end.depth >= depth;
    if (is_open && !deep) close(along_at(segment, depth));
    if (!is_open && deep) {
      open = {along_at(segment, depth), 0.0, false};
      is_open = true;
    }
  }
  if (is_open) close(segments_.back().end.along);
  return list;
}

std::vector<PlaneMove> TurnedContour::without_pockets() const {
  std::vector<PlaneMove> moves;
  const auto straight_to = [&](TurnedPoint end, const TurnedSegment& of) {
    TurnedSegment line = of;
    line.arc = false;
    moves.push_back(move_to(end, line));
  };
  straight_to(first_point(), segments_.front());
  double level = first_point().depth;
  bool in_pocket = false;
  for (const TurnedSegment& segment : segments_) {
    if (segment.end.depth > level + same_point) {
      in_pocket = true;
      continue;
    }
    if (in_pocket) {
      straight_to({level, along_at(segment, level)}, segment);
      in_pocket = false;
    }
    moves.push_back(move_to(segment.end, segment));
    level = std::min(level, segment.end.depth);
  }
  if (in_pocket) straight_to({level, segments_.back().end.along}, segments_.back());
  return moves;
}

PlaneMove TurnedContour::move_to(TurnedPoint end, const TurnedSegment& of) const {
  return {point(end), of.arc, point(of.centre), of.counter_clockwise, of.line};
}

}  // namespace stanok::lang

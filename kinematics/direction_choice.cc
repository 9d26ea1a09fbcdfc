#include "kinematics/direction_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/angle_units.h"

namespace stanok::kinematics {
namespace {

constexpr double turn = 360.0;
constexpr double same_deg = 1e-9;  // angles and ways closer than this are equal

using Angles = std::array<double, 2>;

// The angle, give or take whole turns, within `travel` and nearest to `from`.
std::optional<double> nearest_turn(double angle, const AngleTravel& travel, double from) {
  const double lowest = std::ceil((travel.min_deg - same_deg - angle) / turn);
  const double highest = std::floor((travel.max_deg + same_deg - angle) / turn);
  if (lowest > highest) return std::nullopt;
  const double turns = std::clamp(std::round((from - angle) / turn), lowest, highest);
  return std::clamp(angle + turn * turns, travel.min_deg, travel.max_deg);
}

// How far `angle` comes beyond the travel, give or take whole turns; and where.
struct Excess {
  double by_deg = std::numeric_limits<double>::infinity();
  double needed_deg = 0.0;
  double limit_deg = 0.0;
};
Excess excess_of(double angle, const AngleTravel& travel) {
  const double below = angle + turn * std::floor((travel.min_deg - angle) / turn);
  const double above = below + turn;
  if (travel.min_deg - below < above - travel.max_deg)
    return {travel.min_deg - below, below, travel.min_deg};
  return {above - travel.max_deg, above, travel.max_deg};
}

bool has_sign(double angle, FirstAngle wanted) {
  const double alone = std::remainder(angle, turn);
  switch (wanted) {
    case FirstAngle::positive:
      return alone > -same_deg || alone < -180.0 + same_deg;
    case FirstAngle::negative:
      return alone < same_deg || alone > 180.0 - same_deg;
    case FirstAngle::any:
      break;
  }
  return true;
}

// What the branches come to within the travel.
class Selection {
 public:
  Selection(const DirectionSolution& solution, const DirectionWish& wish)
      : axes_(solution.axes), wish_(wish) {
    for (std::size_t k = 0; k < solution.count; ++k) consider(solution.branches[k]);
  }

  void write(DirectionChoice& choice) const {
    using enum DirectionChoice::Outcome;
    if (found_) {
      choice.outcome = found;
      choice.angles_deg = *found_;
    } else if (excess_axis_.exists()) {
      choice.outcome = beyond_limit;
      choice.axis = excess_axis_;
      choice.needed_deg = excess_.needed_deg;
      choice.limit_deg = excess_.limit_deg;
    } else {
      choice.outcome = wrong_sign;
    }
  }

 private:
  [[nodiscard]] const AngleTravel& travel(std::size_t k) const { return wish_.travel[axes_[k]]; }
  [[nodiscard]] double from(std::size_t k) const { return wish_.from_B[axes_[k]]; }

  void consider(const DirectionBranch& branch) {
    Angles angles{};
    bool fits = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const double wanted = branch.is_free[k] ? from(k) : branch.angles_deg[k];
      if (k == 0 && !branch.is_free[0] && !has_sign(wanted, wish_.first)) return;
      const double kept = std::clamp(wanted, travel(k).min_deg, travel(k).max_deg);
      const auto angle = branch.is_free[k] ? kept : nearest_turn(wanted, travel(k), from(k));
      if (angle) {
        angles[k] = *angle;
        continue;
      }
      fits = false;
      const Excess excess = excess_of(wanted, travel(k));
      if (excess.by_deg >= excess_.by_deg) continue;
      excess_ = excess;
      excess_axis_ = axes_[k];
    }
    if (fits) take(angles);
  }

  void take(const Angles& angles) {
    const double way = std::abs(angles[0] - from(0)) + std::abs(angles[1] - from(1));
    const bool nearer = way < way_ - same_deg;
    const bool as_near = way < way_ + same_deg;
    if (found_ && !nearer && !(as_near && angles[0] > (*found_)[0])) return;
    found_ = angles;
    way_ = std::min(way, way_);
  }

  std::array<AxisIndex, 2> axes_;
  const DirectionWish& wish_;
  std::optional<Angles> found_;
  double way_ = std::numeric_limits<double>::infinity();
  AxisIndex excess_axis_;
  Excess excess_;
};

// The direction within the travel that comes nearest to the wanted one. With the other axis held,
// its cosine with the wanted one is u + v cos(angle) + w sin(angle), whose best angle is known:
// both axes take it in turn.
class NearestDirection {
 public:
  NearestDirection(const Scheme& scheme, const DirectionWish& wish,
                   const std::array<AxisIndex, 2>& axes)
      : scheme_(scheme), wish_(wish), axes_(axes) {}

  // From everywhere: limits leave several directions from which no single axis leads nearer.
  void start_on_a_grid() {
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        start_at({at_part(0, 1.0 * i / steps), at_part(1, 1.0 * j / steps)});
      }
    }
  }

  void start_at(Angles angles) {
    for (std::size_t k = 0; k < 2; ++k) angles[k] = within(k, angles[k]);
    for (int round = 0; round < rounds; ++round) {
      const Angles before = angles;
      improve(angles, 0);
      improve(angles, 1);
      if (std::abs(angles[0] - before[0]) + std::abs(angles[1] - before[1]) < same_deg) break;
    }
    const double cosine = cosine_at(angles);
    if (cosine <= best_cosine_) return;
    best_cosine_ = cosine;
    best_ = angles;
  }

  void write(DirectionChoice& choice) const {
    choice.angles_deg = best_;
    choice.nearest_B = direction_at(best_);
    const Vector3<double> across = choice.nearest_B.cross(wish_.tool_B);
    choice.off_deg = deg_per_rad * std::atan2(std::hypot(across.x(), across.y(), across.z()),
                                              dot(choice.nearest_B, wish_.tool_B));
  }

 private:
  static constexpr int rounds = 60;  // the error shrinks by a constant factor in each

  // Of its travel, of which a whole turn is enough.
  [[nodiscard]] double at_part(std::size_t k, double part) const {
    const AngleTravel& travel = wish_.travel[axes_[k]];
    const double low = std::max(travel.min_deg, wish_.from_B[axes_[k]] - 180.0);
    const double high = std::min(travel.max_deg, low + turn);
    return low + part * (high - low);
  }
  [[nodiscard]] double within(std::size_t k, double angle) const {
    const AngleTravel& travel = wish_.travel[axes_[k]];
    return std::clamp(angle, travel.min_deg, travel.max_deg);
  }
  [[nodiscard]] Vector3<double> direction_at(const Angles& angles) const {
    AxisVector<double> point_B = wish_.from_B;
    for (std::size_t k = 0; k < 2; ++k) point_B[axes_[k]] = angles[k];
    return scheme_.spindle_axes(point_B)[2];
  }
  [[nodiscard]] double cosine_at(const Angles& angles) const {
    return dot(direction_at(angles), wish_.tool_B);
  }

  void improve(Angles& angles, std::size_t k) const {
    const auto at = [&](double angle) {
      Angles there = angles;
      there[k] = angle;
      return there;
    };
    const double forth = cosine_at(at(0.0));
    const double back = cosine_at(at(180.0));
    const double aside = cosine_at(at(90.0));
    const double best =
        deg_per_rad * std::atan2(aside - 0.5 * (forth + back), 0.5 * (forth - back));
    const AngleTravel& travel = wish_.travel[axes_[k]];
    if (const auto angle = nearest_turn(best, travel, angles[k])) {
      angles[k] = *angle;
      return;
    }
    const Angles low = at(travel.min_deg);
    const Angles high = at(travel.max_deg);
    angles = cosine_at(low) > cosine_at(high) ? low : high;
  }

  const Scheme& scheme_;
  const DirectionWish& wish_;
  std::array<AxisIndex, 2> axes_;
  Angles best_{};
  double best_cosine_ = -2.0;
};

}  // namespace

DirectionChoice choose_direction(const Scheme& scheme, const DirectionWish& wish) {
  DirectionChoice choice;
  const DirectionSolution solution = scheme.directions(wish.tool_B);
  choice.axes = solution.axes;
  if (solution.kind == DirectionSolution::Kind::no_rotary_axes) return choice;
  choice.outcome = DirectionChoice::Outcome::out_of_reach;
  DirectionSolution starts = solution;
  if (solution.kind == DirectionSolution::Kind::reached) {
    Selection(solution, wish).write(choice);
    if (choice.outcome == DirectionChoice::Outcome::found) return choice;
  } else {
    starts = scheme.directions(solution.nearest_B);
  }
  NearestDirection nearest(scheme, wish, choice.axes);
  nearest.start_at({wish.from_B[choice.axes[0]], wish.from_B[choice.axes[1]]});
  nearest.start_on_a_grid();
  for (std::size_t k = 0; k < starts.count; ++k) nearest.start_at(starts.branches[k].angles_deg);
  nearest.write(choice);
  return choice;
}

}  // namespace stanok::kinematics

// Ways of pockets with islands against the exact geometry of their outlines: none is nearer to a
// wall than the tool is wide, and all that the tool can reach is cut.
#include "lang/pockets/pocket_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace stanok::lang {
namespace {

using ::testing::HasSubstr;

// Outlines by their corners and arcs, counter-clockwise around what is to be cut.
class Outline {
 public:
  explicit Outline(PlanePoint begin) : at_(begin) {}
  Outline& to(double first, double second) {
    PlaneElement line;
    line.start = at_;
    line.end = {first, second};
    return add(line);
  }
  Outline& arc(double first, double second, PlanePoint centre, bool counter_clockwise) {
    PlaneElement arc;
    arc.start = at_;
    arc.end = {first, second};
    arc.arc = true;
    arc.centre = centre;
    arc.counter_clockwise = counter_clockwise;
    return add(with_sweep(arc, 1));
  }
  std::vector<OutlineElement> elements;

 private:
  Outline& add(const PlaneElement& element) {
    elements.push_back({element, static_cast<std::uint32_t>(elements.size() + 1)});
    at_ = element.end;
    return *this;
  }
  PlanePoint at_;
};

// The distance of a point from an element, by its definition.
double distance(const PlaneElement& element, PlanePoint p) {
  if (!element.arc) {
    const PlanePoint way = element.end - element.start;
    const double part = std::clamp(dot(p - element.start, way) / dot(way, way), 0.0, 1.0);
    return norm(p - (element.start + part * way));
  }
  const PlanePoint from = element.start - element.centre;
  const PlanePoint to = p - element.centre;
  double turned = std::atan2(cross(from, to), dot(from, to));
  if (!element.counter_clockwise) turned = -turned;
  if (turned < 0.0) turned += full_turn;
  if (turned <= element.sweep) return std::abs(norm(to) - norm(from));
  return std::min(norm(p - element.start), norm(p - element.end));
}

double distance(PlanePoint a, PlanePoint b, PlanePoint p) {
  const PlanePoint way = b - a;
  const double length2 = dot(way, way);
  const double part = length2 > 0.0 ? std::clamp(dot(p - a, way) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + part * way));
}

// A pocket whose walls are known without the bridges of the outline to its islands.
struct Walls {
  std::vector<PlaneElement> elements;
  std::function<bool(PlanePoint)> contains;

  [[nodiscard]] double distance_to(PlanePoint p) const {
    double nearest = 1e9;
    for (const PlaneElement& element : elements) nearest = std::min(nearest, distance(element, p));
    return nearest;
  }
};

void expect_no_gouge(const std::vector<PocketWay>& ways, const Walls& walls, double radius) {
  double nearest = 1e9;
  for (const PocketWay& way : ways) {
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      const double length = norm(way[k + 1] - way[k]);
      const int steps = std::max(2, static_cast<int>(length / 0.05));
      for (int n = 0; n <= steps; ++n) {
        const PlanePoint p = way[k] + (static_cast<double>(n) / steps) * (way[k + 1] - way[k]);
        ASSERT_TRUE(walls.contains(p)) << p.first << " " << p.second;
        nearest = std::min(nearest, walls.distance_to(p));
      }
    }
  }
  EXPECT_GE(nearest, radius - 1e-6);
  EXPECT_LE(nearest, radius + 5e-3);
}

// Every place of the pocket on which the tool could stand is swept by it, and so is all it covers
// there but for the deviation of chords.
void expect_all_cut(const std::vector<PocketWay>& ways, const Walls& walls, double radius,
                    PlanePoint low, PlanePoint high) {
  const double slack = 5e-3;  // chords of walls, and of the offset
  int missed = 0;
  int looked_at = 0;
  std::mt19937 random(150);
  std::uniform_real_distribution<double> first(low.first, high.first);
  std::uniform_real_distribution<double> second(low.second, high.second);
  std::uniform_real_distribution<double> angle(0.0, full_turn);
  while (looked_at < 3000) {
    const PlanePoint middle{first(random), second(random)};
    if (!walls.contains(middle) || walls.distance_to(middle) < radius + slack) continue;
    ++looked_at;
    const double turned = angle(random);
    const PlanePoint p = middle + (radius - slack) * PlanePoint{std::cos(turned), std::sin(turned)};
    double nearest = 1e9;
    for (const PocketWay& way : ways) {
      for (std::size_t k = 0; k + 1 < way.size(); ++k)
        nearest = std::min(nearest, distance(way[k], way[k + 1], p));
    }
    if (nearest > radius) ++missed;
  }
  EXPECT_EQ(missed, 0) << "of " << looked_at;
}

// Square, 50 x 50, with a square island of 15 x 15 hung to the wall by a bridge, as in the manual.
Outline square_with_island() {
  Outline outline({20.0, 10.0});
  outline.to(60, 10).to(60, 60).to(10, 60).to(10, 32).to(27.5, 32).to(27.5, 42.5).to(42.5, 42.5);
  outline.to(42.5, 27.5).to(27.5, 27.5).to(27.5, 38).to(10, 38).to(10, 10).to(20, 10);
  return outline;
}
Walls square_with_island_walls() {
  Outline outer({10, 10});
  outer.to(60, 10).to(60, 60).to(10, 60).to(10, 10);
  Outline island({27.5, 27.5});
  island.to(27.5, 42.5).to(42.5, 42.5).to(42.5, 27.5).to(27.5, 27.5);
  Walls walls;
  for (const Outline& one : {outer, island}) {
    for (const OutlineElement& element : one.elements) walls.elements.push_back(element.element);
  }
  walls.contains = [](PlanePoint p) {
    const bool in = p.first > 10 && p.first < 60 && p.second > 10 && p.second < 60;
    return in && !(p.first > 27.5 && p.first < 42.5 && p.second > 27.5 && p.second < 42.5);
  };
  return walls;
}

// A circle of 30 about the origin with a round island of radius 8 at (10, 0).
Outline round_with_round_island() {
  Outline outline({30.0, 0.0});
  outline.arc(-30, 0, {0, 0}, true).arc(30, 0, {0, 0}, true).to(18, 0);
  outline.arc(2, 0, {10, 0}, false).arc(18, 0, {10, 0}, false).to(30, 0);
  return outline;
}
Walls round_with_round_island_walls() {
  Outline outer({30.0, 0.0});
  outer.arc(-30, 0, {0, 0}, true).arc(30, 0, {0, 0}, true);
  Outline island({18.0, 0.0});
  island.arc(2, 0, {10, 0}, false).arc(18, 0, {10, 0}, false);
  Walls walls;
  for (const Outline& one : {outer, island}) {
    for (const OutlineElement& element : one.elements) walls.elements.push_back(element.element);
  }
  walls.contains = [](PlanePoint p) {
    return norm(p) < 30.0 && norm(p - PlanePoint{10.0, 0.0}) > 8.0;
  };
  return walls;
}

struct PocketCase {
  Outline outline;
  Walls walls;
  PlanePoint start;
  double radius;
  double step;
  ScanLines lines;
};

TEST(PocketPlan, CutsAllThatTheToolReachesAndNothingElse) {
  std::vector<PocketCase> cases;
  for (const ScanLines lines : {ScanLines::along_first, ScanLines::along_second}) {
    for (const double radius : {2.0, 4.0}) {
      for (const double part : {0.8, 1.4, 1.95}) {
        cases.push_back({square_with_island(),
                         square_with_island_walls(),
                         {20.0, 20.0},
                         radius,
                         part * radius,
                         lines});
        cases.push_back({round_with_round_island(),
                         round_with_round_island_walls(),
                         {-10.0, 3.0},
                         radius,
                         part * radius,
                         lines});
      }
    }
  }
  for (const PocketCase& one : cases) {
    const auto plan = plan_pocket({.outline = one.outline.elements,
                                   .start = one.start,
                                   .radius_mm = one.radius,
                                   .finish_mm = 0.0,
                                   .step_mm = one.step,
                                   .lines = one.lines});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_TRUE(plan->finish.empty());
    EXPECT_EQ(plan->level.front().front().first, one.start.first);
    expect_no_gouge(plan->level, one.walls, one.radius);
    expect_all_cut(plan->level, one.walls, one.radius, {-30, -30}, {60, 60});
  }
}

TEST(PocketPlan, LeavesTheAllowanceAndTakesItWithTheLastPass) {
  const auto plan = plan_pocket({.outline = square_with_island().elements,
                                 .start = {20.0, 20.0},
                                 .radius_mm = 3.0,
                                 .finish_mm = 0.25,
                                 .step_mm = 4.0});
  ASSERT_TRUE(plan) << plan.error().message;
  const Walls walls = square_with_island_walls();
  expect_no_gouge(plan->level, walls, 3.25);
  ASSERT_EQ(plan->finish.size(), 2U);
  expect_no_gouge(plan->finish, walls, 3.0);
  std::vector<PocketWay> all = plan->level;
  all.insert(all.end(), plan->finish.begin(), plan->finish.end());
  expect_all_cut(all, walls, 3.0, {10, 10}, {60, 60});
}

// Where a way does not begin where the one before ended, the tool comes down: only where it has
// cut.
TEST(PocketPlan, ComesDownWhereItHasCut) {
  for (const ScanLines lines : {ScanLines::along_first, ScanLines::along_second}) {
    const auto plan = plan_pocket({.outline = round_with_round_island().elements,
                                   .start = {-10.0, 3.0},
                                   .radius_mm = 3.0,
                                   .finish_mm = 0.2,
                                   .step_mm = 4.0,
                                   .lines = lines});
    ASSERT_TRUE(plan);
    std::vector<PocketWay> done{plan->level.front()};
    std::vector<PocketWay> rest(plan->level.begin() + 1, plan->level.end());
    rest.insert(rest.end(), plan->finish.begin(), plan->finish.end());
    for (const PocketWay& way : rest) {
      double nearest = 1e9;
      for (const PocketWay& before : done) {
        for (std::size_t k = 0; k + 1 < before.size(); ++k)
          nearest = std::min(nearest, distance(before[k], before[k + 1], way.front()));
      }
      EXPECT_LT(nearest, 1e-5);
      done.push_back(way);
    }
    EXPECT_LE(plan->level.size(), 6U) << "the tool is lifted too often";
  }
}

std::string refusal(const Outline& outline, PlanePoint start, double radius, double finish = 0.0) {
  const auto plan = plan_pocket({.outline = outline.elements,
                                 .start = start,
                                 .radius_mm = radius,
                                 .finish_mm = finish,
                                 .step_mm = radius});
  if (plan) return "taken";
  EXPECT_FALSE(plan.error().help.empty());
  return plan.error().message + " line " + std::to_string(plan.error().line);
}

TEST(PocketPlan, RefusesWhereTheToolDoesNotFit) {
  // Between island and wall 12 mm are left at (18..30, 0).
  EXPECT_EQ(refusal(round_with_round_island(), {-10, 0}, 5.9), "taken");
  // A wider tool leaves a ring that is open there, and touches both still.
  EXPECT_EQ(refusal(round_with_round_island(), {-10, 0}, 6.1), "taken");
  EXPECT_THAT(refusal(round_with_round_island(), {-10, 0}, 20.0), HasSubstr("does not fit"));
  EXPECT_THAT(refusal(round_with_round_island(), {10, 0}, 3.0),
              HasSubstr("cannot plunge at 10, 0"));
  EXPECT_THAT(refusal(round_with_round_island(), {28, 0}, 3.0), HasSubstr("cannot plunge"));
}

TEST(PocketPlan, RefusesNarrowPlacesThatWouldStay) {
  // Two chambers of 20 x 20 with a neck of 6 mm between them.
  Outline chambers({0.0, 0.0});
  chambers.to(20, 0).to(20, 7).to(30, 7).to(30, 0).to(50, 0).to(50, 20).to(30, 20).to(30, 13);
  chambers.to(20, 13).to(20, 20).to(0, 20).to(0, 0);
  EXPECT_EQ(refusal(chambers, {10, 10}, 2.9), "taken");
  EXPECT_THAT(refusal(chambers, {10, 10}, 3.1), HasSubstr("reach this part of the outline line 3"));
  EXPECT_THAT(refusal(chambers, {10, 10}, 2.9, 0.2), HasSubstr("cannot pass a narrow place"));
  // A dead end of 5 mm begins with line 3.
  Outline dead_end({0.0, 0.0});
  dead_end.to(20, 0).to(20, 8).to(30, 8).to(30, 13).to(20, 13).to(20, 20).to(0, 20).to(0, 0);
  EXPECT_EQ(refusal(dead_end, {10, 10}, 2.4), "taken");
  EXPECT_THAT(refusal(dead_end, {10, 10}, 2.6), HasSubstr("reach this part of the outline line 3"));
  // A corner of radius 2.
  Outline rounded({0.0, 0.0});
  rounded.to(20, 0).to(20, 18).arc(18, 20, {18, 18}, true).to(0, 20).to(0, 0);
  EXPECT_EQ(refusal(rounded, {10, 10}, 1.9), "taken");
  EXPECT_THAT(refusal(rounded, {10, 10}, 2.5), HasSubstr("reach this part of the outline line 3"));
}

TEST(PocketPlan, RefusesWhatWouldTakeTooMuch) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double far : {1.1e5, 1e300, nan}) {
    Outline outline({0.0, 0.0});
    outline.to(far, 0).to(far, 20).to(0, 20).to(0, 0);
    EXPECT_THAT(refusal(outline, {10, 10}, 2.0), HasSubstr("more than 100 m away line 1")) << far;
  }
  Outline square({0.0, 0.0});
  square.to(90, 0).to(90, 90).to(0, 90).to(0, 0);
  EXPECT_EQ(refusal(square, {10, 10}, 2.0), "taken");
  EXPECT_THAT(refusal(square, {10, 10}, 1e300), HasSubstr("more than 100 m away"));
  // Lines as far apart as the tool has radius: 90 / 0.008.
  EXPECT_THAT(refusal(square, {10, 10}, 0.008), HasSubstr("more than 10000 would be needed"));
  // A circle of 60 m has some 12,000 chords.
  Outline circle({6e4, 0.0});
  circle.arc(-6e4, 0, {0, 0}, true).arc(6e4, 0, {0, 0}, true);
  EXPECT_THAT(refusal(circle, {0, 0}, 50.0), HasSubstr("more than 8000 corners"));
}

TEST(PocketPlan, RefusesAnOutlineThatRunsTheOtherWay) {
  Outline clockwise({0.0, 0.0});
  clockwise.to(0, 20).to(20, 20).to(20, 0).to(0, 0);
  EXPECT_THAT(refusal(clockwise, {10, 10}, 2.0), HasSubstr("nothing is inside"));
}

}  // namespace
}  // namespace stanok::lang

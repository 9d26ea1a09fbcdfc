// Radius compensation against its definition: the path of the centre keeps the distance of the tool
// radius to the programmed contour.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

struct Point {
  double x = 0.0;
  double y = 0.0;
};

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// As programmed: a line, or an arc when `radius` is not 0.
struct Element {
  Point start;
  Point end;
  Point centre;
  double radius = 0.0;
  bool counter_clockwise = false;
};

double angle_of(Point centre, Point p) {
  return std::atan2(p.y - centre.y, p.x - centre.x);
}

// Angle from `from` to `to` in the direction of the arc, [0, 2 pi).
double travel(bool counter_clockwise, double from, double to) {
  const double angle = counter_clockwise ? to - from : from - to;
  return angle - full_turn * std::floor(angle / full_turn);
}

// Whether the foot of `p` lies inside the element, and the distance there or to the nearer end.
struct Foot {
  bool inside = false;
  double distance = 0.0;
};

Foot foot_on(const Element& element, Point p) {
  const double ends = std::min(distance(p, element.start), distance(p, element.end));
  if (element.radius == 0.0) {
    const double dx = element.end.x - element.start.x;
    const double dy = element.end.y - element.start.y;
    const double square = dx * dx + dy * dy;
    const double part = ((p.x - element.start.x) * dx + (p.y - element.start.y) * dy) / square;
    if (part <= 0.0 || part >= 1.0) return {false, ends};
    const double across = (p.x - element.start.x) * dy - (p.y - element.start.y) * dx;
    return {true, std::abs(across) / std::sqrt(square)};
  }
  const double start = angle_of(element.centre, element.start);
  const double sweep =
      travel(element.counter_clockwise, start, angle_of(element.centre, element.end));
  const double at = travel(element.counter_clockwise, start, angle_of(element.centre, p));
  if (at > sweep) return {false, ends};
  return {true, std::abs(distance(p, element.centre) - element.radius)};
}

// Points of a move from `start`, its ends included.
std::vector<Point> samples(Point start, const Move& move) {
  constexpr int count = 40;
  const Point end{move.end[0], move.end[1]};
  std::vector<Point> points;
  for (int k = 0; k <= count; ++k) {
    const double part = static_cast<double>(k) / count;
    if (move.kind != MoveKind::arc) {
      points.push_back({start.x + part * (end.x - start.x), start.y + part * (end.y - start.y)});
      continue;
    }
    const Point centre{move.centre[0], move.centre[1]};
    const double from = angle_of(centre, start);
    double sweep = travel(move.counter_clockwise, from, angle_of(centre, end));
    if (sweep < 1e-12) sweep = full_turn;
    const double angle = from + (move.counter_clockwise ? part : -part) * sweep;
    const double radius =
        distance(centre, start) + part * (distance(centre, end) - distance(centre, start));
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

// A random closed contour around the origin, counter-clockwise, that begins in the middle of a line
// on the X axis side.
class RandomContour {
 public:
  explicit RandomContour(unsigned seed) : random_(seed) {
    const int corners = 5 + static_cast<int>(random_() % 8);
    std::vector<Point> points;
    for (int k = 0; k < corners; ++k) {
      const double angle = full_turn * (k + uniform(-0.3, 0.3)) / corners;
      const double radius = uniform(40.0, 75.0);
      points.push_back(rounded({radius * std::cos(angle), radius * std::sin(angle)}));
    }
    const Point middle =
        rounded({(points.back().x + points[0].x) / 2.0, (points.back().y + points[0].y) / 2.0});
    add_line(middle, points[0]);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) add(points[k], points[k + 1]);
    add_line(points.back(), middle);
  }

  std::vector<Element> elements;
  std::string text;  // one line each
  std::mt19937_64& random() { return random_; }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  // As many decimals as the text has.
  static Point rounded(Point p) {
    return {std::round(p.x * 1e6) / 1e6, std::round(p.y * 1e6) / 1e6};
  }

  void add_line(Point start, Point end) {
    elements.push_back({start, end, {}, 0.0, false});
    write("G1 X%.6f Y%.6f\n", end.x, end.y);
  }

  void add(Point start, Point end) {
    const double kind = uniform(0.0, 1.0);
    if (kind < 0.4) return add_line(start, end);
    const double chord = distance(start, end);
    const double radius = chord * uniform(0.6, 2.0);
    const bool left = kind < 0.7;
    const double height = std::sqrt(radius * radius - chord * chord / 4.0);
    const double side = (left ? height : -height) / chord;
    const Point centre{(start.x + end.x) / 2.0 - side * (end.y - start.y),
                       (start.y + end.y) / 2.0 + side * (end.x - start.x)};
    elements.push_back({start, end, centre, radius, left});
    char line[200];
    std::snprintf(line, sizeof line, "G%d X%.6f Y%.6f I%.17f J%.17f\n", left ? 3 : 2, end.x, end.y,
                  centre.x - start.x, centre.y - start.y);
    text += line;
  }

  void write(const char* format, double x, double y) {
    char line[100];
    std::snprintf(line, sizeof line, format, x, y);
    text += line;
  }

  std::mt19937_64 random_;
};

class RadiusCompensationTest : public ProgramTest {
 protected:
  // The program of a contour with `radius` on the side `code`, all but the lead-in, which comes
  // from that side, and the lead-out on lines 3 and following.
  static std::string program(const RandomContour& contour, int code, double radius) {
    const Element& first = contour.elements[0];
    const double way = (code == 41 ? 20.0 : -20.0) / distance(first.start, first.end);
    const Point from{first.start.x - way * (first.end.y - first.start.y),
                     first.start.y + way * (first.end.x - first.start.x)};
    char head[300];
    std::snprintf(head, sizeof head, "F100 G0 X%.6f Y%.6f\nG%d.1 D%.6f G1 X%.6f Y%.6f\n", from.x,
                  from.y, code, 2.0 * radius, first.start.x, first.start.y);
    return head + contour.text + "G40 G1 X0 Y0\nM30\n";
  }

  // Distances of the path of all contour lines; false when the tool did not fit.
  bool keeps_distance(const RandomContour& contour, int code, double radius) {
    run(program(contour, code, radius));
    const bool complete = error.code.empty();
    Point at;
    for (const Command& command : commands) {
      const Move* const move = std::get_if<Move>(&command.payload);
      if (move == nullptr) continue;
      const std::size_t line = command.origin.line;
      if (line >= 3 && line < 3 + contour.elements.size()) {
        // The end of a piece before an error is not yet fitted to what follows.
        const bool last = !complete && &command == &commands.back();
        if (!last) check(contour, line - 3, radius, at, *move);
      }
      at = {move->end[0], move->end[1]};
    }
    return complete;
  }

  void check(const RandomContour& contour, std::size_t index, double radius, Point start,
             const Move& move) {
    const std::size_t count = contour.elements.size();
    for (const Point& p : samples(start, move)) {
      for (std::size_t k = 0; k < count; ++k) {
        const Foot foot = foot_on(contour.elements[k], p);
        EXPECT_GE(foot.distance, radius - 1e-9) << "line " << index + 3 << " element " << k;
      }
      const Foot own = foot_on(contour.elements[index], p);
      if (own.inside) {
        EXPECT_NEAR(own.distance, radius, 1e-9) << "line " << index + 3;
      }
    }
  }
};

TEST_F(RadiusCompensationTest, KeepsTheRadiusToEveryElement) {
  for (unsigned seed = 1; seed <= 600 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomContour contour(seed);
    const int code = seed % 2 == 0 ? 41 : 42;
    const double radius = std::round(contour.uniform(0.2, 4.0) * 1e6) / 1e6;
    EXPECT_TRUE(keeps_distance(contour, code, radius)) << error.code;
  }
}

TEST_F(RadiusCompensationTest, GivesTheSamePathAsTheMirroredContourOnTheOtherSide) {
  const auto left =
      moves("F100 G0 X-20\nG41.1 D6 G1 X0\nX10 Y7\nG3 X20 Y7 I5 J9\nG1 X30\nG40 Y50\nM30\n");
  const auto right =
      moves("F100 G0 X-20\nG42.1 D6 G1 X0\nX10 Y-7\nG2 X20 Y-7 I5 J-9\nG1 X30\nG40 Y-50\nM30\n");
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t k = 0; k < left.size(); ++k) {
    EXPECT_EQ(left[k].kind, right[k].kind);
    EXPECT_NEAR(left[k].end[0], right[k].end[0], 1e-12);
    EXPECT_NEAR(left[k].end[1], -right[k].end[1], 1e-12);
  }
}

TEST_F(RadiusCompensationTest, KeepsFullCirclesFull) {
  // Tangential arcs on and off; the circle of radius 10 is cut on its inside.
  const auto list = moves(
      "F100 G0 X0 Y0\nG41.1 D4 G1 X5 Y-5\nG3 X10 Y0 J5\nG3 I-10 P3\nG3 X5 Y5 I-5\nG40 G1 X0 "
      "Y0\nM30\n");
  ASSERT_EQ(list.size(), 6u);
  const Move& circle = list[3];
  EXPECT_EQ(circle.kind, MoveKind::arc);
  EXPECT_EQ(circle.turns, 3);
  EXPECT_EQ(circle.end[0], list[2].end[0]);
  EXPECT_EQ(circle.end[1], list[2].end[1]);
  EXPECT_NEAR(circle.end[0], 8.0, 1e-12);
}

TEST_F(RadiusCompensationTest, ProgramsTheContourAndNotThePath) {
  const auto list = messages(
      "F100 G42.1 D6 G1 X10\nY10\nmsg (str ($prog_pos[X]) + \" \" + str ($prog_pos[Y]));\nX0\nG40 "
      "X-5\nM30\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0], "10 10");
}

TEST_F(RadiusCompensationTest, HoldsABoundedNumberOfCommands) {
  EXPECT_EQ(error_code("F100 G42.1 D2 G1 X10\nY10\nfor (num count = 0; count < 101; count++) {\n"
                       "G4 P0.1\n}\nX0\nM30\n"),
            "E4148");
}

TEST_F(RadiusCompensationTest, PassesRapidCornersOnLinesOutsideTheArc) {
  const auto list = moves("G0 X-10 Y-10 F100\nG41.1 D2 G0 X0 Y0\nY10\nX10\nY5\nG40 X20\nM30\n");
  Point corner{0.0, 10.0};
  Point at;
  for (std::size_t k = 0; k < list.size(); ++k) {
    EXPECT_EQ(list[k].kind, MoveKind::rapid);
    if (k >= 2) {
      for (const Point& p : samples(at, list[k])) EXPECT_GE(distance(p, corner), 1.0 - 1e-12);
    }
    at = {list[k].end[0], list[k].end[1]};
  }
}

TEST_F(RadiusCompensationTest, TurnsRoundTheEndOfAThinWall) {
  const auto list = moves("F100 G0 X-10 Y0\nG41.1 D4 G1 X0\nX20\nX0\nG40 X-10\nM30\n");
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[3].kind, MoveKind::arc);
  EXPECT_FALSE(list[3].counter_clockwise);
  EXPECT_NEAR(list[3].end[1], -2.0, 1e-12);
}

TEST_F(RadiusCompensationTest, CuttingInInverseTimeKeepsItsSpeedAroundCorners) {
  const auto list =
      moves("G0 X-10 Y-10\nG93 G41.1 D2 G1 X0 Y0 F1\nY10 F2\nX20 F3\nG40 X30 F1\nM30\n");
  ASSERT_EQ(list.size(), 6u);
  // 20 mm three times a minute; the arc is a quarter of a circle of radius 1.
  EXPECT_NEAR(list[3].feed * std::numbers::pi / 2.0, 60.0, 1e-9);
  EXPECT_EQ(list[4].feed, 3.0);
}

}  // namespace
}  // namespace stanok::lang::testing

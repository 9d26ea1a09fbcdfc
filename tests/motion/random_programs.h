// Random programs of every kind of path, and how far a point lies from what was programmed.
//
// Programs are lists of blocks that begin where the axes stand.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/motion/path_fixture.h"

namespace stanok::motion::testing {

struct Program {
  Point start{};
  std::vector<PathBlock> blocks;

  [[nodiscard]] const Point& end() const { return blocks.empty() ? start : blocks.back().end; }
  void add(PathBlock block) {
    block.tag.block = blocks.size() + 1;
    blocks.push_back(block);
  }
};

// Legs with turns of any size: blends, stops, overlaps. Also rapid legs.
inline Program corners(Random& random, const Point& start) {
  Program program{.start = start, .blocks = {}};
  double heading = random.between(-3.0, 3.0);
  const int count = static_cast<int>(random.between(10.0, 40.0));
  for (int n = 0; n < count; ++n) {
    const double length = std::pow(10.0, random.between(-1.0, 1.3));
    heading += random.between(-2.9, 2.9) * random.between(0.0, 1.0);
    Point end = program.end();
    end[0] += length * std::cos(heading);
    end[1] += length * std::sin(heading);
    if (random.chance(0.3)) end[2] += length * random.between(-0.5, 0.5);
    PathBlock block = line_to(end, random.between(5.0, 200.0));
    block.rapid = random.chance(0.1);
    program.add(block);
  }
  return program;
}

// Arcs and helices between lines, tangent or not.
inline Program arcs(Random& random, const Point& start) {
  Program program{.start = start, .blocks = {}};
  double heading = random.between(-3.0, 3.0);
  const int count = static_cast<int>(random.between(8.0, 24.0));
  for (int n = 0; n < count; ++n) {
    if (random.chance(0.3)) heading += random.between(-1.0, 1.0);
    const double size = std::pow(10.0, random.between(-0.7, 1.2));
    const double feed = random.between(10.0, 150.0);
    const Point at = program.end();
    Point end = at;
    if (random.chance(0.3)) {
      end[0] += size * std::cos(heading);
      end[1] += size * std::sin(heading);
      program.add(line_to(end, feed));
      continue;
    }
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double sweep = side * random.between(0.2, 3.5);
    if (random.chance(0.3)) end[2] += size * random.between(-1.0, 1.0);
    program.add(arc_to(
        at, {at[0] - side * size * std::sin(heading), at[1] + side * size * std::cos(heading)},
        sweep, end, feed));
    heading += sweep;
  }
  return program;
}

// The cubic Bezier curve through four points of the plane XY as a polynomial block.
inline PathBlock bezier_to(const std::array<std::array<double, 2>, 4>& points, Point end,
                           double feed) {
  for (std::size_t c = 0; c < 2; ++c) end[c] = points[3][c];
  PathBlock block = line_to(end, feed);
  block.kind = BlockKind::curve;
  for (std::size_t c = 0; c < 2; ++c) {
    const double p0 = points[0][c];
    const double p1 = points[1][c];
    const double p2 = points[2][c];
    const double p3 = points[3][c];
    block.curve[c] = {p0, 3.0 * (p1 - p0), 3.0 * (p2 - 2.0 * p1 + p0),
                      p3 - 3.0 * p2 + 3.0 * p1 - p0};
  }
  return block;
}

// Splines as curved blocks, tangent to each other; now and then a corner.
inline Program splines(Random& random, const Point& start) {
  Program program{.start = start, .blocks = {}};
  double heading = random.between(-3.0, 3.0);
  const int count = static_cast<int>(random.between(6.0, 20.0));
  for (int n = 0; n < count; ++n) {
    if (random.chance(0.2)) heading += random.between(-1.5, 1.5);
    const Point at = program.end();
    const double size = std::pow(10.0, random.between(0.0, 1.4));
    const double turn = random.between(-1.2, 1.2);
    const double chord = heading + 0.5 * turn;
    const std::array<double, 2> p3{at[0] + size * std::cos(chord), at[1] + size * std::sin(chord)};
    const double leave = size * random.between(0.25, 0.4);
    const double arrive = size * random.between(0.25, 0.4);
    const std::array<double, 2> p1{at[0] + leave * std::cos(heading),
                                   at[1] + leave * std::sin(heading)};
    heading += turn;
    const std::array<double, 2> p2{p3[0] - arrive * std::cos(heading),
                                   p3[1] - arrive * std::sin(heading)};
    Point end = at;
    if (random.chance(0.3)) end[2] += size * random.between(-0.3, 0.3);
    program.add(bezier_to({{{at[0], at[1]}, p1, p2, p3}}, end, random.between(10.0, 150.0)));
  }
  return program;
}

struct WindingWay {
  int blocks = 100;
  double length_max = 0.6;  // of a block, mm
  std::size_t axis_count = 3;
};

// Short blocks along a winding path; now and then a corner.
inline Program winding_way(Random& random, const Point& start, const WindingWay& way) {
  Program program{.start = start, .blocks = {}};
  double heading = random.between(-3.0, 3.0);
  double bend = 0.0;
  std::array<double, 2> rates{};  // of the rotary axes, deg/mm
  for (int n = 0; n < way.blocks; ++n) {
    const double length = random.between(0.1 * way.length_max, way.length_max);
    if (n % 25 == 0) {
      bend = random.between(-0.3, 0.3);
      for (double& rate : rates) rate = random.between(-1.0, 1.0);
    }
    heading += bend * length + random.between(-0.01, 0.01);
    if (random.chance(0.02)) heading += random.between(-2.5, 2.5);
    Point end = program.end();
    end[0] += length * std::cos(heading);
    end[1] += length * std::sin(heading);
    end[2] = start[2] + 2.0 * std::sin(0.1 * n);
    for (std::size_t k = 3; k < way.axis_count; ++k) end[k] += length * rates[k - 3];
    program.add(line_to(end, random.between(10.0, 120.0)));
  }
  return program;
}

// Straight moves and single arcs in five axes, long and short ones, some of rotary axes alone.
inline Program five_axis_moves(Random& random, const Point& start) {
  if (random.chance(0.5)) {
    return winding_way(random, start,
                       {.blocks = static_cast<int>(random.between(80.0, 250.0)), .axis_count = 5});
  }
  Program program{.start = start, .blocks = {}};
  const int count = static_cast<int>(random.between(8.0, 25.0));
  for (int n = 0; n < count; ++n) {
    const double length = std::pow(10.0, random.between(-0.5, 1.3));
    Point end = program.end();
    for (std::size_t k = 3; k < 5; ++k) end[k] += 0.5 * length * random.between(-1.0, 1.0);
    if (random.chance(0.1)) {
      program.add(line_to(end, random.between(2.0, 40.0)));
      continue;
    }
    const double heading = random.between(-3.0, 3.0);
    if (random.chance(0.3)) {
      // Drawn one by one: compilers call for arguments in any order.
      const double sweep = random.between(0.3, 2.0);
      const double feed = random.between(5.0, 100.0);
      program.add(arc_to(program.end(),
                         {program.end()[0] - length * std::sin(heading),
                          program.end()[1] + length * std::cos(heading)},
                         sweep, end, feed));
      continue;
    }
    end[0] += length * std::cos(heading);
    end[1] += length * std::sin(heading);
    end[2] += 0.3 * length * random.between(-1.0, 1.0);
    program.add(line_to(end, random.between(5.0, 100.0)));
  }
  return program;
}

// How far a point is from a place of the course, as a part of the tolerance allowed: the tip by
// distance, every rotary axis by itself.
inline double misfit_at(const Course& course, double u, const Point& p, const Tolerance& allowed) {
  const Point q = course.at(u);
  double worst = xyz_norm(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / allowed.mm;
  for (std::size_t k = 3; k < axes_max; ++k)
    worst = std::max(worst, std::abs(p[k] - q[k]) / allowed.deg);
  return worst;
}

// The least of it over the block: a scan, then golden section about the best place.
inline double misfit(const Course& course, const Point& p, const Tolerance& allowed) {
  constexpr double golden = 0.381966011250105;
  const int steps = course.block->kind == BlockKind::line ? 1 : 24;
  int best = 0;
  double least = misfit_at(course, 0.0, p, allowed);
  for (int n = 1; n <= steps; ++n) {
    const double here = misfit_at(course, static_cast<double>(n) / steps, p, allowed);
    if (here < least) best = n;
    least = std::min(least, here);
  }
  double low = std::max(0.0, static_cast<double>(best - 1) / steps);
  double high = std::min(1.0, static_cast<double>(best + 1) / steps);
  for (int n = 0; n < 75 && least > 1.0; ++n) {
    const double a = low + golden * (high - low);
    const double b = high - golden * (high - low);
    const double at_a = misfit_at(course, a, p, allowed);
    const double at_b = misfit_at(course, b, p, allowed);
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
    least = std::min({least, at_a, at_b});
  }
  return least;
}

// The same over the blocks around block number `block`, as far as needed to find one that fits.
inline double misfit(const Program& program, std::uint64_t block, const Point& p,
                     const Tolerance& allowed) {
  constexpr std::size_t around = 8;
  double least = unlimited;
  for (std::size_t away = 0; away <= 2 * around && least > 1.0; ++away) {
    const std::size_t step = (away + 1) / 2;
    const std::size_t index = away % 2 == 0 ? block - 1 + step : block - 1 - step;
    if (index >= program.blocks.size()) continue;  // also before the first one: wraps around
    const Point& start = index == 0 ? program.start : program.blocks[index - 1].end;
    least = std::min(least, misfit({.start = start, .block = &program.blocks[index]}, p, allowed));
  }
  return least;
}

}  // namespace stanok::motion::testing

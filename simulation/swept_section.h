// What a tool sweeps on a straight way without turning, and where a straight line runs through it.
//
// The body is convex, and so is what it sweeps: a line meets it in one interval. For a segment of
// the profile (tool_solid.h) the places x on the line and s on the way that belong to it are
// bounded by one conic and the straight lines of its two end faces and of both ends of the way. The
// interval ends where one of these curves has its outermost x: at an end of the way, where the line
// touches the swept flank (∂Q/∂s = 0), or on the rim of an end face. Lengths mm.
#pragma once

#include <optional>
#include <vector>

#include "simulation/quadratic_stretch.h"
#include "simulation/tool_solid.h"

namespace stanok::simulation {

class SweptSection {
 public:
  // From `place` along `way`, seen along one axis of K. A way of length 0 is the body where it is.
  SweptSection(const Body& body, const ToolPlace& place, const Vector& way, int axis);

  // As in BodySection.
  [[nodiscard]] bool meet(double first, double second, double& from, double& to) const;
  [[nodiscard]] bool row(double second, double& first_from, double& first_to) const;

 private:
  // Q(x, s) = A x² + 2 (B + D s) x + C + 2 E s + F s² <= 0 within a segment; A, D and F are the
  // same for all lines.
  struct Cut {
    ProfileSegment segment;
    double k = 0.0;  // 1 + c2
    double A = 0.0;
    double D = 0.0;
    double F = 0.0;
  };
  // Of one line.
  struct Line {
    double a0 = 0.0;  // height of its point nearest to the tip, over the tip
    double B = 0.0;
    double C = 0.0;
    double E = 0.0;
  };
  struct Hull;

  void bound_across();
  void add_flank(const Cut& cut, const Line& line, Hull& hull) const;
  void add_rim(const Cut& cut, const Line& line, double height, Hull& hull) const;

  BodySection begin_;
  std::optional<BodySection> end_;  // where there is a way
  std::vector<Cut> cuts_;
  Vector tip_;   // axes turned so that the line runs along X
  Vector axis_;  // of the tool
  Vector way_;   // unit vector
  double length_ = 0.0;
  double way_along_axis_ = 0.0;
  // Across line and way: lines beyond these places miss everything.
  double across_y_ = 0.0;
  double across_z_ = 0.0;
  double across_low_ = -infinite;
  double across_high_ = infinite;
  double radius_ = 0.0;
  double bottom_ = 0.0;
  double top_ = 0.0;
};

}  // namespace stanok::simulation

// A rotating tool as convex solids of revolution, and where a straight line runs through them.
//
// Every segment of a profile is ρ² <= c0 + c1 a + c2 a² between two heights a over the tip: a
// cylinder (c0), a cone (a square), a sphere about a point of the axis (c2 = -1). Along a line the
// height goes evenly and the distance from the axis as a square root, so that a line meets each
// segment in the roots of one quadratic. The rounded corner of a bull-nose cutter, a part of a
// torus, is a chain of cones. Lengths mm.
#pragma once

#include <vector>

#include "simulation/material.h"
#include "simulation/tool_shape.h"

namespace stanok::simulation {

enum class Part : std::uint8_t { cutting, shank, holder };

struct ProfileSegment {
  double from = 0.0;  // height over the tip
  double to = 0.0;
  double c0 = 0.0;
  double c1 = 0.0;
  double c2 = 0.0;

  [[nodiscard]] double radius_at(double height) const;
  [[nodiscard]] double sphere_radius() const;  // c2 = -1
};

// Convex: a line meets it in one interval. Without segments where nothing is left of it (shrunk).
struct Body {
  Part part = Part::cutting;
  std::vector<ProfileSegment> segments;  // ascending

  [[nodiscard]] double bottom() const { return segments.front().from; }
  [[nodiscard]] double top() const { return segments.back().to; }
};

// Where a tool is in K: its tip, and the unit vector from there to the spindle.
struct ToolPlace {
  Vector tip = Vector::Zero();
  Vector axis = Vector::UnitZ();

  [[nodiscard]] Vector at(double height) const { return tip + height * axis; }
};

struct ToolSolid {
  std::vector<Body> bodies;
  double radius = 0.0;       // of the cutting part, at most
  double edge_radius = 0.0;  // of the rounding between face and flank; 0: sharp
};

// `shrunk`: every face set back by so much, for what must not touch. `deviation`: how far a chain
// of cones may leave the rounding that it stands for. The shape has no defect.
[[nodiscard]] ToolSolid solid_of(const ToolShape& tool, double deviation, double shrunk = 0.0);

// A probe with every face set out by so much: wherever the probe itself goes within that distance,
// it stays inside.
[[nodiscard]] ToolSolid widened_probe(const ToolSolid& probe, double by);

// An upright disc, such as a tool setter has it: the middle of its upper face, mm.
struct Disc {
  Vector top = Vector::Zero();
  double radius = 0.0;
  double height = 0.0;
};

// False, too, where the tool does not stand along Z.
[[nodiscard]] bool touches(const ToolSolid& tool, const ToolPlace& place, const Disc& disc);

[[nodiscard]] Bounds bounds_of(const Body& body, const ToolPlace& place);
// At its widest place.
[[nodiscard]] double radius_of(const Body& body);

// The lines along one axis of K through a body that stands somewhere; what all of them share is
// computed once.
class BodySection {
 public:
  BodySection(const Body& body, const ToolPlace& place, int axis);

  // Where the line through these coordinates (of the axes behind `axis`, in cyclic order) is
  // inside; false when it is nowhere.
  [[nodiscard]] bool meet(double first, double second, double& from, double& to) const;

  // The lines of one row that may be inside: those whose first coordinate is between the two.
  [[nodiscard]] bool row(double second, double& first_from, double& first_to) const;

 private:
  // A segment of the profile, with what a line along the axis makes of it.
  struct Cut {
    ProfileSegment segment;
    double k = 0.0;  // 1 + c2
    double A = 0.0;  // of the square of the way
    double inverse_A = 0.0;
  };

  std::vector<Cut> cuts_;
  Vector tip_;  // axes turned so that the line runs along X
  Vector axis_;
  double inverse_slope_ = 0.0;  // of the height along the line; 0: it stays the same
  double radius_ = 0.0;         // of the body, at most
  double bottom_ = 0.0;
  double top_ = 0.0;
};

}  // namespace stanok::simulation

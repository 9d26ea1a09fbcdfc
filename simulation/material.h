// The material that is left of a blank, as three families of rays along X, Y and Z (tri-dexel).
//
// Each family holds the whole part; together they see every face from a direction that is not flat
// on it. Frame K and units: blank.h.
#pragma once

#include <optional>

#include "simulation/blank.h"
#include "simulation/cut_marks.h"
#include "simulation/ray_family.h"

namespace stanok::simulation {

// A box along the axes of K.
struct Bounds {
  Vector low = Vector::Zero();
  Vector high = Vector::Zero();

  [[nodiscard]] bool meets(const Bounds& other) const {
    return (low.array() < other.high.array()).all() && (high.array() > other.low.array()).all();
  }
};

// Rays of one family that run through a box: indices [from, to) along the two other axes.
struct RayWindow {
  int first_from = 0;
  int first_to = 0;
  int second_from = 0;
  int second_to = 0;
};

class Material {
 public:
  Material(const Blank& blank, const Grid& grid);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] RayFamily& family(int axis) { return families_[axis]; }
  // Takes away what lies between two places of a ray; returns its length.
  double subtract(int axis, std::size_t ray, double from, double to);
  // From now on it is noted where which tool cuts.
  void mark_cuts() { marks_.emplace(grid_); }
  // nullptr: it is not noted.
  [[nodiscard]] CutMarks* marks() { return marks_ ? &*marks_ : nullptr; }
  [[nodiscard]] const CutMarks* marks() const { return marks_ ? &*marks_ : nullptr; }
  [[nodiscard]] const RayFamily& family(int axis) const { return families_[axis]; }
  // The number of a ray along `axis` with these indices along the axes behind it, in cyclic order.
  [[nodiscard]] std::size_t ray(int axis, int first, int second) const {
    return grid_.across(axis).place(first, second);
  }
  [[nodiscard]] RayWindow window(int axis, const Bounds& bounds) const;
  [[nodiscard]] Bounds bounds() const;

  // What one mm on a ray of the family stands for, mm².
  [[nodiscard]] double section(int axis) const {
    return grid_.cell[(axis + 1) % 3] * grid_.cell[(axis + 2) % 3];
  }
  // By the mean of the three families, mm³.
  [[nodiscard]] double volume() const;

 private:
  Grid grid_;
  PerAxis<RayFamily> families_;
  std::optional<CutMarks> marks_;
};

}  // namespace stanok::simulation

// CutMarks: which tool has made the surface where, and which parts of it have changed since when.
//
// The cubes of the surface (surface_mesh.h) fall into bricks, each with the number of the version
// in which it changed last, so that who shows a workpiece that is being cut asks for what is new
// only. The number of the tool stands in the cell in which a cut ended. Beside the rays, for those
// who want it: a simulation that writes files does without.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/blank.h"

namespace stanok::simulation {

// Cubes [from, to) along each axis; cube i lies between the points i and i + 1 of the grid, and
// point -1 and the last one are outside of the blank.
struct CubeWindow {
  PerAxis<int> from{};
  PerAxis<int> to{};
};

class CutMarks {
 public:
  static constexpr int brick_cells = 32;  // along each axis

  explicit CutMarks(const Grid& grid);

  // What is taken away from now on is taken by this tool.
  void set_tool(int number);
  // Material was taken away between two places of a ray.
  void note(int axis, std::size_t ray, double from, double to);

  [[nodiscard]] std::size_t bricks() const { return changed_.size(); }
  [[nodiscard]] CubeWindow cubes_of(std::size_t brick) const;
  // The version in which the brick changed last, from 1.
  [[nodiscard]] std::uint32_t changed(std::size_t brick) const { return changed_[brick]; }
  // The version of all that was changed so far; what changes from now on has a later one.
  [[nodiscard]] std::uint32_t close_version() { return version_++; }

  // The tool that cut last in a cell; 0: none did.
  [[nodiscard]] int tool_at(const PerAxis<int>& cell) const;

 private:
  [[nodiscard]] std::size_t brick_at(const PerAxis<int>& place) const;
  void mark(const PerAxis<int>& cell);

  Grid grid_;
  PerAxis<int> count_{};  // bricks along X, Y, Z
  std::vector<std::uint32_t> changed_;
  std::uint32_t version_ = 1;
  std::vector<std::vector<std::uint8_t>> tools_in_;  // by brick, then by cell; empty: no cut there
  std::vector<int> tools_{0};                        // by the number in a cell
  std::uint8_t tool_ = 0;
};

}  // namespace stanok::simulation

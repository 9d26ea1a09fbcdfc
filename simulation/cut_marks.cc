#include "simulation/cut_marks.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"

namespace stanok::simulation {
namespace {

constexpr std::size_t tools_max = 255;  // further ones share the last number

int whole(double value) {
  return static_cast<int>(std::floor(std::clamp(value, -1e9, 1e9)));
}

}  // namespace

// One cube more than cells: those at the ends reach out of the blank.
CutMarks::CutMarks(const Grid& grid) : grid_(grid) {
  for (int axis = 0; axis < 3; ++axis) count_[axis] = grid.count[axis] / brick_cells + 1;
  changed_.assign(checked_size(count_[0]) * checked_size(count_[1]) * checked_size(count_[2]),
                  version_);
  tools_in_.resize(changed_.size());
}

void CutMarks::set_tool(int number) {
  auto at = std::ranges::find(tools_, number);
  if (at == tools_.end()) {
    if (tools_.size() < tools_max) tools_.push_back(number);
    at = tools_.end() - 1;
  }
  tool_ = static_cast<std::uint8_t>(at - tools_.begin());
}

std::size_t CutMarks::brick_at(const PerAxis<int>& place) const {
  const Raster layer{count_[0], count_[1]};
  return layer.cells() * checked_size(place[2] / brick_cells) +
         layer.place(place[0] / brick_cells, place[1] / brick_cells);
}

CubeWindow CutMarks::cubes_of(std::size_t brick) const {
  const Raster layer{count_[0], count_[1]};
  const auto in_layer = brick % layer.cells();
  const PerAxis<int> place{{static_cast<int>(in_layer) % count_[0],
                            static_cast<int>(in_layer) / count_[0],
                            static_cast<int>(brick / layer.cells())}};
  CubeWindow window;
  for (int axis = 0; axis < 3; ++axis) {
    window.from[axis] = place[axis] * brick_cells - 1;
    window.to[axis] = std::min(window.from[axis] + brick_cells, grid_.count[axis]);
  }
  return window;
}

// A point of the grid is a corner of the cubes before and behind it; along the ray the cubes from
// the one in which the stretch begins to the one in which it ends are concerned. Cube i is the
// (i + 1)th.
void CutMarks::note(int axis, std::size_t ray, double from, double to) {
  const Raster across = grid_.across(axis);
  PerAxis<int> point{};
  point[axis + 1] = static_cast<int>(ray) % across.columns;
  point[axis + 2] = static_cast<int>(ray) / across.columns;
  const auto cells_to = [&](double position) {
    return (position - grid_.origin[axis]) / grid_.cell[axis];
  };
  PerAxis<int> low = point;
  PerAxis<int> high = point;
  for (int beside = 1; beside < 3; ++beside) ++high[axis + beside];
  low[axis] = std::clamp(whole(cells_to(from) - 0.5) + 1, 0, grid_.count[axis]);
  high[axis] = std::clamp(whole(cells_to(to) - 0.5) + 1, 0, grid_.count[axis]);
  const auto step = [&](int value) { return value - value % brick_cells + brick_cells; };
  PerAxis<int> at{};
  for (at[2] = low[2]; at[2] <= high[2]; at[2] = step(at[2])) {
    for (at[1] = low[1]; at[1] <= high[1]; at[1] = step(at[1])) {
      for (at[0] = low[0]; at[0] <= high[0]; at[0] = step(at[0])) changed_[brick_at(at)] = version_;
    }
  }
  for (const double end : {from, to}) {
    point[axis] = std::clamp(whole(cells_to(end)), 0, grid_.count[axis] - 1);
    mark(point);
  }
}

void CutMarks::mark(const PerAxis<int>& cell) {
  auto& tools = tools_in_[brick_at(cell)];
  if (tools.empty()) tools.assign(checked_size(brick_cells * brick_cells * brick_cells), 0);
  const Raster layer{brick_cells, brick_cells};
  tools[layer.cells() * checked_size(cell[2] % brick_cells) +
        layer.place(cell[0] % brick_cells, cell[1] % brick_cells)] = tool_;
}

int CutMarks::tool_at(const PerAxis<int>& cell) const {
  const auto& tools = tools_in_[brick_at(cell)];
  if (tools.empty()) return 0;
  const Raster layer{brick_cells, brick_cells};
  return tools_[tools[layer.cells() * checked_size(cell[2] % brick_cells) +
                      layer.place(cell[0] % brick_cells, cell[1] % brick_cells)]];
}

}  // namespace stanok::simulation

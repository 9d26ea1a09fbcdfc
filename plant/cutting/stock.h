// Stock: the turned workpiece in the plane of its axis, as cells along Z with the radius that is
// left, and what a tool at a point of that plane takes away.
//
// The tool is the corner of a right-hand turning tool: it clears all material to the right of it
// (greater z) and outside of it (greater x). Along Z the depth of cut is what stands above the tool
// in its cell, along X what is left of material to its right. x is a radius; mm, frame of the
// program. Allocates in its constructor only.
#pragma once

#include <vector>

#include "base/rt_safe.h"
#include "config/files/machine_file.h"

namespace stanok::plant {

class Stock {
 public:
  // The last section reaches on for half a metre.
  explicit Stock(const std::vector<config::StockSection>& sections);

  struct Cut {
    double depth_mm = 0.0;  // 0: in the air
    double hardness_hb = 0.0;
  };
  // The tool goes straight from where it was to this point. The first call sets it there.
  Cut move_tool(double x_mm, double z_mm) RT_SAFE;

 private:
  struct Cell {
    double radius_mm = 0.0;
    double hardness_hb = 0.0;
  };
  [[nodiscard]] std::size_t cell_at(double z_mm) const RT_SAFE;
  // The length along Z of material right of the tool and outside of x, and clears it.
  double clear(std::size_t first, std::size_t end, double x_mm) RT_SAFE;

  double face_mm_ = 0.0;
  std::vector<Cell> cells_;
  std::size_t first_ = 0;  // cells before hold nothing
  double x_mm_ = 0.0;
  double z_mm_ = 0.0;
  bool is_placed_ = false;
};

}  // namespace stanok::plant

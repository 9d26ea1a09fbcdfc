#include "plant/cutting/stock.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"

namespace stanok::plant {
namespace {

constexpr double cell_mm = 0.05;
constexpr double last_section_mm = 500.0;
constexpr double nothing_left_mm = 0.01;

}  // namespace

Stock::Stock(const std::vector<config::StockSection>& sections) {
  if (sections.empty()) return;
  face_mm_ = sections.front().z_mm;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const bool is_last = k + 1 == sections.size();
    const double end =
        is_last ? face_mm_ - sections[k].z_mm + last_section_mm : face_mm_ - sections[k + 1].z_mm;
    cells_.resize(checked_size(std::lround(end / cell_mm)),
                  {.radius_mm = sections[k].radius_mm, .hardness_hb = sections[k].hardness_hb});
  }
}

// Right of the face: 0; the last one goes on for ever.
std::size_t Stock::cell_at(double z_mm) const RT_SAFE {
  const double place = (face_mm_ - z_mm) / cell_mm;
  if (place <= 0.0) return 0;
  return std::min(place_of(place), cells_.size() - 1);
}

double Stock::clear(std::size_t first, std::size_t end, double x_mm) RT_SAFE {
  const double radius = std::max(x_mm, 0.0);
  std::size_t cleared = 0;
  for (std::size_t k = std::max(first, first_); k < end; ++k) {
    if (cells_[k].radius_mm <= radius) continue;
    cells_[k].radius_mm = radius;
    ++cleared;
  }
  while (first_ < end && cells_[first_].radius_mm <= nothing_left_mm) ++first_;
  return cell_mm * static_cast<double>(cleared);
}

Stock::Cut Stock::move_tool(double x_mm, double z_mm) RT_SAFE {
  if (cells_.empty()) return {};
  const double dx = is_placed_ ? x_mm - x_mm_ : 0.0;
  const double dz = is_placed_ ? z_mm - z_mm_ : 0.0;
  x_mm_ = x_mm;
  z_mm_ = z_mm;
  is_placed_ = true;
  if (z_mm >= face_mm_) return {};
  const std::size_t here = cell_at(z_mm);
  const std::size_t before = cell_at(z_mm - dz);
  const double way = std::hypot(dx, dz);
  const double above = cells_[here].radius_mm - x_mm;
  Cut cut{.depth_mm = 0.0, .hardness_hb = cells_[here].hardness_hb};
  if (way <= 0.0) return cut;
  if (dz < 0.0 && above > 0.0) cut.depth_mm += above * -dz / way;
  const bool goes_in = dx < 0.0;
  const double beside = clear(goes_in ? 0 : std::min(before, here), here, x_mm);
  if (goes_in) cut.depth_mm += beside * -dx / way;
  return cut;
}

}  // namespace stanok::plant

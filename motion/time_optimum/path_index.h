// PathIndex: which of the segments of a path is at a place.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/path/path.h"

namespace stanok::motion {

class PathIndex {
 public:
  void reset(std::span<const Segment> segments);

  // Where segment k begins; where the last one ends for k = count.
  [[nodiscard]] double start(std::size_t k) const { return starts_[k]; }
  // The segment in which `s` is, or that begins there.
  [[nodiscard]] std::size_t at(double s) const;
  // The segment in which `s` is, or that ends there.
  [[nodiscard]] std::size_t before(double s) const;

 private:
  std::vector<double> starts_;
};

}  // namespace stanok::motion

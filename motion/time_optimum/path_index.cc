#include "motion/time_optimum/path_index.h"

namespace stanok::motion {
namespace {

// The last of the starts of which `lies_behind` is true, or the first; the end of the path is none.
template <class LiesBehind>
std::size_t last_start(const std::vector<double>& starts, const LiesBehind& lies_behind) {
  std::size_t low = 0;
  std::size_t high = starts.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (lies_behind(starts[middle]) ? low : high) = middle;
  }
  return low;
}

}  // namespace

void PathIndex::reset(std::span<const Segment> segments) {
  starts_.assign(1, 0.0);
  for (const Segment& segment : segments) starts_.push_back(starts_.back() + segment.length);
}

std::size_t PathIndex::at(double s) const {
  return last_start(starts_, [s](double start) { return start <= s; });
}

std::size_t PathIndex::before(double s) const {
  return last_start(starts_, [s](double start) { return start < s; });
}

}  // namespace stanok::motion

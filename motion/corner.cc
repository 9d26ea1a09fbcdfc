// Judging a join by the tangents and curvatures that meet there (motion/corner.h).
#include "motion/corner.h"

#include <cmath>

#include "motion/geometry.h"

namespace stanok::motion {
namespace {

// Rounding of programmed coordinates in tangents and curvatures, relative.
constexpr double continuous_within = 1e-9;
// Sharper turns than 165 deg leave a blend no room: stopping is faster.
constexpr double cosine_min = -0.96592582628906831;

bool continues(double before, double after) {
  return std::abs(after - before) <= continuous_within * (1.0 + std::abs(before));
}

}  // namespace

Join judge_join(const Piece& incoming, const Piece& outgoing) {
  const PathMetric& metric = incoming.geometry.metric;
  if (metric != outgoing.geometry.metric || incoming.transform != outgoing.transform) {
    return Join::turn;
  }
  JetPoint before;
  JetPoint after;
  evaluate_at_parameter(incoming, 1.0, before);
  evaluate_at_parameter(outgoing, 0.0, after);
  double cosine = 0.0;
  bool smooth = true;
  for (std::size_t k = 0; k < static_cast<std::size_t>(metric.axis_count); ++k) {
    if (metric.counts(k)) cosine += before[k].first * after[k].first;
    smooth = smooth && continues(before[k].first, after[k].first) &&
             continues(before[k].second, after[k].second);
  }
  if (smooth) return Join::smooth;
  return cosine < cosine_min ? Join::turn : Join::corner;
}

}  // namespace stanok::motion

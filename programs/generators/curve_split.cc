#include "programs/generators/curve_split.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stanok::programs {
namespace {

constexpr int samples = 2000;  // a chord of 0.05 mm on the longest row

using Vector = std::array<double, 3>;

Vector between(const Point& a, const Point& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

double norm(const Vector& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// Of the circle through three points: 2 sin(angle between the chords) / |p2 - p0|.
double curvature(const Point& p0, const Point& p1, const Point& p2) {
  const Vector a = between(p0, p1);
  const Vector b = between(p1, p2);
  const Vector cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
  return 2.0 * norm(cross) / (norm(a) * norm(b) * norm(between(p0, p2)));
}

}  // namespace

CurveSplit::CurveSplit(const Curve& curve, double from, double to, const Spacing& spacing)
    : from_(from), to_(to), cumulative_{0.0} {
  std::vector<Point> points;
  points.reserve(samples + 1);
  for (int i = 0; i <= samples; ++i) points.push_back(curve(from + (to - from) * i / samples));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::size_t middle = std::clamp<std::size_t>(i, 1, points.size() - 2);
    const double kappa = curvature(points[middle - 1], points[middle], points[middle + 1]);
    const double chord =
        std::clamp(std::sqrt(8.0 * spacing.chord_error_mm / std::max(kappa, 1e-12)),
                   spacing.chord_min_mm, spacing.chord_max_mm);
    cumulative_.push_back(cumulative_.back() + norm(between(points[i - 1], points[i])) / chord);
  }
}

std::vector<double> CurveSplit::ends(int count) const {
  std::vector<double> parameters;
  std::size_t i = 1;
  for (int k = 1; k <= count; ++k) {
    const double wanted = chords_wanted() * k / count;
    while (i + 1 < cumulative_.size() && cumulative_[i] < wanted) ++i;
    const double part = (wanted - cumulative_[i - 1]) / (cumulative_[i] - cumulative_[i - 1]);
    parameters.push_back(from_ + (to_ - from_) * (static_cast<double>(i - 1) + part) / samples);
  }
  if (count > 0) parameters.back() = to_;
  return parameters;
}

std::vector<int> shares(const std::vector<double>& weights, int total) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<int> result;
  double running = 0.0;
  int given = 0;
  for (const double weight : weights) {
    running += weight;
    const int up_to = static_cast<int>(std::lround(total * running / sum));
    result.push_back(up_to - given);
    given = up_to;
  }
  return result;
}

}  // namespace stanok::programs

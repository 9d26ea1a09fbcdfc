#include "process/identify/least_squares.h"

#include <cmath>
#include <numeric>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr int rounds_of_fit = 60;
constexpr double difference = 1e-4;  // of the scale of a parameter
constexpr double gain_least = 1e-9;  // of the sum of squares, that is worth another round

double product(const std::vector<double>& one, const std::vector<double>& other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

double sum_of_squares(const std::vector<double>& residuals) {
  double sum = 0.0;
  for (const double value : residuals) sum += value * value;
  return sum;
}

// Columns of J, of the scaled parameters.
std::vector<std::vector<double>> scaled_slopes(
    const Parameters& values, const Parameters& scale,
    const std::function<std::vector<double>(const Parameters&)>& of) {
  std::vector<std::vector<double>> slopes;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    Parameters above = values;
    Parameters below = values;
    above[k] += difference * scale[k];
    below[k] -= difference * scale[k];
    std::vector<double> slope = of(above);
    const std::vector<double> low = of(below);
    for (std::size_t n = 0; n < slope.size(); ++n)
      slope[n] = (slope[n] - low[n]) / (2.0 * difference);
    slopes.push_back(std::move(slope));
  }
  return slopes;
}

// J^T J and J^T r of the scaled parameters.
struct Normal {
  Covariance matrix;
  Parameters gradient;
};

Normal normal_equations(const std::vector<std::vector<double>>& slopes,
                        const std::vector<double>& residuals) {
  const std::ptrdiff_t count = std::ssize(slopes);
  Normal normal{.matrix = Covariance::Zero(count, count), .gradient = Parameters::Zero(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::vector<double>& row = slopes[checked_size(i)];
    normal.gradient[i] = product(row, residuals);
    for (Eigen::Index j = 0; j <= i; ++j)
      normal.matrix(i, j) = normal.matrix(j, i) = product(row, slopes[checked_size(j)]);
  }
  return normal;
}

}  // namespace

LeastSquares fit_least_squares(
    const Parameters& begin, const Parameters& scale,
    const std::function<std::vector<double>(const Parameters&)>& residuals) {
  LeastSquares fit{.values = begin};
  std::vector<double> now = residuals(fit.values);
  double sum = sum_of_squares(now);
  double damping = 1e-3;
  Normal normal = normal_equations(scaled_slopes(fit.values, scale, residuals), now);
  for (int round = 0; round < rounds_of_fit; ++round) {
    Covariance damped = normal.matrix;
    damped.diagonal() *= 1.0 + damping;
    const Parameters step = -damped.ldlt().solve(normal.gradient);
    const Parameters tried = fit.values + step.cwiseProduct(scale);
    std::vector<double> next = residuals(tried);
    const double next_sum = sum_of_squares(next);
    if (!(next_sum < sum)) {
      constexpr double damping_max = 1e9;
      damping *= 8.0;
      if (damping > damping_max) break;
      continue;
    }
    const bool is_settled = sum - next_sum < gain_least * sum;
    fit.values = tried;
    now = std::move(next);
    sum = next_sum;
    damping *= 0.2;
    if (is_settled) break;
    normal = normal_equations(scaled_slopes(fit.values, scale, residuals), now);
  }
  fit.slopes = scaled_slopes(fit.values, scale, residuals);
  normal = normal_equations(fit.slopes, now);
  for (std::size_t k = 0; k < fit.slopes.size(); ++k)
    for (double& slope : fit.slopes[k]) slope /= scale[static_cast<Eigen::Index>(k)];
  const double freedom =
      std::max(1.0, static_cast<double>(now.size()) - static_cast<double>(begin.size()));
  const auto solver = normal.matrix.ldlt();
  const Parameters pivots = solver.vectorD();
  constexpr double pivot_least = 1e-12;
  fit.is_determined = pivots.minCoeff() > pivot_least * pivots.maxCoeff();
  if (fit.is_determined) {
    const Covariance inverse = solver.solve(Covariance::Identity(begin.size(), begin.size()));
    fit.covariance = sum / freedom * scale.asDiagonal() * inverse * scale.asDiagonal();
  }
  fit.rms = std::sqrt(sum / freedom);
  fit.rest = std::move(now);
  return fit;
}

}  // namespace stanok::process

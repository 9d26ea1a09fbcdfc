// Non-linear least squares of a few parameters, with what the data leave open about them.
//
// Levenberg's and Marquardt's method (SIAM J. Appl. Math. 11 (1963) 431) with differences for the
// derivatives. Covariance: s^2 (J^T J)^-1 with s^2 the sum of squares over its degrees of freedom.
// Off line.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

namespace stanok::process {

inline constexpr int parameters_max = 6;
using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, parameters_max, 1>;
using Covariance =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, parameters_max, parameters_max>;

struct LeastSquares {
  Parameters values{};
  Covariance covariance{};
  double rms = 0.0;                           // of the residuals
  std::vector<double> rest{};                 // the residuals
  std::vector<std::vector<double>> slopes{};  // of them, by parameter
  bool is_determined = false;                 // false: the data leave a parameter open
};

// `residuals`: of the parameters, always as many. `scale`: how far a parameter has to move to
// matter, > 0 each.
[[nodiscard]] LeastSquares fit_least_squares(
    const Parameters& begin, const Parameters& scale,
    const std::function<std::vector<double>(const Parameters&)>& residuals);

}  // namespace stanok::process

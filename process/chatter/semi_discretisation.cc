#include "process/chatter/semi_discretisation.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr int axes = 2;
constexpr int states_max = 2 * VibrationMode::count_max;
constexpr int size_max = states_max + axes;
constexpr int dimensions = 60;  // of the space in which eigenvalues are looked for

// Memory of their own, of a size known when compiled: Eigen may not take any here.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, size_max, size_max>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, size_max, 1>;
using Projected = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, dimensions, dimensions>;
using State = std::vector<double>;

constexpr int steps_min = 60;  // of a tooth period
constexpr int steps_max = 400;
constexpr double steps_per_wave = 50;  // of the highest mode

// The modes as x' = A x + B (f_x, f_y), q = C x; x holds displacement and velocity of each.
struct ModalSystem {
  Matrix A;
  Matrix B;
  Matrix C;
};

ModalSystem modal_system(const CuttingProcess& process) {
  const auto count = static_cast<Eigen::Index>(process.modes_x.size() + process.modes_y.size());
  ModalSystem system{Matrix::Zero(2 * count, 2 * count), Matrix::Zero(2 * count, axes),
                     Matrix::Zero(axes, 2 * count)};
  Eigen::Index k = 0;
  for (const auto& [modes, axis] :
       {std::pair(&process.modes_x, 0), std::pair(&process.modes_y, 1)}) {
    for (const VibrationMode& mode : *modes) {
      const double omega = mode.omega();
      system.A(k, k + 1) = 1.0;
      system.A(k + 1, k) = -omega * omega;
      system.A(k + 1, k + 1) = -2.0 * mode.damping * omega;
      system.B(k + 1, axis) = omega * omega / mode.stiffness_n_per_mm;
      system.C(axis, k) = 1.0;
      k += 2;
    }
  }
  return system;
}

// By scaling and squaring of its series.
Matrix exponential(const Matrix& m) {
  constexpr int terms = 12;
  const double norm = m.cwiseAbs().rowwise().sum().maxCoeff();
  const int halvings =
      std::max(0, static_cast<int>(std::ceil(std::log2(std::max(norm, 1e-300)))) + 2);
  const Matrix scaled = m * std::ldexp(1.0, -halvings);
  Matrix sum = Matrix::Identity(m.rows(), m.cols());
  Matrix term = sum;
  for (int k = 1; k <= terms; ++k) {
    term = term * scaled / k;
    sum += term;
  }
  for (int k = 0; k < halvings; ++k) sum = sum * sum;
  return sum;
}

// Force on (x, y) per depth and displacement, mean over a step of the tooth period.
Eigen::Matrix2d force_matrix(const CuttingProcess& process, double from_part, double to_part) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  if (process.kind == CutKind::turning) {
    sum(0, 0) = process.force_n_per_mm2;
    return sum;
  }
  constexpr int places = 8;
  const double pitch = 2.0 * std::numbers::pi / process.teeth;
  for (int tooth = 0; tooth < process.teeth; ++tooth) {
    for (int k = 0; k < places; ++k) {
      const double part = std::lerp(from_part, to_part, (k + 0.5) / places);
      const double angle = pitch * (tooth + part);
      if (angle < process.entry_rad || angle > process.exit_rad) continue;
      const double s = std::sin(angle);
      const double c = std::cos(angle);
      const double along_x = c + process.radial_ratio * s;
      const double along_y = -s + process.radial_ratio * c;
      Eigen::Matrix2d own;
      own << along_x * s, along_x * c, along_y * s, along_y * c;
      sum += own / places;
    }
  }
  return process.force_n_per_mm2 * sum;
}

int steps_of(const CuttingProcess& process, double period) {
  double highest = 0.0;
  for (const auto* modes : {&process.modes_x, &process.modes_y}) {
    for (const VibrationMode& mode : *modes) highest = std::max(highest, mode.frequency_hz);
  }
  return std::clamp(static_cast<int>(std::ceil(steps_per_wave * highest * period)), steps_min,
                    steps_max);
}

// One tooth period, as a map of the modes' state now and of q at so many steps before.
class PeriodMap {
 public:
  PeriodMap(const CuttingProcess& process, double period, double depth_mm)
      : system_(modal_system(process)), states_(system_.A.rows()) {
    const int steps = steps_of(process, period);
    for (int k = 0; k < steps; ++k) {
      const Eigen::Matrix2d force =
          depth_mm * force_matrix(process, static_cast<double>(k) / steps, (k + 1.0) / steps);
      // Under the force of a constant past: d/dt (x, u) = [[A - B F C, B F], [0, 0]] (x, u).
      Matrix driven = Matrix::Zero(states_ + axes, states_ + axes);
      driven.topLeftCorner(states_, states_) = system_.A - system_.B * force * system_.C;
      driven.topRightCorner(states_, axes) = system_.B * force;
      steps_.push_back(exponential(driven * (period / steps)).topRows(states_));
    }
  }

  [[nodiscard]] std::size_t size() const { return checked_size(states_) + axes * steps_.size(); }

  // `all`: the modes' state, then q of as many steps, the oldest first.
  [[nodiscard]] State of(const State& all) const {
    State next = all;
    Vector driven = Vector::Zero(states_ + axes);
    driven.head(states_) = Eigen::Map<const Eigen::VectorXd>(all.data(), states_);
    const auto past = [&](const State& state, std::size_t step) {
      return Eigen::Map<const Eigen::Vector2d>(state.data() + states_ +
                                               axes * static_cast<Eigen::Index>(step));
    };
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const Eigen::Vector2d now = system_.C * driven.head(states_);
      const Eigen::Vector2d oldest = past(next, k);
      std::ranges::copy(now, next.begin() + states_ + axes * static_cast<Eigen::Index>(k));
      // The past over the step is its mean. What was one step later is next in the list, or the
      // first that was put in.
      const bool is_last = k + 1 == steps_.size();
      const Eigen::Vector2d later = is_last ? past(next, 0) : past(all, k + 1);
      driven.tail(axes) = 0.5 * (oldest + later);
      const Vector moved = steps_[k] * driven;
      driven.head(states_) = moved;
    }
    std::copy_n(driven.data(), states_, next.begin());
    return next;
  }

 private:
  ModalSystem system_;
  Eigen::Index states_;
  std::vector<Matrix> steps_;
};

double dot(const State& one, const State& other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

void add(double factor, const State& state, State& sum) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * state[k];
}

void scale(double factor, State& state) {
  for (double& value : state) value *= factor;
}

// The largest absolute eigenvalue of a map, from the space that its first powers span (W. E.
// Arnoldi, Quart. Appl. Math. 9 (1951) 17).
double spectral_radius(const PeriodMap& map) {
  State first(map.size());
  for (std::size_t k = 0; k < first.size(); ++k)
    first[k] = 1.0 + 0.5 * std::sin(2.4 * static_cast<double>(k));  // near no eigenvector
  scale(1.0 / std::sqrt(dot(first, first)), first);
  std::vector<State> basis{first};
  const auto most = static_cast<Eigen::Index>(std::min<std::size_t>(dimensions, map.size()));
  Projected projected = Projected::Zero(most, most);
  Eigen::Index used = 0;
  for (;;) {
    State next = map.of(basis.back());
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough
      for (Eigen::Index k = 0; k <= used; ++k) {
        const State& along = basis[static_cast<std::size_t>(k)];
        const double part = dot(along, next);
        projected(k, used) += part;
        add(-part, along, next);
      }
    }
    const double rest = std::sqrt(dot(next, next));
    constexpr double nothing = 1e-13;
    if (++used == most || rest < nothing) break;
    projected(used, used - 1) = rest;
    scale(1.0 / rest, next);
    basis.push_back(std::move(next));
  }
  const Projected part = projected.topLeftCorner(used, used);
  const Eigen::EigenSolver<Projected> solver(part, false);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

double SemiDiscretisation::growth(double speed_rev_per_min, double depth_mm) const {
  const int cuts = process_.kind == CutKind::turning ? 1 : process_.teeth;
  return spectral_radius(PeriodMap(process_, 60.0 / (cuts * speed_rev_per_min), depth_mm));
}

double SemiDiscretisation::limit_at(double speed_rev_per_min, double depth_max_mm) const {
  constexpr int places = 24;
  constexpr double exact = 1e-4;  // relative
  double low = 0.0;
  double high = depth_max_mm;
  // The first depth that is not stable: lobes of the period doubling are islands.
  for (int k = 1; k <= places; ++k) {
    const double depth = depth_max_mm * k / places;
    if (growth(speed_rev_per_min, depth) >= 1.0) {
      high = depth;
      break;
    }
    low = depth;
  }
  if (low == depth_max_mm) return depth_max_mm;
  while (high - low > exact * high) {
    const double middle = 0.5 * (low + high);
    (growth(speed_rev_per_min, middle) < 1.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace stanok::process

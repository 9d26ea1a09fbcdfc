#include "process/identify/model_check.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace stanok::process {
namespace {

using Column = std::vector<double>;

// Of chi squared with one degree of freedom: once in a million. What is not quite noise of the
// noise takes some, too.
constexpr double gain_of_noise = 24.0;
constexpr double gain_of_steps = 32.0;  // the greatest of some hundred stretches
// Of the square of a column, that which the slopes have to leave. A stretch that is nearly the
// whole cut says nothing; a law of the force is nearly explained by others.
constexpr double left_of_column = 1e-6;
constexpr double left_of_steps = 0.01;

double product_of(const Column& one, const Column& other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

// What changes of the parameters make of the readings.
class SlopeSpace {
 public:
  explicit SlopeSpace(const std::vector<Column>& slopes) : slopes_(slopes) {
    const std::ptrdiff_t count = std::ssize(slopes);
    Covariance matrix = Covariance::Zero(count, count);
    scale_ = Parameters::Constant(count, 1.0);
    for (Eigen::Index k = 0; k < count; ++k)
      scale_[k] = std::sqrt(std::max(product_of(slope(k), slope(k)), 1e-300));
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        matrix(i, j) = product_of(slope(i), slope(j)) / (scale_[i] * scale_[j]);
    solver_.compute(matrix);
  }

  // The change of the parameters that comes nearest to a column.
  [[nodiscard]] Parameters nearest(const Column& column) const {
    Parameters gradient = Parameters::Zero(scale_.size());
    for (Eigen::Index k = 0; k < scale_.size(); ++k)
      gradient[k] = product_of(slope(k), column) / scale_[k];
    return Parameters(solver_.solve(gradient)).cwiseQuotient(scale_);
  }
  // What that leaves of it.
  [[nodiscard]] Column rest_of(Column column) const {
    const Parameters change = nearest(column);
    for (Eigen::Index k = 0; k < scale_.size(); ++k) {
      const Column& one = slope(k);
      for (std::size_t n = 0; n < column.size(); ++n) column[n] -= change[k] * one[n];
    }
    return column;
  }

 private:
  [[nodiscard]] const Column& slope(Eigen::Index k) const {
    return slopes_[static_cast<std::size_t>(k)];
  }

  const std::vector<Column>& slopes_;
  Parameters scale_;
  Eigen::LDLT<Covariance> solver_;
};

// How much there is of a column, and what it takes from the squares; `square` of what is left of it
// and `product` of that with the rest.
struct ColumnMatch {
  double amount = 0.0;
  double gain = 0.0;
};

ColumnMatch column_match(double product, double square, double square_least, double variance) {
  if (!(square > square_least)) return {};
  return {.amount = product / square, .gain = product * product / square / variance};
}

Column sum_of(const std::vector<Column>& columns, std::size_t from, std::size_t to) {
  Column sum = columns[from];
  for (std::size_t k = from + 1; k < to; ++k)
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += columns[k][n];
  return sum;
}

// Of what the slopes leave of stretches.
struct StretchProducts {
  Column with_rest;
  std::vector<Column> squares;  // of each with each
};

StretchProducts products_of(const std::vector<Column>& left, const Column& rest) {
  StretchProducts products{.with_rest = {},
                           .squares = std::vector<Column>(left.size(), Column(left.size(), 0.0))};
  for (std::size_t i = 0; i < left.size(); ++i) {
    products.with_rest.push_back(product_of(left[i], rest));
    for (std::size_t j = 0; j <= i; ++j)
      products.squares[i][j] = products.squares[j][i] = product_of(left[i], left[j]);
  }
  return products;
}

// Of neighbouring stretches, from the first to before the last, those that take most.
struct StretchMatch {
  std::size_t from = 0;
  std::size_t to = 0;
  ColumnMatch match{};
};

// `whole`: the square of each stretch before the slopes take from it.
StretchMatch best_stretches(const StretchProducts& products, const Column& whole, double variance) {
  StretchMatch best;
  for (std::size_t from = 0; from < whole.size(); ++from) {
    double product = 0.0;
    double square = 0.0;
    double before = 0.0;
    for (std::size_t last = from; last < whole.size(); ++last) {
      product += products.with_rest[last];
      before += whole[last];
      square += products.squares[last][last];
      for (std::size_t k = from; k < last; ++k) square += 2.0 * products.squares[k][last];
      const ColumnMatch match = column_match(product, square, left_of_steps * before, variance);
      if (match.gain > best.match.gain) best = {.from = from, .to = last + 1, .match = match};
    }
  }
  return best;
}

void take_out(const Column& direction, Column& from) {
  const double amount = product_of(direction, from) / product_of(direction, direction);
  for (std::size_t n = 0; n < from.size(); ++n) from[n] -= amount * direction[n];
}

// A part may have several steps: each further stretch is looked for in what those before leave.
ModelLack step_lack(const FitTraces& traces, const SlopeSpace& slopes, const Stretches& stretches) {
  constexpr int stretches_max = 3;
  std::vector<Column> left;
  Column whole;
  for (const Column& column : stretches.columns) {
    left.push_back(slopes.rest_of(column));
    whole.push_back(product_of(column, column));
  }
  Column rest = slopes.rest_of(traces.rest);
  ModelLack lack{.kind = Misfit::steps, .along = stretches.along};
  for (int round = 0; round < stretches_max; ++round) {
    const StretchMatch best = best_stretches(products_of(left, rest), whole, traces.variance);
    if (best.match.gain <= gain_of_steps) break;
    if (round == 0) {
      lack.amount = best.match.amount;
      lack.moved =
          -best.match.amount * slopes.nearest(sum_of(stretches.columns, best.from, best.to));
      lack.from = stretches.begins[best.from];
      lack.to = best.to < whole.size() ? stretches.begins[best.to] : stretches.end;
    }
    lack.gain += best.match.gain - (round > 0 ? gain_of_steps : 0.0);
    const Column direction = sum_of(left, best.from, best.to);
    for (Column& column : left) take_out(direction, column);
    take_out(direction, rest);
  }
  return lack;
}

ModelLack lack_of(const FitTraces& traces, const SlopeSpace& slopes, const Suspect& suspect) {
  const Column left = slopes.rest_of(suspect.column);
  const ColumnMatch match =
      column_match(product_of(left, traces.rest), product_of(left, left),
                   left_of_column * product_of(suspect.column, suspect.column), traces.variance);
  return {.kind = suspect.kind,
          .gain = match.gain,
          .amount = match.amount,
          .moved = -match.amount * slopes.nearest(suspect.column)};
}

}  // namespace

ModelLack strongest_lack(const FitTraces& traces, const std::vector<Suspect>& suspects,
                         const std::vector<Stretches>& stretches) {
  const SlopeSpace slopes(traces.slopes);
  ModelLack strongest;
  double most = 0.0;  // beyond what noise may take
  const auto take = [&](ModelLack&& lack, double of_noise) {
    if (lack.gain - of_noise <= most) return;
    most = lack.gain - of_noise;
    strongest = std::move(lack);
    strongest.rest = std::sqrt(strongest.gain * traces.variance);
  };
  for (const Suspect& suspect : suspects) take(lack_of(traces, slopes, suspect), gain_of_noise);
  // A tool that goes on goes from place to place: time has to tell clearly more than place.
  constexpr double clearly = 1.25;
  for (const Stretches& one : stretches) {
    if (one.columns.size() < 2) continue;
    ModelLack lack = step_lack(traces, slopes, one);
    const bool is_told = strongest.kind == Misfit::steps && lack.gain < clearly * strongest.gain;
    if (!is_told) take(std::move(lack), gain_of_steps);
  }
  return strongest;
}

}  // namespace stanok::process

#include "process/identify/turning_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/place.h"
#include "process/identify/least_squares.h"
#include "process/identify/reading_noise.h"

namespace stanok::process {
namespace {

constexpr double confidence_95 = 1.96;
// Wider than the noise alone would have it: where in a cycle a step of the cut lies is not known.
constexpr double model_reserve = 1.5;

// Speeds that differ by more are two; the idle power has then two terms.
constexpr double speed_differs = 0.05;
constexpr double feed_differs = 0.1;
constexpr int readings_least = 50;

enum Place : Eigen::Index { ln_coefficient, exponent_place, ln_lag, linear, square };

// The way over the last turn at the end of each cycle; ways out of the cut do not count.
std::vector<double> thicknesses(const CutRecord& record) {
  std::vector<double> turns{0.0};
  std::vector<double> ways{0.0};
  std::vector<double> all;
  std::size_t begin = 0;
  for (const CutRow& row : record.rows) {
    turns.push_back(turns.back() + row.rev_per_min / 60.0 * record.cycle_s);
    ways.push_back(ways.back() + (row.depth_mm > 0.0 ? row.travel_mm : 0.0));
    const double since = turns.back() - 1.0;
    while (begin + 2 < turns.size() && turns[begin + 1] <= since) ++begin;
    const double span = turns[begin + 1] - turns[begin];
    const double part = span > 0.0 ? std::clamp((since - turns[begin]) / span, 0.0, 1.0) : 0.0;
    all.push_back(ways.back() - (ways[begin] + part * (ways[begin + 1] - ways[begin])));
  }
  return all;
}

class TurningModel {
 public:
  explicit TurningModel(const CutRecord& record)
      : record_(record), thickness_mm_(thicknesses(record)) {
    constexpr double m_per_mm = 1e-3;
    for (std::size_t k = 0; k < record.rows.size(); ++k) {
      const CutRow& row = record.rows[k];
      const double speed =
          2.0 * std::numbers::pi * row.rev_per_min / 60.0 * row.radius_mm * m_per_mm;
      watts_per_n_.push_back(row.depth_mm * speed);
      if (std::isfinite(row.power_w)) readings_.push_back(k);
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& readings() const { return readings_; }

  // Of the cut, behind the lag, by row.
  [[nodiscard]] std::vector<double> cut_w(const Parameters& p) const {
    const double coefficient = std::exp(p[ln_coefficient]);
    const double part = 1.0 - std::exp(-record_.cycle_s / std::exp(p[ln_lag]));
    std::vector<double> power;
    power.reserve(watts_per_n_.size());
    double lagging = 0.0;
    double wanted_before = 0.0;
    for (std::size_t k = 0; k < watts_per_n_.size(); ++k) {
      const double h = std::max(thickness_mm_[k], 0.0);
      const double wanted = watts_per_n_[k] > 0.0
                                ? coefficient * watts_per_n_[k] * std::pow(h, p[exponent_place])
                                : 0.0;
      // Rows are the ends of cycles: within one the cut goes from one to the next.
      lagging += part * (0.5 * (wanted + wanted_before) - lagging);
      wanted_before = wanted;
      power.push_back(lagging);
    }
    return power;
  }
  [[nodiscard]] double idle_w(const Parameters& p, std::size_t row) const {
    const double n = record_.rows[row].rev_per_min;
    return n * (p[linear] + (p.size() > square ? p[square] * n : 0.0));
  }
  [[nodiscard]] double thickness_mm(std::size_t row) const { return thickness_mm_[row]; }
  [[nodiscard]] bool cuts(std::size_t row) const { return watts_per_n_[row] > 0.0; }

 private:
  const CutRecord& record_;
  std::vector<double> thickness_mm_;
  std::vector<double> watts_per_n_;  // of a force for unit depth, times the depth
  std::vector<std::size_t> readings_;
};

// What must be there before anything is fitted; empty: it is.
std::string what_lacks(const CutRecord& record, const TurningModel& model) {
  std::size_t in_cut = 0;
  std::size_t in_air = 0;
  std::vector<double> thickness_mm;
  for (const std::size_t row : model.readings()) {
    if (record.rows[row].rev_per_min <= 0.0) continue;
    if (!model.cuts(row)) {
      ++in_air;
      continue;
    }
    ++in_cut;
    thickness_mm.push_back(model.thickness_mm(row));
  }
  if (in_cut < readings_least)
    return "there are only " + std::to_string(in_cut) + " readings of the power in the cut";
  if (in_air < readings_least)
    return "there are only " + std::to_string(in_air) +
           " readings of the power of the idling spindle; let it turn before the cut";
  // Without entries and exits, where the chip builds up.
  std::ranges::sort(thickness_mm);
  const double h_min = thickness_mm[thickness_mm.size() / 10];
  const double h_max = thickness_mm[thickness_mm.size() * 9 / 10];
  if (h_max < (1.0 + feed_differs) * h_min)
    return "the cut has one feed only, which does not tell the exponent; change the feed";
  return "";
}

bool has_speeds(const CutRecord& record, const TurningModel& model) {
  double least = 1e12;
  double most = 0.0;
  for (const std::size_t row : model.readings()) {
    const double n = record.rows[row].rev_per_min;
    if (n <= 0.0) continue;
    least = std::min(least, n);
    most = std::max(most, n);
  }
  return most > (1.0 + speed_differs) * least;
}

Parameters begin_of(const CutRecord& record, const TurningModel& model, Eigen::Index count) {
  double idle = 0.0;
  double speed = 0.0;
  for (const std::size_t row : model.readings()) {
    if (model.cuts(row)) continue;
    idle += record.rows[row].power_w;
    speed += record.rows[row].rev_per_min;
  }
  Parameters begin = Parameters::Zero(count);
  constexpr double usual_coefficient_n = 2000.0;
  constexpr double usual_exponent = 0.75;
  constexpr double usual_lag_s = 0.03;
  begin[ln_coefficient] = std::log(usual_coefficient_n);
  begin[exponent_place] = usual_exponent;
  begin[ln_lag] = std::log(usual_lag_s);
  begin[linear] = speed > 0.0 ? idle / speed : 0.1;
  return begin;
}

// Standard deviation of each reading.
std::vector<double> deviations(const CutRecord& record, const TurningModel& model,
                               const Parameters& p, double& part) {
  const std::vector<double> cut = model.cut_w(p);
  std::vector<double> rest_w;
  std::vector<double> cut_w;
  for (const std::size_t row : model.readings()) {
    rest_w.push_back(record.rows[row].power_w - model.idle_w(p, row) - cut[row]);
    cut_w.push_back(cut[row]);
  }
  const ReadingNoise noise = noise_of(rest_w, cut_w);
  part = noise.part;
  std::vector<double> all;
  all.reserve(cut_w.size());
  for (const double watts : cut_w) all.push_back(noise.deviation_w(watts));
  return all;
}

Estimate estimate_of(const LeastSquares& fit, Eigen::Index place) {
  const double half = model_reserve * confidence_95 * std::sqrt(fit.covariance(place, place));
  const double value = fit.values[place];
  return {.value = value, .low = value - half, .high = value + half};
}

// What rounding to whole watts leaves of the idle power, which always is rounded to the same side:
// a variance of 1/12 at each speed.
void add_rounding(const CutRecord& record, const TurningModel& model, LeastSquares& fit) {
  constexpr double variance_w2 = 1.0 / 12.0;
  double slow = 1e12;
  double fast = 0.0;
  for (const std::size_t row : model.readings()) {
    const double n = record.rows[row].rev_per_min;
    if (n <= 0.0) continue;
    slow = std::min(slow, n);
    fast = std::max(fast, n);
  }
  if (fit.values.size() <= square) {
    fit.covariance(linear, linear) += variance_w2 / (fast * fast);
    return;
  }
  const double between = (fast - slow) * (fast - slow);
  const double ratio = fast / slow;
  fit.covariance(linear, linear) += variance_w2 * (ratio * ratio + 1.0 / (ratio * ratio)) / between;
  fit.covariance(square, square) +=
      variance_w2 * (1.0 / (slow * slow) + 1.0 / (fast * fast)) / between;
}

Estimate of_logarithm(const Estimate& ln) {
  return {.value = std::exp(ln.value), .low = std::exp(ln.low), .high = std::exp(ln.high)};
}

}  // namespace

double TurningFit::idle_w(double rev_per_min) const {
  return rev_per_min * (idle_linear.value + (idle_square ? idle_square->value * rev_per_min : 0.0));
}

double TurningFit::coulomb_part(double rev_per_min) const {
  const double idle = idle_w(rev_per_min);
  return idle > 0.0 ? std::clamp(idle_linear.value * rev_per_min / idle, 0.0, 1.0) : 1.0;
}

Expected<TurningFit, std::string> fit_turning(const CutRecord& record) {
  const TurningModel model(record);
  if (std::string lacks = what_lacks(record, model); !lacks.empty())
    return Unexpected<std::string>(std::move(lacks));
  const Eigen::Index count = has_speeds(record, model) ? square + 1 : square;
  Parameters scale = Parameters::Constant(count, 1.0);
  LeastSquares fit{.values = begin_of(record, model, count)};
  scale[linear] = fit.values[linear];
  if (count > square) scale[square] = fit.values[linear] * 1e-3;
  std::vector<double> deviation(model.readings().size(), 1.0);
  TurningFit turning;
  // Weights follow from a fit, and the fit from weights.
  for (int round = 0; round < 4; ++round) {
    const auto residuals = [&](const Parameters& p) {
      const std::vector<double> cut = model.cut_w(p);
      std::vector<double> all;
      all.reserve(deviation.size());
      for (std::size_t k = 0; k < deviation.size(); ++k) {
        const std::size_t row = model.readings()[k];
        all.push_back((record.rows[row].power_w - model.idle_w(p, row) - cut[row]) / deviation[k]);
      }
      return all;
    };
    fit = fit_least_squares(fit.values, scale, residuals);
    deviation = deviations(record, model, fit.values, turning.noise);
  }
  if (!fit.is_determined)
    return Unexpected<std::string>(
        "the record does not tell all values; cut with several depths, feeds and speeds");
  add_rounding(record, model, fit);
  turning.coefficient_n = of_logarithm(estimate_of(fit, ln_coefficient));
  turning.exponent = estimate_of(fit, exponent_place);
  turning.lag_s = of_logarithm(estimate_of(fit, ln_lag));
  turning.idle_linear = estimate_of(fit, linear);
  if (count > square) turning.idle_square = estimate_of(fit, square);
  turning.readings = static_cast<int>(deviation.size());
  turning.fitted_w = model.cut_w(fit.values);
  double sum = 0.0;
  for (std::size_t row = 0; row < turning.fitted_w.size(); ++row)
    turning.fitted_w[row] += model.idle_w(fit.values, row);
  for (const std::size_t row : model.readings()) {
    const double rest = record.rows[row].power_w - turning.fitted_w[row];
    sum += rest * rest;
  }
  turning.residual_w = std::sqrt(sum / turning.readings);
  return turning;
}

}  // namespace stanok::process

#include "process/identify/drive_fit.h"

#include <algorithm>
#include <cmath>

#include "process/identify/least_squares.h"
#include "process/identify/reading_noise.h"

namespace stanok::process {
namespace {

constexpr double confidence_95 = 1.96;
// Wider than the noise alone would have it: where in a cycle a step of the cut lies is not known.
constexpr double model_reserve = 1.5;
// Speeds that differ by more are two; the idle power has then two terms.
constexpr double speed_differs = 0.05;
constexpr int readings_least = 50;
constexpr double noise_max = 0.5;  // of the cutting power; teeth and chips alone make less
constexpr int rounds = 4;          // weights follow from a fit, and the fit from weights

enum Place : Eigen::Index { first, second, ln_lag, linear, square };

struct SpeedRange {
  double slow = 1e12;
  double fast = 0.0;
};

class DriveModel {
 public:
  DriveModel(const DriveRecord& record, const CutModel& cut)
      : record_(record), cut_(cut), readings_(reading_rows(record)) {}

  [[nodiscard]] const std::vector<std::size_t>& readings() const { return readings_; }

  // Of the cut, behind the lag, by row.
  [[nodiscard]] std::vector<double> cut_w(const Parameters& p) const {
    std::vector<double> power(record_.rev_per_min.size(), 0.0);
    cut_.power({p[first], p[second]}, power);
    const double part = 1.0 - std::exp(-record_.cycle_s / std::exp(p[ln_lag]));
    double lagging = 0.0;
    double wanted_before = 0.0;
    for (double& watts : power) {
      // Rows are the ends of cycles: within one the cut goes from one to the next.
      lagging += part * (0.5 * (watts + wanted_before) - lagging);
      wanted_before = watts;
      watts = lagging;
    }
    return power;
  }

  [[nodiscard]] double idle_w(const Parameters& p, std::size_t row) const {
    const double n = record_.rev_per_min[row];
    return n * (p[linear] + (p.size() > square ? p[square] * n : 0.0));
  }

  [[nodiscard]] SpeedRange speeds() const {
    SpeedRange range;
    for (const std::size_t row : readings_) {
      const double n = record_.rev_per_min[row];
      if (n <= 0.0) continue;
      range.slow = std::min(range.slow, n);
      range.fast = std::max(range.fast, n);
    }
    return range;
  }

  // What the readings show beside the model, W.
  [[nodiscard]] std::vector<double> rest_w(const Parameters& p,
                                           const std::vector<double>& cut_w) const {
    std::vector<double> rest;
    rest.reserve(readings_.size());
    for (const std::size_t row : readings_)
      rest.push_back(record_.power_w[row] - idle_w(p, row) - cut_w[row]);
    return rest;
  }

 private:
  const DriveRecord& record_;
  const CutModel& cut_;
  std::vector<std::size_t> readings_;
};

Parameters begin_of(const DriveRecord& record, const DriveModel& model, const CutModel& cut,
                    Eigen::Index count) {
  double idle = 0.0;
  double speed = 0.0;
  for (const std::size_t row : model.readings()) {
    if (record.cuts[row]) continue;
    idle += record.power_w[row];
    speed += record.rev_per_min[row];
  }
  Parameters begin = Parameters::Zero(count);
  constexpr double usual_lag_s = 0.03;
  begin[first] = cut.begin[0];
  begin[second] = cut.begin[1];
  begin[ln_lag] = std::log(usual_lag_s);
  begin[linear] = speed > 0.0 ? idle / speed : 0.1;
  return begin;
}

Parameters scale_of(const Parameters& begin, const CutModel& cut) {
  Parameters scale = Parameters::Constant(begin.size(), 1.0);
  scale[first] = cut.scale[0];
  scale[second] = cut.scale[1];
  scale[linear] = begin[linear];
  if (begin.size() > square) scale[square] = begin[linear] * 1e-3;
  return scale;
}

// Standard deviation of each reading; `part`: of the power of the cut.
std::vector<double> deviations(const DriveModel& model, const Parameters& p, double& part) {
  const std::vector<double> by_row = model.cut_w(p);
  std::vector<double> cut_w;
  for (const std::size_t row : model.readings()) cut_w.push_back(by_row[row]);
  const ReadingNoise noise = noise_of(model.rest_w(p, by_row), cut_w);
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
void add_rounding(const SpeedRange& speeds, LeastSquares& fit) {
  constexpr double variance_w2 = 1.0 / 12.0;
  const auto [slow, fast] = speeds;
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

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

double DriveFit::idle_w(double rev_per_min) const {
  return rev_per_min * (idle_linear.value + (idle_square ? idle_square->value * rev_per_min : 0.0));
}

double DriveFit::coulomb_part(double rev_per_min) const {
  const double idle = idle_w(rev_per_min);
  return idle > 0.0 ? std::clamp(idle_linear.value * rev_per_min / idle, 0.0, 1.0) : 1.0;
}

std::string what_lacks(const DriveRecord& record) {
  int in_cut = 0;
  int in_air = 0;
  for (const std::size_t row : reading_rows(record)) {
    if (record.rev_per_min[row] > 0.0) ++(record.cuts[row] ? in_cut : in_air);
  }
  if (in_cut < readings_least)
    return "there are only " + std::to_string(in_cut) + " readings of the power in the cut";
  if (in_air < readings_least)
    return "there are only " + std::to_string(in_air) +
           " readings of the power of the idling spindle; let it turn before the cut";
  return "";
}

Expected<FittedCut, std::string> fit_drive(const DriveRecord& record, const CutModel& cut) {
  const DriveModel model(record, cut);
  const SpeedRange speeds = model.speeds();
  const bool has_speeds = speeds.fast > (1.0 + speed_differs) * speeds.slow;
  LeastSquares fit{.values = begin_of(record, model, cut, has_speeds ? square + 1 : square)};
  const Parameters scale = scale_of(fit.values, cut);
  std::vector<double> deviation(model.readings().size(), 1.0);
  FittedCut fitted;
  for (int round = 0; round < rounds; ++round) {
    const auto residuals = [&](const Parameters& p) {
      std::vector<double> rest = model.rest_w(p, model.cut_w(p));
      for (std::size_t k = 0; k < rest.size(); ++k) rest[k] /= deviation[k];
      return rest;
    };
    fit = fit_least_squares(fit.values, scale, residuals);
    deviation = deviations(model, fit.values, fitted.drive.noise);
  }
  if (!fit.is_determined)
    return Unexpected<std::string>(
        "the record does not tell all values; cut with several depths, feeds and speeds");
  if (fitted.drive.noise > noise_max) return Unexpected<std::string>(not_of_the_cut);
  add_rounding(speeds, fit);
  fitted.figures = {estimate_of(fit, first), estimate_of(fit, second)};
  DriveFit& drive = fitted.drive;
  const Estimate lag = estimate_of(fit, ln_lag);
  drive.lag_s = {
      .value = std::exp(lag.value), .low = std::exp(lag.low), .high = std::exp(lag.high)};
  drive.idle_linear = estimate_of(fit, linear);
  if (has_speeds) drive.idle_square = estimate_of(fit, square);
  drive.readings = static_cast<int>(deviation.size());
  drive.fitted_w = model.cut_w(fit.values);
  drive.residual_w = rms(model.rest_w(fit.values, drive.fitted_w));
  for (std::size_t row = 0; row < drive.fitted_w.size(); ++row)
    drive.fitted_w[row] += model.idle_w(fit.values, row);
  return fitted;
}

}  // namespace stanok::process

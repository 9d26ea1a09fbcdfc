#include "process/identify/drive_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/identify/coloured_noise.h"
#include "process/identify/drive_check.h"
#include "process/identify/least_squares.h"
#include "process/identify/reading_noise.h"
#include "process/identify/sensor_check.h"

namespace stanok::process {
namespace {

constexpr double confidence_95 = 1.96;
// Wider than the noise alone would have it: how much noise there is and what it remembers is found
// from the same readings.
constexpr double model_reserve = 1.2;
// Speeds that differ by more are two; the idle power has then two terms.
constexpr double speed_differs = 0.05;
constexpr int readings_least = 50;
constexpr double noise_max = 0.5;  // of the cutting power; teeth and chips alone make less
// Of the cutting power: no model of a cut is better, and a power without noise has none to compare
// with.
constexpr double noise_of_model = 0.005;
constexpr double delay_rows_max = 1e4;
constexpr double delay_scale_s = 0.02;
constexpr int rounds = 4;  // weights follow from a fit, and the fit from weights

// `delay`: how old readings are, and lags that are short beside the first.
enum Place : Eigen::Index { first, second, ln_lag, delay, linear, square };

struct SpeedRange {
  double slow = 1e12;
  double fast = 0.0;
};

class DriveModel {
 public:
  DriveModel(const DriveRecord& record, const CutModel& cut)
      : record_(record), cut_(cut), readings_(reading_rows(record)) {}

  [[nodiscard]] const std::vector<std::size_t>& readings() const { return readings_; }

  [[nodiscard]] double cycle_s() const { return record_.cycle_s; }

  // Of the cut, behind the lag, by row.
  [[nodiscard]] std::vector<double> cut_w(const Parameters& p) const {
    std::vector<double> power(record_.rev_per_min.size(), 0.0);
    cut_.power({p[first], p[second]}, power);
    put_lag(power, p);
    put_delay(power, p);
    return power;
  }

  void put_lag(std::vector<double>& power, const Parameters& p) const {
    const double part = 1.0 - std::exp(-record_.cycle_s / std::exp(p[ln_lag]));
    double lagging = 0.0;
    double wanted_before = 0.0;
    for (double& watts : power) {
      // Rows are the ends of cycles: within one the cut goes from one to the next.
      lagging += part * (0.5 * (watts + wanted_before) - lagging);
      wanted_before = watts;
      watts = lagging;
    }
  }

  // Straight between rows.
  void put_delay(std::vector<double>& power, const Parameters& p) const {
    if (power.empty()) return;
    const double rows = std::clamp(p[delay] / record_.cycle_s, -delay_rows_max, delay_rows_max);
    const auto last = static_cast<double>(power.size() - 1);
    const std::vector<double> now = power;
    for (std::size_t row = 0; row < power.size(); ++row) {
      const double at = std::clamp(static_cast<double>(row) - rows, 0.0, last);
      const auto below = static_cast<std::size_t>(at);
      const double above = now[std::min(below + 1, now.size() - 1)];
      power[row] = now[below] + (at - static_cast<double>(below)) * (above - now[below]);
    }
  }

  [[nodiscard]] DrivePowers powers(const Parameters& p) const {
    DrivePowers all{.cut_w = cut_w(p), .lag_w = {}, .law_w = cut_.law_w};
    put_lag(all.law_w, p);
    put_delay(all.law_w, p);
    // What a second lag takes from the power is, to first order in it, (1 - L)^2 of it.
    std::vector<double> once = all.cut_w;
    put_lag(once, p);
    std::vector<double> twice = once;
    put_lag(twice, p);
    for (std::size_t row = 0; row < once.size(); ++row)
      all.lag_w.push_back(all.cut_w[row] - 2.0 * once[row] + twice[row]);
    return all;
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
                    double sampling_s) {
  const SpeedRange speeds = model.speeds();
  const bool has_speeds = speeds.fast > (1.0 + speed_differs) * speeds.slow;
  double idle = 0.0;
  double speed = 0.0;
  for (const std::size_t row : model.readings()) {
    if (record.cuts[row]) continue;
    idle += record.power_w[row];
    speed += record.rev_per_min[row];
  }
  Parameters begin = Parameters::Zero(has_speeds ? square + 1 : square);
  constexpr double usual_lag_s = 0.03;
  begin[first] = cut.begin[0];
  begin[second] = cut.begin[1];
  begin[ln_lag] = std::log(usual_lag_s);
  begin[delay] = 0.5 * sampling_s;
  begin[linear] = speed > 0.0 ? idle / speed : 0.1;
  return begin;
}

Parameters scale_of(const Parameters& begin, const CutModel& cut) {
  Parameters scale = Parameters::Constant(begin.size(), 1.0);
  scale[first] = cut.scale[0];
  scale[second] = cut.scale[1];
  scale[delay] = delay_scale_s;
  scale[linear] = begin[linear];
  if (begin.size() > square) scale[square] = begin[linear] * 1e-3;
  return scale;
}

ReadingNoise noise_at(const DriveModel& model, const Parameters& p,
                      const std::vector<double>& cut_by_row) {
  std::vector<double> cut_w;
  for (const std::size_t row : model.readings()) cut_w.push_back(cut_by_row[row]);
  return noise_of(model.rest_w(p, cut_by_row), cut_w);
}

// Standard deviation of each reading.
std::vector<double> deviations(const DriveModel& model, const std::vector<double>& cut_by_row,
                               const ReadingNoise& noise) {
  std::vector<double> all;
  all.reserve(model.readings().size());
  for (const std::size_t row : model.readings()) all.push_back(noise.deviation_w(cut_by_row[row]));
  return all;
}

// `moved`: how far the value may be off by what the model lacks.
Estimate estimate_of(const LeastSquares& fit, Eigen::Index place, const Parameters& moved) {
  const double half = model_reserve * confidence_95 * std::sqrt(fit.covariance(place, place)) +
                      (place < moved.size() ? std::abs(moved[place]) : 0.0);
  const double value = fit.values[place];
  return {.value = value, .low = value - half, .high = value + half};
}

// All that comes late, together. A reading may be as old as the time from one to the next: then the
// lag is so much shorter. A sensor that filters once in that time is half of it ahead of its lag.
// Where in a cycle a step of the cut lies is not known.
Estimate lag_of(const LeastSquares& fit, double sampling_s, double cycle_s,
                const Parameters& moved) {
  const double lag_s = std::exp(fit.values[ln_lag]);
  const double variance = lag_s * lag_s * fit.covariance(ln_lag, ln_lag) +
                          2.0 * lag_s * fit.covariance(ln_lag, delay) +
                          fit.covariance(delay, delay);
  const double half = 0.5 * cycle_s +
                      model_reserve * confidence_95 * std::sqrt(std::max(0.0, variance)) +
                      (moved.size() > 0 ? std::abs(lag_s * moved[ln_lag] + moved[delay]) : 0.0);
  const double value = std::max(0.0, lag_s + fit.values[delay]);
  return {.value = value,
          .low = std::max(0.0, value - half - sampling_s),
          .high = value + half + 0.5 * sampling_s};
}

// What rounding leaves in the mean of many readings of the same power: a sawtooth over the power,
// which noise of the size of a step and more evens out (its first wave: B. Widrow, I. Kollar,
// Quantization Noise, 2008, ch. 9).
double rounding_variance_w2(double step_w, double noise_w) {
  const double of_step = step_w * step_w / 12.0;
  if (!(step_w > 0.0)) return 0.0;
  constexpr double pi = std::numbers::pi;
  const double of_noise = std::max(0.0, noise_w * noise_w - of_step);
  const double wave = step_w / pi * std::exp(-2.0 * pi * pi * of_noise / (step_w * step_w));
  return std::min(of_step, 0.5 * wave * wave);
}

// Of the idle power, at each speed.
void add_rounding(const SpeedRange& speeds, double variance_w2, LeastSquares& fit) {
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

FitVerdict check_drive_sensor(const DriveRecord& record, const SensorTraits& traits,
                              const CutModel& cut) {
  std::vector<double> usual_w(record.power_w.size(), 0.0);
  cut.power(cut.begin, usual_w);
  return check_sensor(record, traits, usual_w);
}

struct WeightedFit {
  LeastSquares fit;
  ReadingNoise noise{};
  std::optional<ColouredNoise> colour{};
};

WeightedFit fit_with_weights(const DriveRecord& record, const DriveModel& model,
                             const Parameters& begin, const CutModel& cut, double sampling_s) {
  const double age_deviation_s = sampling_s / std::sqrt(12.0);
  const Parameters scale = scale_of(begin, cut);
  WeightedFit weighted{.fit = {.values = begin}};
  for (int round = 0; round < rounds; ++round) {
    const auto residuals = [&](const Parameters& p) {
      std::vector<double> rest = model.rest_w(p, model.cut_w(p));
      if (weighted.colour) rest = weighted.colour->whitened(rest);
      // What is known of the age of readings counts as one more of them.
      rest.push_back((p[delay] - 0.5 * sampling_s) / age_deviation_s);
      return rest;
    };
    weighted.fit = fit_least_squares(weighted.fit.values, scale, residuals);
    if (round + 1 == rounds) break;
    const Parameters& p = weighted.fit.values;
    const std::vector<double> cut_w = model.cut_w(p);
    weighted.noise = noise_at(model, p, cut_w);
    weighted.noise.model = noise_of_model;
    weighted.colour.emplace(record, model.readings(), deviations(model, cut_w, weighted.noise),
                            model.rest_w(p, cut_w), weighted.noise.model_part());
  }
  // No figure is known better than the model is.
  const double variance = weighted.fit.rms * weighted.fit.rms;
  const double least = weighted.noise.model_part();
  if (variance > 0.0 && variance < least) weighted.fit.covariance *= least / variance;
  return weighted;
}

// Without what is known of the age of readings, which comes last.
FitTraces traces_of(const LeastSquares& fit, const ColouredNoise& noise) {
  FitTraces traces{.rest = fit.rest, .slopes = fit.slopes};
  traces.rest.pop_back();
  for (std::vector<double>& slope : traces.slopes) slope.pop_back();
  traces.variance = noise.variance_of_changes(traces.rest);
  return traces;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

DriveFit drive_of(const DriveModel& model, const WeightedFit& weighted, double sampling_s,
                  const Parameters& moved) {
  const LeastSquares& fit = weighted.fit;
  DriveFit drive;
  drive.noise = weighted.noise.part;
  drive.lag_s = lag_of(fit, sampling_s, model.cycle_s(), moved);
  drive.sampling_s = sampling_s;
  drive.idle_linear = estimate_of(fit, linear, moved);
  if (fit.values.size() > square) drive.idle_square = estimate_of(fit, square, moved);
  drive.readings = static_cast<int>(model.readings().size());
  drive.fitted_w = model.cut_w(fit.values);
  drive.residual_w = rms(model.rest_w(fit.values, drive.fitted_w));
  for (std::size_t row = 0; row < drive.fitted_w.size(); ++row)
    drive.fitted_w[row] += model.idle_w(fit.values, row);
  return drive;
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

Expected<FittedCut, std::string> fit_drive(const DriveRecord& given, const CutModel& cut) {
  const DriveRecord record = without_repetitions(given);
  const SensorTraits traits = sensor_traits(given);
  const FitVerdict of_sensor = check_drive_sensor(given, traits, cut);
  const DriveModel model(record, cut);
  const SpeedRange speeds = model.speeds();
  WeightedFit weighted = fit_with_weights(
      record, model, begin_of(record, model, cut, traits.sampling_s), cut, traits.sampling_s);
  if (!weighted.fit.is_determined) {
    return Unexpected<std::string>(
        of_sensor.is_refused()
            ? of_sensor.reason
            : "the record does not tell all values; cut with several depths, feeds and speeds");
  }
  if (weighted.noise.part > noise_max && !of_sensor.is_refused())
    return Unexpected<std::string>(not_of_the_cut);
  const DriveVerdict of_model =
      check_drive(record, model.powers(weighted.fit.values), *weighted.colour,
                  traces_of(weighted.fit, *weighted.colour));
  add_rounding(speeds, rounding_variance_w2(traits.step_w, weighted.noise.idle_w), weighted.fit);
  FittedCut fitted;
  fitted.figures = {estimate_of(weighted.fit, first, of_model.moved),
                    estimate_of(weighted.fit, second, of_model.moved)};
  fitted.drive = drive_of(model, weighted, traits.sampling_s, of_model.moved);
  fitted.drive.verdict = of_sensor.is_refused() ? of_sensor : of_model.verdict;
  return fitted;
}

}  // namespace stanok::process

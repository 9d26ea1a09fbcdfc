#include "process/identify/grinding_fit.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"
#include "process/grinding/elastic_system.h"
#include "process/identify/coloured_noise.h"
#include "process/identify/drive_check.h"
#include "process/identify/least_squares.h"
#include "process/identify/reading_noise.h"
#include "process/identify/sensor_check.h"

namespace stanok::process {
namespace {

constexpr double confidence_of_grinding = 1.96;
constexpr std::size_t grind_readings_least = 50;
constexpr double grind_step_max_s = 0.0005;
constexpr double lag_begin_s = 0.01;
constexpr double lag_scale_s = 0.02;

// As a sensor of that lag shows it at the end of each cycle, the input straight between two of
// them; a lag below 0 shows it ahead.
std::vector<double> as_shown(const std::vector<double>& input, double lag_s, double cycle_s) {
  std::vector<double> shown = input;
  if (lag_s < 0.0) {
    const double cycles = std::min(-lag_s / cycle_s, static_cast<double>(input.size()));
    const auto whole = checked_size(std::floor(cycles));
    const double part = cycles - static_cast<double>(whole);
    for (std::size_t k = 0; k < input.size(); ++k) {
      const double from = input[std::min(k + whole, input.size() - 1)];
      const double to = input[std::min(k + whole + 1, input.size() - 1)];
      shown[k] = from + part * (to - from);
    }
    return shown;
  }
  const double kept = lag_s > 0.0 ? std::exp(-cycle_s / lag_s) : 0.0;
  const double behind = lag_s / cycle_s * (1.0 - kept);
  double input_before = 0.0;  // the record begins in the air
  double shown_before = 0.0;
  for (std::size_t k = 0; k < input.size(); ++k) {
    shown[k] = kept * (shown_before - input_before) + input[k] - behind * (input[k] - input_before);
    input_before = input[k];
    shown_before = shown[k];
  }
  return shown;
}

enum GrindPlace : Eigen::Index { ln_stiffness, ln_factor, alpha, idle, lag, grind_parameters };

class GrindModel {
 public:
  GrindModel(const GrindRecord& record, const GrindingProcess& sheet)
      : record_(record), sheet_(sheet) {
    for (std::size_t k = 0; k < record.rows.size(); ++k)
      if (std::isfinite(record.rows[k].power_w)) readings_.push_back(k);
  }

  [[nodiscard]] const std::vector<std::size_t>& readings() const { return readings_; }

  // Of the cut, as it is shown at the end of each cycle.
  [[nodiscard]] std::vector<double> cut_w(const Parameters& p) const {
    GrindingProcess process = sheet_;
    process.stiffness_n_per_m = std::exp(p[ln_stiffness]);
    process.force_factor = std::exp(p[ln_factor]);
    process.force_exponent = p[alpha];
    const double turn_s = revolution_s(process);
    const auto angles = checked_size(std::ceil(turn_s / grind_step_max_s));
    const double step_s = turn_s / static_cast<double>(angles);
    ElasticSystem system(process, step_s);
    std::vector<double> depth_mm(angles, 0.0);
    std::vector<double> power;
    power.reserve(record_.rows.size());
    std::size_t angle = 0;
    double done_s = 0.0;
    double force_before_n = 0.0;
    for (std::size_t row = 0; row < record_.rows.size(); ++row) {
      const double end_s = static_cast<double>(row + 1) * record_.cycle_s;
      while (done_s + step_s <= end_s) {
        done_s += step_s;
        force_before_n = system.force_n();
        double& depth = depth_mm[angle];
        depth += system.advance(record_.allowance_mm - x_at(done_s) - depth);
        angle = angle + 1 == angles ? 0 : angle + 1;
      }
      const double part = (end_s - done_s) / step_s;
      const double force_n = system.force_n() + part * (system.force_n() - force_before_n);
      power.push_back(record_.watts_per_newton * std::max(0.0, force_n));
    }
    return as_shown(power, p[lag], record_.cycle_s);
  }

 private:
  // X at a time, between the ends of cycles.
  [[nodiscard]] double x_at(double time_s) const {
    const double cycles = time_s / record_.cycle_s - 1.0;
    if (cycles <= 0.0) return record_.rows.front().x_mm;
    const auto before = std::min(checked_size(std::floor(cycles)), record_.rows.size() - 1);
    const std::size_t after = std::min(before + 1, record_.rows.size() - 1);
    const double part = cycles - static_cast<double>(before);
    return record_.rows[before].x_mm +
           part * (record_.rows[after].x_mm - record_.rows[before].x_mm);
  }

  const GrindRecord& record_;
  const GrindingProcess& sheet_;
  std::vector<std::size_t> readings_;
};

Estimate grind_estimate(const LeastSquares& fit, GrindPlace place) {
  const double half = confidence_of_grinding * std::sqrt(fit.covariance(place, place));
  const double value = fit.values[place];
  const bool is_logarithm = place == ln_stiffness || place == ln_factor;
  const auto shown = [&](double number) { return is_logarithm ? std::exp(number) : number; };
  return {.value = shown(value), .low = shown(value - half), .high = shown(value + half)};
}

DriveRecord drive_record_of_plunge(const GrindRecord& record, const std::vector<double>& cut_w) {
  constexpr double is_cut = 0.05;  // of the greatest
  const double most_w = cut_w.empty() ? 0.0 : *std::ranges::max_element(cut_w);
  DriveRecord drive{.cycle_s = record.cycle_s};
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    drive.rev_per_min.push_back(1.0);  // the wheel turns
    drive.power_w.push_back(record.rows[row].power_w);
    drive.cuts.push_back(cut_w[row] > is_cut * most_w);
  }
  return drive;
}

// `deviation`: of the readings, of which the slopes of the fit are multiples.
FitVerdict check_plunge(const GrindRecord& record, const GrindModel& model, const LeastSquares& fit,
                        const std::vector<double>& deviation) {
  DrivePowers powers{.cut_w = model.cut_w(fit.values)};
  const DriveRecord drive = drive_record_of_plunge(record, powers.cut_w);
  FitVerdict of_sensor = check_sensor(drive, sensor_traits(drive), powers.cut_w);
  if (of_sensor.is_refused()) return of_sensor;
  const auto by_reading = [&](const std::vector<double>& multiples) {
    std::vector<double> values = multiples;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= deviation[k];
    return values;
  };
  const std::vector<double> rest_w = by_reading(fit.rest);
  const ColouredNoise noise(drive, model.readings(), deviation, rest_w);
  FitTraces traces{.rest = noise.whitened(rest_w)};
  for (const std::vector<double>& slope : fit.slopes)
    traces.slopes.push_back(noise.whitened(by_reading(slope)));
  traces.variance = noise.variance_of_changes(traces.rest);
  return check_drive(drive, powers, noise, traces).verdict;
}

}  // namespace

Expected<GrindingFit, std::string> fit_grinding(const GrindRecord& record,
                                                const GrindingProcess& sheet) {
  const GrindModel model(record, sheet);
  if (model.readings().size() < grind_readings_least)
    return Unexpected<std::string>("there are only " + std::to_string(model.readings().size()) +
                                   " readings of the power");
  Parameters begin = Parameters::Zero(grind_parameters);
  begin[ln_stiffness] = std::log(sheet.stiffness_n_per_m);
  begin[ln_factor] = std::log(sheet.force_factor);
  begin[alpha] = sheet.force_exponent;
  begin[idle] = record.rows[model.readings().front()].power_w;
  begin[lag] = lag_begin_s;
  Parameters scale = Parameters::Constant(grind_parameters, 1.0);
  scale[lag] = lag_scale_s;
  scale[idle] = std::max(1.0, std::abs(begin[idle]));
  LeastSquares fit{.values = begin};
  std::vector<double> deviation(model.readings().size(), 1.0);
  std::vector<double> deviation_of_fit;
  GrindingFit grinding;
  for (int round = 0; round < 3; ++round) {
    const auto rests = [&](const Parameters& p, const std::vector<double>& cut) {
      std::vector<double> all;
      all.reserve(deviation.size());
      for (const std::size_t row : model.readings())
        all.push_back(record.rows[row].power_w - p[idle] - cut[row]);
      return all;
    };
    fit = fit_least_squares(fit.values, scale, [&](const Parameters& p) {
      std::vector<double> all = rests(p, model.cut_w(p));
      for (std::size_t k = 0; k < all.size(); ++k) all[k] /= deviation[k];
      return all;
    });
    const std::vector<double> cut = model.cut_w(fit.values);
    std::vector<double> cut_of_readings;
    for (const std::size_t row : model.readings()) cut_of_readings.push_back(cut[row]);
    deviation_of_fit = deviation;
    const ReadingNoise noise = noise_of(rests(fit.values, cut), cut_of_readings);
    for (std::size_t k = 0; k < deviation.size(); ++k)
      deviation[k] = noise.deviation_w(cut_of_readings[k]);
    grinding.noise = noise.part;
  }
  if (!fit.is_determined) {
    return Unexpected<std::string>(
        "the cycle does not tell stiffness and force law; record one with two feeds and a "
        "spark-out");
  }
  grinding.verdict = check_plunge(record, model, fit, deviation_of_fit);
  grinding.stiffness_n_per_m = grind_estimate(fit, ln_stiffness);
  grinding.force_factor = grind_estimate(fit, ln_factor);
  grinding.force_exponent = grind_estimate(fit, alpha);
  grinding.idle_w = grind_estimate(fit, idle);
  grinding.lag_s = grind_estimate(fit, lag);
  grinding.fitted_w = model.cut_w(fit.values);
  double sum = 0.0;
  for (double& value : grinding.fitted_w) value += fit.values[idle];
  for (const std::size_t row : model.readings()) {
    const double rest = record.rows[row].power_w - grinding.fitted_w[row];
    sum += rest * rest;
  }
  grinding.residual_w = std::sqrt(sum / static_cast<double>(model.readings().size()));
  return grinding;
}

}  // namespace stanok::process

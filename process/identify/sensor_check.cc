#include "process/identify/sensor_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr double run_least_s = 0.3;
constexpr std::size_t run_least = 8;  // readings

// Readings that follow each other and show the same.
struct Run {
  std::size_t begin = 0;  // of the readings
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

std::vector<Run> runs_of(const DriveRecord& record, const std::vector<std::size_t>& rows) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0 && record.power_w[rows[k]] == record.power_w[rows[k - 1]])
      ++runs.back().end;
    else
      runs.push_back({k, k + 1});
  }
  return runs;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

// From one row with a reading to the next.
std::size_t usual_gap(const std::vector<std::size_t>& rows) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < rows.size(); ++k)
    gaps.push_back(static_cast<double>(rows[k] - rows[k - 1]));
  return std::max<std::size_t>(1, static_cast<std::size_t>(median(std::move(gaps))));
}

// For how many readings the sensor shows the same in the cut.
std::size_t usual_run(const DriveRecord& record, const std::vector<std::size_t>& rows) {
  // A sensor that holds its values has no shorter run; a quiet cut has some long ones.
  constexpr std::ptrdiff_t short_part = 10;
  std::vector<std::size_t> lengths;
  for (const Run& run : runs_of(record, rows))
    if (record.cuts[rows[run.begin]]) lengths.push_back(run.size());
  if (lengths.empty()) return 1;
  const auto place = lengths.begin() + std::ssize(lengths) / short_part;
  std::ranges::nth_element(lengths, place);
  return *place;
}

// The least difference between two readings; 0: too few of them differ.
double step_of(const DriveRecord& record, const std::vector<std::size_t>& rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) values.push_back(record.power_w[row]);
  std::ranges::sort(values);
  constexpr int values_least = 5;
  int different = 1;
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double difference = values[k] - values[k - 1];
    if (difference <= 1e-9 * std::abs(values.back())) continue;
    step = std::min(step, difference);
    ++different;
  }
  return different >= values_least ? step : 0.0;
}

double change_noise(const DriveRecord& record, const std::vector<std::size_t>& rows) {
  constexpr double of_median = 1.4826 / std::numbers::sqrt2;  // a difference has the noise of two
  std::vector<double> changes;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (record.cuts[rows[k]] && record.cuts[rows[k - 1]])
      changes.push_back(std::abs(record.power_w[rows[k]] - record.power_w[rows[k - 1]]));
  }
  return of_median * median(std::move(changes));
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // Whether a power that changes so much shows in a sensor.
  [[nodiscard]] bool changes() const { return high > 1.15 * low + 1.0; }
};

// The idle power at the speed of a row, of the readings outside a run; not a number: there are
// none.
double idle_elsewhere(const DriveRecord& record, const std::vector<std::size_t>& rows,
                      const Run& run) {
  constexpr double same_speed = 0.02;
  const double speed = record.rev_per_min[rows[run.begin]];
  std::vector<double> idle;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool is_inside = k >= run.begin && k < run.end;
    if (is_inside || record.cuts[rows[k]]) continue;
    if (std::abs(record.rev_per_min[rows[k]] - speed) <= same_speed * speed)
      idle.push_back(record.power_w[rows[k]]);
  }
  if (idle.size() < run_least) return std::numeric_limits<double>::quiet_NaN();
  return median(std::move(idle));
}

// A run in which the power has to have changed.
bool is_dead(const DriveRecord& record, const std::vector<std::size_t>& rows, const Run& run,
             const std::vector<double>& cut_w) {
  const double shown = record.power_w[rows[run.begin]];
  Range expected;
  std::size_t in_cut = 0;
  for (std::size_t k = run.begin; k < run.end; ++k) {
    if (record.rev_per_min[rows[k]] <= 0.0) return false;
    expected.take(cut_w[rows[k]]);
    in_cut += record.cuts[rows[k]] ? 1 : 0;
  }
  if (shown <= 0.0) return true;
  // The first readings of a cut still are those of the air, for as long as the lag is.
  const double cut_s = record.cycle_s *
                       static_cast<double>(in_cut * (rows[run.end - 1] - rows[run.begin])) /
                       static_cast<double>(run.size());
  if (in_cut >= run_least && cut_s >= run_least_s) return expected.changes();
  const double idle = idle_elsewhere(record, rows, run);
  constexpr double of_idle = 0.2;
  return in_cut == 0 && std::isfinite(idle) && shown < of_idle * idle;
}

FitVerdict check_alive(const DriveRecord& record, const std::vector<std::size_t>& rows,
                       double most_w, const std::vector<double>& cut_w) {
  double dead_s = 0.0;
  double from_s = 0.0;
  double shown_w = 0.0;
  for (const Run& run : runs_of(record, rows)) {
    const double begin_s = static_cast<double>(rows[run.begin]) * record.cycle_s;
    const double lasts_s = static_cast<double>(rows[run.end - 1]) * record.cycle_s - begin_s;
    if (lasts_s < run_least_s || run.size() < run_least || lasts_s <= dead_s) continue;
    if (record.power_w[rows[run.begin]] >= most_w || !is_dead(record, rows, run, cut_w)) continue;
    dead_s = lasts_s;
    from_s = begin_s;
    shown_w = record.power_w[rows[run.begin]];
  }
  if (!(dead_s > 0.0)) return {};
  return verdict(FitState::refused, Misfit::dead_sensor,
                 "the power stands at " + rounded_text(shown_w, 0) + " W for " +
                     rounded_text(dead_s, 1) + " s from " + rounded_text(from_s, 1) +
                     " s on, while the spindle turns or the cut changes");
}

FitVerdict check_range(const DriveRecord& record, const std::vector<std::size_t>& rows,
                       const SensorTraits& traits, const std::vector<double>& cut_w) {
  constexpr std::size_t at_most_least = 8;
  constexpr double near_part = 0.05;
  double most_w = 0.0;
  for (const std::size_t row : rows) most_w = std::max(most_w, record.power_w[row]);
  std::size_t at_most = 0;
  std::size_t near = 0;
  Range expected;
  for (const std::size_t row : rows) {
    if (record.power_w[row] == most_w) {
      ++at_most;
      if (record.cuts[row]) expected.take(cut_w[row]);
    } else if (record.power_w[row] > (1.0 - near_part) * most_w) {
      ++near;
    }
  }
  if (at_most < at_most_least) return {};
  // Noise alone spreads the readings over all steps of the sensor below the greatest.
  const double step_w = std::max(traits.step_w, 1e-9);
  const double spread = std::max(1.0, std::min(near_part * most_w, 2.0 * traits.noise_w) / step_w);
  const bool piles_up =
      static_cast<double>(at_most) > 3.0 * (1.0 + static_cast<double>(near) / spread);
  const bool has_noise = traits.noise_w > 2.0 * traits.step_w;
  if (!piles_up || (!has_noise && !expected.changes())) return {};
  return verdict(FitState::refused, Misfit::saturated,
                 std::to_string(at_most) + " readings stand at the greatest power, " +
                     rounded_text(most_w, 0) + " W, though the cut differs there");
}

FitVerdict check_resolution(const DriveRecord& record, const std::vector<std::size_t>& rows,
                            const SensorTraits& traits) {
  constexpr double part_of_range = 0.05;
  Range shown;
  for (const std::size_t row : rows) shown.take(record.power_w[row]);
  const double range_w = shown.high - shown.low;
  if (traits.step_w <= traits.noise_w || traits.step_w <= part_of_range * range_w) return {};
  return verdict(FitState::refused, Misfit::coarse,
                 "the power has steps of " + rounded_text(traits.step_w, 0) +
                     " W, and changes by no more than " + rounded_text(range_w, 0) + " W");
}

}  // namespace

std::vector<std::size_t> reading_rows(const DriveRecord& record) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < record.power_w.size(); ++row)
    if (std::isfinite(record.power_w[row])) rows.push_back(row);
  return rows;
}

SensorTraits sensor_traits(const DriveRecord& record) {
  const std::vector<std::size_t> rows = reading_rows(record);
  return {
      .sampling_s = static_cast<double>(usual_gap(rows) * usual_run(record, rows)) * record.cycle_s,
      .step_w = step_of(record, rows),
      .noise_w = change_noise(record, rows)};
}

DriveRecord without_repetitions(const DriveRecord& record) {
  const std::vector<std::size_t> rows = reading_rows(record);
  const std::size_t held = usual_run(record, rows);
  if (held < 2) return record;
  DriveRecord fresh = record;
  for (const Run& run : runs_of(record, rows)) {
    for (std::size_t k = run.begin; k < run.end; ++k)
      if ((k - run.begin) % held != 0)
        fresh.power_w[rows[k]] = std::numeric_limits<double>::quiet_NaN();
  }
  return fresh;
}

FitVerdict check_sensor(const DriveRecord& record, const SensorTraits& traits,
                        const std::vector<double>& cut_w) {
  const std::vector<std::size_t> rows = reading_rows(record);
  double most_w = 0.0;
  for (const std::size_t row : rows) most_w = std::max(most_w, record.power_w[row]);
  if (FitVerdict coarse = check_resolution(record, rows, traits); coarse.is_refused())
    return coarse;
  if (FitVerdict dead = check_alive(record, rows, most_w, cut_w); dead.is_refused()) return dead;
  return check_range(record, rows, traits, cut_w);
}

}  // namespace stanok::process

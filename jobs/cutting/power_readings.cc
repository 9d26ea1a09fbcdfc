#include "jobs/cutting/power_readings.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_input_record.h"

namespace stanok::jobs {
namespace {

// Where the spindle has kept its speed for a while, and turns.
std::vector<bool> steady_rows(const std::vector<double>& rev_per_min, double cycle_s) {
  constexpr double settled_s = 0.5;
  std::vector<bool> steady;
  double speed = 0.0;
  double since_s = 0.0;
  for (const double now : rev_per_min) {
    since_s = now == speed ? since_s + cycle_s : 0.0;
    speed = now;
    steady.push_back(speed > 0.0 && since_s > settled_s);
  }
  return steady;
}

}  // namespace

void PowerReadings::take(const recording::LogEvent& event) {
  if (recording::topic_of(event.channel) != recording::name_of(recording::Topic::input)) return;
  const auto message = recording::decode<input_t>(event.bytes);
  if (!message) return;
  const channels::InputRecord record = recording::from_input(*message);
  const auto* const input = std::get_if<channels::SpindleInput>(&record.content);
  if (input == nullptr || input->spindle != spindle_ ||
      input->quantity != channels::SpindleQuantity::power_w)
    return;
  if (!is_number_of_a_cycle(record.cycle)) return;
  changes_.push_back({.cycle = record.cycle, .power_w = input->value});
}

void PowerReadings::check_any() const {
  if (!changes_.empty()) return;
  throw std::runtime_error("the log has no power of spindle " + std::to_string(spindle_ + 1) +
                           "; its drive has to report it (power_w)");
}

std::vector<double> PowerReadings::given(std::int64_t first, std::size_t cycles) const {
  std::vector<double> power(cycles, std::numeric_limits<double>::quiet_NaN());
  if (!is_number_of_a_cycle(first)) return power;
  const std::int64_t end = first + std::ssize(power);
  const std::int64_t poll = usual_gap();
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    const std::int64_t since = changes_[k].cycle;
    const bool is_held = poll > 0 && k + 1 < changes_.size();
    const std::int64_t until = std::min(is_held ? changes_[k + 1].cycle : since + 1, end);
    if (since >= first && since < end) power[checked_size(since - first)] = changes_[k].power_w;
    if (!is_held) continue;
    // The first poll of the cycles that are asked for.
    const std::int64_t missed = since < first ? (first - since + poll - 1) / poll : 1;
    for (std::int64_t cycle = since + missed * poll; cycle < until; cycle += poll)
      power[checked_size(cycle - first)] = changes_[k].power_w;
  }
  return power;
}

// Between two polls, in cycles; 0: not known, of too few readings.
std::int64_t PowerReadings::usual_gap() const {
  if (changes_.size() < 3) return 0;
  std::vector<std::int64_t> gaps;
  for (std::size_t k = 1; k < changes_.size(); ++k)
    gaps.push_back(changes_[k].cycle - changes_[k - 1].cycle);
  std::ranges::nth_element(gaps, gaps.begin() + std::ssize(gaps) / 2);
  return std::max<std::int64_t>(1, gaps[gaps.size() / 2]);
}

std::vector<double> PowerReadings::by_row(std::int64_t first_cycle,
                                          const std::vector<double>& rev_per_min,
                                          double cycle_s) const {
  const std::vector<bool> is_steady = steady_rows(rev_per_min, cycle_s);
  // What a cycle was given is what the cycle before had made.
  const std::int64_t begin = is_number_of_a_cycle(first_cycle) ? first_cycle + 1 : first_cycle;
  std::vector<double> power = given(begin, rev_per_min.size());
  for (std::size_t row = 0; row < power.size(); ++row)
    if (!is_steady[row]) power[row] = std::numeric_limits<double>::quiet_NaN();
  return power;
}

}  // namespace stanok::jobs

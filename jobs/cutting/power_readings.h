// What the power sensor of a spindle has shown, out of a log.
//
// A log has changes only: between two of them the sensor has shown the first value with each poll.
#pragma once

#include <cstdint>
#include <vector>

#include "recording/log/log_reader.h"

namespace stanok::jobs {

struct PowerReading {
  std::int64_t cycle = 0;  // that was given the value
  double power_w = 0.0;
};

// No machine runs longer than that: other numbers are bytes of a damaged log.
[[nodiscard]] constexpr bool is_number_of_a_cycle(std::int64_t number) {
  return number >= 0 && number <= std::int64_t{1} << 53;
}

class PowerReadings {
 public:
  // `spindle`: of the machine, from 0 on.
  explicit PowerReadings(int spindle) : spindle_(spindle) {}

  void take(const recording::LogEvent& event);
  // Throws std::runtime_error when the sensor has shown nothing at all.
  void check_any() const;
  // What each of so many cycles from `first` on was given, also by polls that showed what the one
  // before had shown; not a number: nothing.
  [[nodiscard]] std::vector<double> given(std::int64_t first, std::size_t cycles) const;
  // The power at the end of each of the cycles from `first_cycle` on, in which the spindle has
  // these speeds; not a number where the sensor showed nothing, and where the spindle has not kept
  // its speed for half a second: a ramp takes power of its own.
  [[nodiscard]] std::vector<double> by_row(std::int64_t first_cycle,
                                           const std::vector<double>& rev_per_min,
                                           double cycle_s) const;

 private:
  [[nodiscard]] std::int64_t usual_gap() const;

  int spindle_;
  std::vector<PowerReading> changes_;
};

}  // namespace stanok::jobs

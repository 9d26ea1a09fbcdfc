// VibrationMeter: amplitude and frequency of the largest line of a vibration that does not belong
// to the turns of the spindle, from 20 to 400 Hz.
//
// Over a sliding block of half a second two kinds of parts are told apart by turns: lines of their
// own frequency, the two largest, by a windowed transform; and the orders of the spindle, by their
// angle. Each is taken from the block before the other is looked for again, until both are what is
// left; so a line is found beside a run-out of twice its height and in spite of what one kind leaks
// into the other. What is not in the band - slow motion of the force, noise above - does not count.
//
// The angle is that of the speed given with the samples. Below six turns a second a block has no
// three turns: nothing is taken for an order then. A piece of the work is done with each call of
// `work`, so that the cycle has it in small ones. Allocates in its constructor only. Source:
// docs/programmer/adaptive-control.md, "Vibration".
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/rt_safe.h"
#include "drives/line_spectrum.h"
#include "drives/spindle_orders.h"

namespace stanok::drives {

struct VibrationLevel {
  double amplitude_um = 0.0;    // of the largest line; 0: there is none
  double frequency_hz = 0.0;    // its
  double synchronous_um = 0.0;  // of the sine of the same power as all orders of the spindle
};

// Of a sensor that does not answer.
inline constexpr VibrationLevel no_vibration_level{
    .amplitude_um = std::numeric_limits<double>::quiet_NaN(),
    .frequency_hz = std::numeric_limits<double>::quiet_NaN()};

class VibrationMeter {
 public:
  explicit VibrationMeter(double rate_hz);

  // The newest samples, oldest first, and the speed of the spindle meanwhile.
  void add(std::span<const double> samples_um, double rev_per_min) RT_SAFE;
  // The next piece of the work on a block; false: nothing is to be done.
  bool work() RT_SAFE;
  // Of the latest block; zeros before the first.
  [[nodiscard]] const VibrationLevel& level() const RT_SAFE { return level_; }

 private:
  enum class Step : std::uint8_t { idle, take, orders, first_line, second_line, first_again };

  void take_block() RT_SAFE;
  void find_orders() RT_SAFE;
  void end_round() RT_SAFE;

  double rate_hz_;
  FrequencyBand band_;
  LineSpectrum spectrum_;
  SpindleOrders orders_;

  // The newest samples and the turns of the spindle at them, as rings.
  std::vector<double> samples_;
  std::vector<double> turns_;
  std::size_t next_ = 0;
  std::size_t fresh_ = 0;  // since the last block was taken
  bool is_full_ = false;
  double turn_ = 0.0;

  struct Work {
    std::vector<double> block;
    std::vector<double> turns;
    std::vector<double> rest;
    std::array<SpectralLine, 2> lines{};
    bool has_orders = false;
    int round = 0;
    double amplitude_before = 0.0;
    Step step = Step::idle;
  };
  Work work_;
  VibrationLevel level_;
};

}  // namespace stanok::drives

#include "drives/vibration_meter.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/place.h"

namespace stanok::drives {
namespace {

// Of self-oscillations of machine tools.
constexpr double from_hz = 20.0;
constexpr double to_hz = 400.0;
constexpr double part_of_rate = 0.45;  // the highest frequency that samples show

// A block is the power of two of samples below this time; each quarter of it is a new one.
constexpr double block_s = 0.6;
constexpr std::size_t blocks_overlap = 4;

constexpr double turns_min = 3.0;
constexpr int rounds_min = 3;
constexpr int rounds_max = 12;
constexpr double rounds_agree = 1e-3;  // of the amplitude

std::size_t samples_of_block(double rate_hz) {
  return std::bit_floor(std::max<std::size_t>(64, checked_size(std::floor(block_s * rate_hz))));
}

}  // namespace

VibrationMeter::VibrationMeter(double rate_hz)
    : rate_hz_(rate_hz),
      band_{.from_hz = from_hz, .to_hz = std::min(to_hz, part_of_rate * rate_hz)},
      spectrum_(rate_hz, samples_of_block(rate_hz)),
      samples_(spectrum_.samples()),
      turns_(spectrum_.samples()) {
  work_.block.resize(spectrum_.samples());
  work_.turns.resize(spectrum_.samples());
  work_.rest.resize(spectrum_.samples());
}

void VibrationMeter::add(std::span<const double> samples_um, double rev_per_min) RT_SAFE {
  constexpr double s_per_min = 60.0;
  const double turns_per_sample =
      std::isfinite(rev_per_min) ? std::abs(rev_per_min) / s_per_min / rate_hz_ : 0.0;
  for (const double sample : samples_um) {
    turn_ += turns_per_sample;
    samples_[next_] = sample;
    turns_[next_] = turn_;
    next_ = next_ + 1 == samples_.size() ? 0 : next_ + 1;
    is_full_ = is_full_ || next_ == 0;
    ++fresh_;
  }
  if (is_full_ && work_.step == Step::idle && fresh_ >= samples_.size() / blocks_overlap) {
    fresh_ = 0;
    work_.step = Step::take;
  }
}

bool VibrationMeter::work() RT_SAFE {
  Work& w = work_;
  switch (w.step) {
    case Step::idle:
      return false;
    case Step::take:
      take_block();
      w.step = w.has_orders ? Step::orders : Step::first_line;
      return true;
    case Step::orders:
      find_orders();
      w.step = Step::first_line;
      return true;
    case Step::first_line:
      std::ranges::copy(w.block, w.rest.begin());
      if (w.has_orders)
        for (std::size_t k = 0; k < w.rest.size(); ++k) w.rest[k] -= orders_.at(w.turns[k]);
      w.lines[0] = spectrum_.largest(w.rest, band_);
      w.step = Step::second_line;
      return true;
    case Step::second_line:
      spectrum_.subtract(w.lines[0], w.rest);
      w.lines[1] = spectrum_.largest(w.rest, band_);
      w.step = Step::first_again;
      return true;
    case Step::first_again: {
      SpectralLine back = w.lines[0];
      back.amplitude = -back.amplitude;
      spectrum_.subtract(back, w.rest);
      spectrum_.subtract(w.lines[1], w.rest);
      w.lines[0] = spectrum_.largest(w.rest, band_);
      end_round();
      return w.step != Step::idle;
    }
  }
  return false;
}

// The oldest first, without their mean.
void VibrationMeter::take_block() RT_SAFE {
  const std::size_t count = samples_.size();
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t from = (next_ + k) % count;
    work_.block[k] = samples_[from];
    work_.turns[k] = turns_[from];
    sum += samples_[from];
  }
  const double mean = sum / static_cast<double>(count);
  for (double& sample : work_.block) sample -= mean;
  work_.has_orders = work_.turns.back() - work_.turns.front() >= turns_min;
  work_.round = 0;
  work_.amplitude_before = 0.0;
  work_.lines = {};
  orders_.clear();
}

// From what neither the lines nor the orders as they are known explain.
void VibrationMeter::find_orders() RT_SAFE {
  Work& w = work_;
  std::ranges::copy(w.block, w.rest.begin());
  for (const SpectralLine& line : w.lines)
    if (line.amplitude > 0.0) spectrum_.subtract(line, w.rest);
  for (std::size_t k = 0; k < w.rest.size(); ++k) w.rest[k] -= orders_.at(w.turns[k]);
  orders_.learn(w.rest, w.turns);
}

void VibrationMeter::end_round() RT_SAFE {
  Work& w = work_;
  ++w.round;
  const double amplitude = std::max(w.lines[0].amplitude, w.lines[1].amplitude);
  const bool agrees = std::abs(amplitude - w.amplitude_before) <= rounds_agree * amplitude;
  w.amplitude_before = amplitude;
  const bool is_done = !w.has_orders || w.round >= rounds_max || (w.round >= rounds_min && agrees);
  if (!is_done) {
    w.step = Step::orders;
    return;
  }
  w.step = Step::idle;
  const SpectralLine& largest =
      w.lines[0].amplitude >= w.lines[1].amplitude ? w.lines[0] : w.lines[1];
  double power = 0.0;
  if (w.has_orders) {
    for (const double turn : w.turns) {
      const double value = orders_.at(turn);
      power += value * value;
    }
  }
  level_ = {.amplitude_um = largest.amplitude,
            .frequency_hz = largest.frequency_hz,
            .synchronous_um = std::sqrt(2.0 * power / static_cast<double>(w.turns.size()))};
}

}  // namespace stanok::drives

#include "drives/line_spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::drives {
namespace {

constexpr double pi = std::numbers::pi;

// Of a line d bins from a bin, what the Hann window leaves of it there; 1 at d = 0.
double hann_part(double d) RT_SAFE {
  constexpr double tiny = 1e-9;
  if (std::abs(d) < tiny) return 1.0;
  return std::sin(pi * d) / (pi * d * (1.0 - d * d));
}

}  // namespace

LineSpectrum::LineSpectrum(double rate_hz, std::size_t samples)
    : rate_hz_(rate_hz),
      transform_(samples / 2, false),
      window_(samples),
      windowed_(samples),
      spectrum_(samples / 2) {
  STANOK_ASSERT(std::has_single_bit(samples) && samples >= 8);
  const auto count = static_cast<double>(samples);
  for (std::size_t k = 0; k < samples; ++k)
    window_[k] = 0.5 - 0.5 * std::cos(2.0 * pi * static_cast<double>(k) / count);
}

// KissFFT has a branch for prime factors other than 2, 3 and 5 that takes memory; a power of two
// never comes there, which a test with a guard against allocations shows (ADR 0026).
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wfunction-effects"
#endif
void LineSpectrum::transform() RT_SAFE {
  transform_.transform_real(windowed_.data(), spectrum_.data());
}
#if defined(__clang__)
#pragma clang diagnostic pop
#endif

SpectralLine LineSpectrum::largest(std::span<const double> block, const FrequencyBand& band)
    RT_SAFE {
  for (std::size_t k = 0; k < window_.size(); ++k) windowed_[k] = window_[k] * block[k];
  transform();
  const auto count = static_cast<double>(window_.size());
  const double bin_hz = rate_hz_ / count;
  const auto power = [&](std::size_t k) RT_SAFE {
    const double real = spectrum_[k].real();
    const double imaginary = spectrum_[k].imag();
    return real * real + imaginary * imaginary;
  };
  const std::size_t first =
      std::max<std::size_t>(2, static_cast<std::size_t>(band.from_hz / bin_hz));
  const std::size_t last =
      std::min(spectrum_.size() - 2, static_cast<std::size_t>(std::ceil(band.to_hz / bin_hz)));
  std::size_t place = 0;
  double most = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    const double here = power(k);
    if (here <= most || here < power(k - 1) || here < power(k + 1)) continue;
    most = here;
    place = k;
  }
  if (place == 0) return {};
  const double below = power(place - 1);
  const double above = power(place + 1);
  const double ratio = std::sqrt(std::max(below, above) / most);
  const double distance = (2.0 * ratio - 1.0) / (ratio + 1.0);
  const double d = above >= below ? distance : -distance;
  const double half_window = 0.25 * count;  // of an amplitude of 1 in the middle of a bin
  const double angle = std::atan2(spectrum_[place].imag(), spectrum_[place].real());
  return {.frequency_hz = (static_cast<double>(place) + d) * bin_hz,
          .amplitude = std::sqrt(most) / (half_window * hann_part(d)),
          .phase = angle - pi * d};
}

// The sine goes on by a rotation from sample to sample.
void LineSpectrum::subtract(const SpectralLine& line, std::span<double> block) const RT_SAFE {
  const double step = 2.0 * pi * line.frequency_hz / rate_hz_;
  const double step_cosine = std::cos(step);
  const double step_sine = std::sin(step);
  double cosine = line.amplitude * std::cos(line.phase);
  double sine = line.amplitude * std::sin(line.phase);
  for (double& sample : block) {
    sample -= cosine;
    const double next = cosine * step_cosine - sine * step_sine;
    sine = sine * step_cosine + cosine * step_sine;
    cosine = next;
  }
}

}  // namespace stanok::drives

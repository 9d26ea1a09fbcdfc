// LineSpectrum: the largest line of a block of samples within a band.
//
// The block under a Hann window is transformed (KissFFT, ADR 0026); between the bins frequency and
// amplitude follow from the two greatest values of the line: with b their ratio, the line lies
// d = (2 b - 1) / (b + 1) bins from the greatest towards the other (Grandke, IEEE Trans. Instrum.
// Meas. 32 (1983) 350). Allocates in its constructor only.
#pragma once

#include <complex>
#include <kissfft/kissfft.hh>
#include <span>
#include <vector>

#include "base/rt_safe.h"

namespace stanok::drives {

struct FrequencyBand {
  double from_hz = 0.0;
  double to_hz = 0.0;
};

// amplitude cos(2 pi frequency t + phase), t from the first sample of the block on.
struct SpectralLine {
  double frequency_hz = 0.0;  // 0: there is none
  double amplitude = 0.0;
  double phase = 0.0;
};

class LineSpectrum {
 public:
  // `samples`: of a block, a power of two: then the transform needs no memory of its own.
  LineSpectrum(double rate_hz, std::size_t samples);

  [[nodiscard]] std::size_t samples() const RT_SAFE { return window_.size(); }
  [[nodiscard]] SpectralLine largest(std::span<const double> block, const FrequencyBand& band)
      RT_SAFE;
  // Takes the line out of the block.
  void subtract(const SpectralLine& line, std::span<double> block) const RT_SAFE;

 private:
  void transform() RT_SAFE;

  double rate_hz_;
  kissfft<double> transform_;
  std::vector<double> window_;
  std::vector<double> windowed_;
  std::vector<std::complex<double>> spectrum_;
};

}  // namespace stanok::drives

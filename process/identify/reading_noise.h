// The noise of readings of a power: of whole watts, and of a part of the cutting power.
#pragma once

#include <vector>

namespace stanok::process {

struct ReadingNoise {
  double idle_w = 0.0;  // standard deviation without a cut
  double part = 0.0;    // of the cutting power, standard deviation
  double model = 0.0;   // of the model, a part of the cutting power

  [[nodiscard]] double deviation_w(double cut_w) const;
  // Of the variance in the cut, that of the model.
  [[nodiscard]] double model_part() const;
};

// From what a model leaves of the readings (`rest_w`) and what it says of the cut (`cut_w`).
[[nodiscard]] ReadingNoise noise_of(const std::vector<double>& rest_w,
                                    const std::vector<double>& cut_w);

}  // namespace stanok::process

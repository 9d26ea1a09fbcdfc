// The noise of readings that follow each other, where one resembles the one before: teeth, run-out
// and filters make it so. Within the cut, noise of its standard deviation with an autocorrelation
// that falls by a factor from reading to reading (an autoregression of first order). Off line.
#pragma once

#include <cstddef>
#include <vector>

#include "process/identify/drive_record.h"

namespace stanok::process {

class ColouredNoise {
 public:
  // `deviation`: of each reading, with that of the model (of which `model_part` of the variance
  // is), which does not remember. `rest`: what a model leaves of each reading. The memory comes
  // from differences, so that steps and drifts that the model does not have are not taken for it.
  ColouredNoise(const DriveRecord& record, const std::vector<std::size_t>& readings,
                const std::vector<double>& deviation, const std::vector<double>& rest,
                double model_part = 0.0);

  // Of one reading on the next one of the cut, 0 to 1.
  [[nodiscard]] double memory() const { return memory_; }
  // Values of readings as multiples of the noise that is new in each of them.
  [[nodiscard]] std::vector<double> whitened(const std::vector<double>& values) const;
  // Of whitened values of the cut, from the changes from one to the next; no less than the model's.
  [[nodiscard]] double variance_of_changes(const std::vector<double>& white) const;

 private:
  std::vector<double> deviation_;
  std::vector<bool> follows_;  // the reading before, in the cut
  double model_part_ = 0.0;
  double memory_ = 0.0;
};

}  // namespace stanok::process

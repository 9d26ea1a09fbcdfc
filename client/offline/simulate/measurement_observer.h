// `simulate --measurements FOLDER`: what the programs measured, as CSV and JSON lines, and what
// they printed.
#pragma once

#include <cstdint>
#include <string>

#include "recording/log/measurement_files.h"
#include "recording/log/printed_file.h"
#include "runtime/simulation.h"

namespace stanok::client {

// Times are those of the machine, from the beginning of the run.
class MeasurementObserver final : public runtime::CycleObserver {
 public:
  MeasurementObserver(const std::string& folder, int cycle_us)
      : cycle_us_(cycle_us), files_(folder, "measurements"), printed_(folder, "printed") {}

  void observe(const channels::CycleOutput& /*output*/) override {}
  void observe(const channels::Event& event) override {
    files_.take(event, event.cycle * cycle_us_);
    printed_.take(event);
    if (!files_.error().empty()) error_ = files_.error();
    if (!printed_.error().empty()) error_ = printed_.error();
  }

  // Why any of it was not written; empty: all was.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  std::int64_t cycle_us_;
  recording::MeasurementFiles files_;
  recording::PrintedFile printed_;
  std::string error_;
};

}  // namespace stanok::client

// MeasurementListener: the measurement report of the daemon, in the folder of its logs.
//
// A listener of the publisher thread. A disk that is full stops nothing: it is told once.
#pragma once

#include <filesystem>
#include <string>

#include "daemon/publish/publisher_thread.h"
#include "recording/log/measurement_files.h"

namespace stanok::daemon {

class MeasurementListener final : public CycleListener {
 public:
  // Files are DIR/MACHINE-measurements.csv and .jsonl.
  MeasurementListener(const std::filesystem::path& directory, const std::string& machine)
      : files_(directory, machine + "-measurements") {}

  void on_event(const channels::Event& event) override;

 private:
  recording::MeasurementFiles files_;
  bool has_told_error_ = false;
};

}  // namespace stanok::daemon

// ReportListener: the reports of the daemon, in the folder of its logs: what programs measure, and
// what they print.
//
// A listener of the publisher thread. A disk that is full stops nothing: each report tells it once.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "daemon/publish/publisher_thread.h"
#include "recording/log/measurement_files.h"
#include "recording/log/printed_file.h"

namespace stanok::daemon {

class ReportListener final : public CycleListener {
 public:
  // Files are DIR/MACHINE-measurements.csv and .jsonl, and DIR/MACHINE-printed.txt.
  ReportListener(const std::filesystem::path& directory, const std::string& machine)
      : measurements_(directory, machine + "-measurements"),
        printed_(directory, machine + "-printed") {}

  void on_event(const channels::Event& event) override;
  // Whom to tell why something is not written. Before the first event.
  void tell_trouble_to(std::function<void(const std::string& why)> told) {
    trouble_ = std::move(told);
  }

 private:
  void tell_once(const char* what, const std::string& fault, bool& has_told) const;

  std::function<void(const std::string&)> trouble_;
  recording::MeasurementFiles measurements_;
  recording::PrintedFile printed_;
  bool has_told_measurements_ = false;
  bool has_told_printed_ = false;
};

}  // namespace stanok::daemon

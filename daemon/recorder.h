// Recorder: the daemon's records on the LCM bus and, when wanted, in a log file.
//
// A listener of the publisher thread. Neither a bus that cannot be opened nor a full disk stops
// anything: both are told once and shown in the status.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include "config/machine_file.h"
#include "daemon/publisher_thread.h"
#include "daemon/running_machine.h"
#include "recording/log_writer.h"
#include "recording/message_stream.h"
#include "recording/publisher.h"

namespace stanok::daemon {

struct RecorderOptions {
  std::optional<std::string> lcm_url;             // nothing: no LCM
  std::optional<std::filesystem::path> log_file;  // nothing: no log
};

class Recorder final : public CycleListener {
 public:
  // Throws std::runtime_error when the log file cannot be made.
  Recorder(const config::MachineFile& file, const std::string& build,
           const RecorderOptions& options);
  ~Recorder() override;

  void on_output(const channels::CycleOutput& output) override;
  void on_program_read(const recording::ProgramRead& read) override {
    stream_->program_read(read, cycle_);
  }
  void on_event(const channels::Event& event) override { stream_->event(event); }
  void on_input(const channels::InputRecord& input) override { stream_->input(input); }

  // Any thread.
  [[nodiscard]] RecordingStatus status() const;
  // From the next output on. Any thread.
  void allow_workpieces(bool allowed) { workpieces_allowed_ = allowed; }

 private:
  void refresh_status();

  std::unique_ptr<recording::Publisher> publisher_;
  std::unique_ptr<recording::LogWriter> log_;
  std::string log_file_;
  std::unique_ptr<recording::MessageStream> stream_;
  std::int64_t cycle_ = 0;       // of the latest output
  std::int64_t refresh_period_;  // cycles
  bool has_told_error_ = false;
  std::atomic<bool> workpieces_allowed_{false};
  mutable std::mutex mutex_;
  RecordingStatus status_;
};

// DIR/NAME-YYYYMMDD-HHMMSS.lcm in UTC.
[[nodiscard]] std::filesystem::path log_file_name(const std::filesystem::path& directory,
                                                  const std::string& machine);

}  // namespace stanok::daemon

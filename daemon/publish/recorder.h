// Recorder: the daemon's records on the LCM bus, in a log file when wanted, and of the last seconds
// in memory, which become a file when a fault stops the machine.
//
// A listener of the publisher thread. Neither a bus that cannot be opened nor a full disk stops
// anything: both are told once and shown in the status.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "config/files/machine_file.h"
#include "daemon/cycle/running_machine.h"
#include "daemon/publish/flight_files.h"
#include "daemon/publish/log_files.h"
#include "daemon/publish/publisher_thread.h"
#include "recording/log/flight_recorder.h"
#include "recording/stream/message_stream.h"
#include "recording/stream/publisher.h"

namespace stanok::daemon {

struct RecorderOptions {
  std::optional<std::string> lcm_url;   // nothing: no LCM
  std::filesystem::path log_directory;  // of logs and of what the flight recorder writes
  bool logs_from_start = false;
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
  void on_event(const channels::Event& event) override;
  void on_input(const channels::InputRecord& input) override { stream_->input(input); }
  void on_change(const channels::InputChange& change) override { stream_->input(change); }

  // Whom to ask for the situations that outputs show. Before the first output.
  void ask_for_situations(recording::MessageStream::Situations situations) {
    stream_->ask_for_situations(std::move(situations));
  }
  // Any thread: start, stop.
  [[nodiscard]] LogFiles& logs() { return logs_; }
  // Any thread.
  [[nodiscard]] RecordingStatus status() const;
  // Any thread. Sent from the next output on.
  void show_path(recording::PathPreview path);
  // From the next output on. Any thread.
  void allow_workpieces(bool allowed) { workpieces_allowed_ = allowed; }

 private:
  void take_new_paths();
  void write_flight();
  void note_flight(const std::filesystem::path& file);
  void open_bus_again();
  void refresh_publisher_status();
  [[nodiscard]] std::int64_t utime() const;

  LogFiles logs_;
  std::int64_t cycle_us_;
  std::unique_ptr<recording::Publisher> publisher_;
  std::unique_ptr<recording::FlightRecorder> flight_;
  std::unique_ptr<recording::MessageStream> stream_;
  std::int64_t cycle_ = 0;             // of the latest output
  std::int64_t refresh_period_;        // cycles
  std::int64_t flight_due_cycle_ = 0;  // 0: nothing has happened
  std::atomic<bool> workpieces_allowed_{false};

  std::atomic<bool> has_new_paths_{false};
  std::mutex paths_mutex_;
  std::vector<recording::PathPreview> new_paths_;
  mutable std::mutex mutex_;                   // of the status
  RecordingStatus status_;                     // but for the log
  std::unique_ptr<FlightFiles> flight_files_;  // last: its thread writes into the status
};

}  // namespace stanok::daemon

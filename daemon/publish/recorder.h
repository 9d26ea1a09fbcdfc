// Recorder: the daemon's records on the LCM bus, in a log file when wanted, and of the last seconds
// in memory, which become a file when a fault stops the machine.
//
// A listener of the publisher thread. Neither a bus that cannot be opened nor a full disk stops
// anything: both are told once and shown in the status. A thread of its own keeps what is written
// within its bounds.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "config/files/machine_file.h"
#include "daemon/cycle/running_machine.h"
#include "daemon/publish/flight_files.h"
#include "daemon/publish/log_files.h"
#include "daemon/publish/log_retention.h"
#include "daemon/publish/publisher_thread.h"
#include "recording/log/flight_recorder.h"
#include "recording/stream/lcm_publisher.h"
#include "recording/stream/message_stream.h"

namespace stanok::daemon {

struct RecorderOptions {
  std::optional<std::string> lcm_url;   // nothing: no LCM
  std::filesystem::path log_directory;  // of logs and of what the flight recorder writes
  bool logs_from_start = false;
  LogDisk disk = disk_of_this_computer();
  std::chrono::milliseconds disk_period = std::chrono::seconds(5);  // between two looks at it
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
  // Whom to tell why something is not recorded, from any thread; also of what was before. Once.
  void tell_trouble_to(LogFiles::Trouble told);
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
  [[nodiscard]] FlightFiles::Calls calls_of_flight();
  void note_trouble(const std::string& why);
  void look_after_disk(const std::stop_token& stop, std::chrono::milliseconds period);
  void note_flight(const std::filesystem::path& file);
  void open_bus_again();
  void refresh_publisher_status();
  [[nodiscard]] std::int64_t utime() const;
  [[nodiscard]] KeptLogsStatus kept_logs() const;

  LogRetention retention_;
  LogFiles logs_;
  std::unique_ptr<recording::LcmPublisher> publisher_;
  std::unique_ptr<recording::FlightRecorder> flight_;
  std::unique_ptr<recording::MessageStream> stream_;
  std::int64_t cycle_ = 0;             // of the latest output
  std::int64_t refresh_period_;        // cycles
  std::int64_t flight_due_cycle_ = 0;  // 0: nothing has happened
  std::atomic<bool> workpieces_allowed_{false};

  struct NewPaths {
    std::atomic<bool> are_there{false};
    std::mutex mutex;
    std::vector<recording::PathPreview> paths;
  };
  NewPaths new_paths_;
  mutable std::mutex mutex_;  // of what stands behind it
  RecordingStatus status_;    // but for the log
  struct Trouble {
    LogFiles::Trouble told;
    std::vector<std::string> untold;
  };
  Trouble trouble_;
  std::unique_ptr<FlightFiles> flight_files_;  // these last: their threads use the members above
  std::jthread disk_thread_;
};

}  // namespace stanok::daemon

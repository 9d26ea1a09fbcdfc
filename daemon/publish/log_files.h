// LogFiles: the log files of the daemon, one after the other: begun and ended by an operator, begun
// anew when their folder was removed, and resting while the disk has no room for them.
//
// What is asked for changes the file with the next cycle, in the publisher's thread; all that does
// not say otherwise belongs to that thread. A full disk stops nothing: it is told once for each log
// and shown in the status, and a new log begins when there is room.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/expected.h"
#include "recording/log/log_switch.h"
#include "recording/log/log_writer.h"

namespace stanok::daemon {

struct LogFileStatus {
  std::string file;  // empty: no log is written
  std::int64_t bytes = 0;
  std::int64_t events = 0;
  std::string error;   // why logging stopped; empty: it did not
  bool rests = false;  // it goes on when there is room; `file` is the one before, if any
};

class LogFiles {
 public:
  // Told from any thread why something is not recorded.
  using Trouble = std::function<void(const std::string& why)>;

  // Files are DIR/NAME-YYYYMMDD-HHMMSS.lcm; one that is larger goes on in a next file.
  LogFiles(std::filesystem::path directory, std::string name, std::int64_t size_max_bytes,
           Trouble trouble);

  // What the messages go into.
  [[nodiscard]] recording::MessageSink& sink() { return log_; }

  // Before the first cycle; it rests while there is no room. Throws std::runtime_error when the
  // file cannot be made.
  void begin(std::int64_t utime);

  // Any thread. Why nothing may be written; empty: there is room. What is being written rests from
  // the next cycle on, and begins anew when there is room; so does, after a while, what the disk
  // did not take.
  void set_room(const std::string& no_room);

  // Any thread. A new log file, which the next cycle begins; nothing: one is being written.
  [[nodiscard]] std::optional<Expected<std::filesystem::path, recording::LogError>> start();
  // Any thread. The log that ends; nothing: there is none.
  [[nodiscard]] std::optional<std::filesystem::path> stop();
  // Any thread.
  [[nodiscard]] LogFileStatus status() const;

  // At the beginning of a cycle: to the file that was asked for since the last one.
  void turn(std::int64_t utime);
  // What was written so far goes to the disk, and its figures into the status.
  void flush();
  // A folder that was removed takes its log along: told, and a new log begins in a new folder.
  void look_after_folder();

 private:
  [[nodiscard]] Expected<std::unique_ptr<recording::LogWriter>, recording::LogError> open(
      const std::filesystem::path& file) const;
  void begin_with_next_cycle(std::unique_ptr<recording::LogWriter> log,
                             const std::filesystem::path& file);
  void rest();
  void go_on();
  void tell_error();

  std::filesystem::path directory_;
  std::string name_;
  std::int64_t size_max_bytes_;
  Trouble trouble_;
  recording::LogSwitch log_;
  bool has_told_error_ = false;
  bool has_told_folder_ = false;

  std::atomic<bool> turns_{false};  // to next_
  mutable std::mutex mutex_;
  std::unique_ptr<recording::LogWriter> next_;
  LogFileStatus status_;
  std::string no_room_;
  std::chrono::steady_clock::time_point failed_at_;
};

}  // namespace stanok::daemon

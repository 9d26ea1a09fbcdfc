// FlightFiles: the files that the flight recorder leaves behind, written by a thread of their own.
//
// A minute of four channels is 160 MB: whoever wrote them in the publisher's thread would keep it
// from the rings of the cycle for longer than these hold, and the next recording would have a gap.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "recording/log/flight_recorder.h"

namespace stanok::daemon {

class FlightFiles {
 public:
  // Files are DIR/NAME-YYYYMMDD-HHMMSS.lcm; the ten newest are kept. `written` is told of each
  // from the thread that writes.
  FlightFiles(std::filesystem::path directory, std::string name,
              std::function<void(const std::filesystem::path&)> written);
  // Writes what was given first.
  ~FlightFiles();
  FlightFiles(const FlightFiles&) = delete;
  FlightFiles& operator=(const FlightFiles&) = delete;

  // Whether all that was given is written. One thread gives.
  [[nodiscard]] bool is_idle();
  // Only when it is idle.
  void write(recording::FlightRecording&& recording);

 private:
  void run(const std::stop_token& stop);
  void write_now(const recording::FlightRecording& recording) const;

  std::filesystem::path directory_;
  std::string name_;
  std::function<void(const std::filesystem::path&)> written_;
  std::mutex mutex_;
  std::condition_variable_any news_;
  std::optional<recording::FlightRecording> next_;  // until it is written
  std::jthread thread_;                             // last: it uses the members above
};

// DIR/NAME-YYYYMMDD-HHMMSS.lcm in UTC; of one that exists the next free one with -2, -3, ...
[[nodiscard]] std::filesystem::path log_file_name(const std::filesystem::path& directory,
                                                  const std::string& name);

}  // namespace stanok::daemon

// FlightFiles: the files that the flight recorder leaves behind, written by a thread of their own.
//
// A minute of four channels is 160 MB: whoever wrote them in the publisher's thread would keep it
// from the rings of the cycle for longer than these hold, and the next recording would have a gap.
#pragma once

#include <condition_variable>
#include <cstdint>
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
  // All are called from the thread that writes.
  struct Calls {
    // Makes room for a file of that size. Why there is none; empty: there is.
    std::function<std::string(std::int64_t bytes)> make_room;
    std::function<void(const std::filesystem::path&)> written;
    std::function<void(const std::string& why)> failed;
  };

  // Files are DIR/NAME-flight-YYYYMMDD-HHMMSS.lcm; the ten newest are kept.
  FlightFiles(std::filesystem::path directory, std::string machine, Calls calls);
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
  void fail(const std::string& why) const;

  std::filesystem::path directory_;
  std::string machine_;
  Calls calls_;
  std::mutex mutex_;
  std::condition_variable_any news_;
  std::optional<recording::FlightRecording> next_;  // until it is written
  std::jthread thread_;                             // last: it uses the members above
};

// DIR/NAME-YYYYMMDD-HHMMSS.lcm in UTC; of one that exists the next free one with -2, -3, ...
[[nodiscard]] std::filesystem::path log_file_name(const std::filesystem::path& directory,
                                                  const std::string& name);

}  // namespace stanok::daemon

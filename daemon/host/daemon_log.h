// DaemonLog: what the daemon says on standard error, written by a thread of its own.
//
// Whoever says something puts the line into a queue of fixed length and goes on: a pipe that nobody
// reads, a terminal that Ctrl-S has stopped or a slow disk makes nobody wait but the thread that
// writes. When the queue is full its oldest lines go; they are counted, and the count is told with
// the next line that gets through. What is said goes through spdlog's default logger; any thread.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <memory>

namespace stanok::daemon {

class DaemonLog {
 public:
  // Becomes spdlog's default logger. The descriptor stays open for ever: a thread that waits for
  // its reader may outlive this object.
  explicit DaemonLog(int descriptor = STDERR_FILENO);
  // Gives the reader a second to take what waits, no more; from then on nothing is written.
  ~DaemonLog();
  DaemonLog(const DaemonLog&) = delete;
  DaemonLog& operator=(const DaemonLog&) = delete;

  static constexpr std::size_t lines_max = 1024;  // that wait

 private:
  struct Writer;
  std::shared_ptr<Writer> writer_;
};

// Lines that were lost so far in this process.
[[nodiscard]] std::size_t log_lines_lost();

}  // namespace stanok::daemon

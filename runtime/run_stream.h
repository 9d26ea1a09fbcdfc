// RunStream: a log, read once by a thread of its own, in parts that may be believed.
//
// What is read before it is asked for is bounded, unless whoever asks for the parts waits for a
// program that stands farther on.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "runtime/recorded_run.h"

namespace stanok::runtime {

class RunStream {
 public:
  // Throws std::runtime_error when the log cannot be read.
  explicit RunStream(const std::filesystem::path& log);
  ~RunStream();
  RunStream(const RunStream&) = delete;
  RunStream& operator=(const RunStream&) = delete;

  // Waits for what the run begins with. Throws std::runtime_error where the log lacks it.
  [[nodiscard]] RunBeginning beginning();
  [[nodiscard]] std::shared_ptr<const RecordedFiles> files() const { return files_; }
  // The next part; nothing at the end, or where what follows cannot be believed.
  [[nodiscard]] std::optional<LogPart> next();
  // Of the whole log: what was not asked for is dropped. Once.
  [[nodiscard]] recording::LogContents contents();

 private:
  void read(const std::stop_token& stop);
  void put(LogPart part, const std::stop_token& stop);
  void end(std::exception_ptr fault);

  recording::LogReader reader_;
  std::shared_ptr<RecordedFiles> files_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<LogPart> parts_;
  bool is_wanted_ = true;  // parts are
  bool is_over_ = false;
  std::exception_ptr fault_;
  recording::LogContents contents_;  // when it is over
  std::jthread thread_;              // last: it uses the members above
};

}  // namespace stanok::runtime

#include "daemon/publish/log_files.h"

#include <spdlog/spdlog.h>

#include <stdexcept>
#include <utility>

#include "daemon/publish/flight_files.h"

namespace stanok::daemon {

namespace fs = std::filesystem;

namespace {

// A disk may say that it has room and take nothing all the same (a quota).
constexpr auto retry_after = std::chrono::minutes(1);

}  // namespace

LogFiles::LogFiles(fs::path directory, std::string name, std::int64_t size_max_bytes,
                   Trouble trouble)
    : directory_(std::move(directory)),
      name_(std::move(name)),
      size_max_bytes_(size_max_bytes),
      trouble_(std::move(trouble)) {}

Expected<std::unique_ptr<recording::LogWriter>, recording::LogError> LogFiles::open(
    const fs::path& file) const {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    return Unexpected<recording::LogError>(
        recording::log_error("cannot create " + file.parent_path().string(), error.value()));
  return recording::LogWriter::open(file, size_max_bytes_);
}

void LogFiles::begin(std::int64_t utime) {
  {
    const std::lock_guard lock(mutex_);
    if (!no_room_.empty()) return rest();
  }
  const fs::path file = log_file_name(directory_, name_);
  auto log = open(file);
  if (!log) throw std::runtime_error(log.error().text);
  log_.turn_to(std::move(*log), utime);
  const std::lock_guard lock(mutex_);
  status_.file = file;
}

// With the mutex.
void LogFiles::begin_with_next_cycle(std::unique_ptr<recording::LogWriter> log,
                                     const fs::path& file) {
  next_ = std::move(log);
  status_.file = file;
  turns_.store(true, std::memory_order_release);
}

std::optional<Expected<fs::path, recording::LogError>> LogFiles::start() {
  const std::lock_guard lock(mutex_);
  if (!status_.file.empty() || status_.rests) return std::nullopt;
  if (!no_room_.empty()) return Unexpected<recording::LogError>({.text = no_room_});
  fs::path file = log_file_name(directory_, name_);
  auto log = open(file);
  if (!log) return Unexpected<recording::LogError>(log.error());
  status_.error.clear();
  begin_with_next_cycle(std::move(*log), file);
  return file;
}

std::optional<fs::path> LogFiles::stop() {
  const std::lock_guard lock(mutex_);
  if (status_.file.empty() && !status_.rests) return std::nullopt;
  fs::path file = status_.file;
  next_.reset();
  status_.rests = false;
  status_.file.clear();
  status_.bytes = 0;
  status_.events = 0;
  turns_.store(true, std::memory_order_release);
  return file;
}

void LogFiles::set_room(const std::string& no_room) {
  const std::lock_guard lock(mutex_);
  no_room_ = no_room;
  if (no_room.empty()) return go_on();
  if (!status_.file.empty() && !status_.rests) rest();
}

// With the mutex.
void LogFiles::rest() {
  next_.reset();
  status_.rests = true;
  status_.error = no_room_;
  turns_.store(true, std::memory_order_release);
  spdlog::error("logging is paused: {}", no_room_);
  trouble_("logging is paused: " + no_room_);
}

// With the mutex.
void LogFiles::go_on() {
  const bool has_failed = !status_.file.empty() && !status_.error.empty() && !turns_ &&
                          std::chrono::steady_clock::now() >= failed_at_ + retry_after;
  if (!status_.rests && !has_failed) return;
  const fs::path file = log_file_name(directory_, name_);
  auto log = open(file);
  failed_at_ = std::chrono::steady_clock::now();
  if (!log) {
    status_.error = log.error().text;
    return;
  }
  status_.rests = false;
  status_.error.clear();
  spdlog::info("logging continues: {}", file.string());
  begin_with_next_cycle(std::move(*log), file);
}

LogFileStatus LogFiles::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void LogFiles::turn(std::int64_t utime) {
  if (!turns_.load(std::memory_order_acquire)) return;
  const std::lock_guard lock(mutex_);
  turns_ = false;
  static_cast<void>(log_.finish());
  tell_error();
  log_.turn_to(std::move(next_), utime);
  has_told_error_ = false;
}

void LogFiles::flush() {
  if (log_.writer() == nullptr) return;
  static_cast<void>(log_.writer()->flush());
  const std::lock_guard lock(mutex_);
  if (turns_ || status_.rests) return;
  const recording::LogStatus& log = log_.writer()->status();
  status_.bytes = log.bytes;
  status_.events = log.events;
  tell_error();
}

void LogFiles::look_after_folder() {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  const fs::path folder = fs::path(status_.file).parent_path();
  if (status_.file.empty() || status_.rests || turns_ || folder.empty()) return;
  if (fs::exists(folder, error) || error) return;
  const fs::path file = log_file_name(folder, name_);
  auto log = open(file);
  if (!log) {
    if (!has_told_folder_) {
      spdlog::error("the folder of the log has disappeared; {}", log.error().text);
      trouble_("the folder of the log has disappeared; " + log.error().text);
    }
    has_told_folder_ = true;
    return;
  }
  spdlog::error("the folder of the log {} has disappeared; a new log begins: {}", status_.file,
                file.string());
  has_told_folder_ = false;
  begin_with_next_cycle(std::move(*log), file);
}

// Once for each log; also of what was still on its way to the disk when the log was ended. With
// the mutex.
void LogFiles::tell_error() {
  if (log_.writer() == nullptr || log_.writer()->flush() || has_told_error_) return;
  status_.error = log_.writer()->status().error->text;
  has_told_error_ = true;
  failed_at_ = std::chrono::steady_clock::now();
  spdlog::error("logging has stopped: {}", status_.error);
  trouble_("logging has stopped: " + status_.error);
}

}  // namespace stanok::daemon

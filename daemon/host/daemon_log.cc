#include "daemon/host/daemon_log.h"

#include <poll.h>
#include <spdlog/async.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/place.h"

namespace stanok::daemon {
namespace {

constexpr auto last_lines_time = std::chrono::seconds(1);
constexpr auto look_period = std::chrono::milliseconds(5);

std::atomic<std::size_t> lines_lost_of_process{0};

// False: the reader has gone, or the disk is full. Waits as long as it takes.
bool write_whole(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count > 0) {
      text.remove_prefix(checked_size(count));
    } else if (count < 0 && errno == EAGAIN) {
      pollfd wanted{.fd = descriptor, .events = POLLOUT, .revents = 0};
      static_cast<void>(::poll(&wanted, 1, -1));
    } else if (count == 0 || errno != EINTR) {
      return false;
    }
  }
  return true;
}

// Belongs to the thread that writes.
class DescriptorSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  DescriptorSink(int descriptor, std::weak_ptr<spdlog::details::thread_pool> queue)
      : descriptor_(descriptor), queue_(std::move(queue)) {}

  [[nodiscard]] bool is_writing() const { return is_writing_; }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    is_writing_ = true;
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    tell_lost(message);
    if (!write_whole(descriptor_, {line.data(), line.size()})) ++lines_lost_of_process;
    is_writing_ = false;
  }
  void flush_() override {}

 private:
  void tell_lost(const spdlog::details::log_msg& next) {
    const auto queue = queue_.lock();
    const std::size_t overrun = queue ? queue->overrun_counter() : overrun_counted_;
    lines_lost_of_process += overrun - overrun_counted_;
    overrun_counted_ = overrun;
    const std::size_t lost = lines_lost_of_process;
    if (lost == lost_told_) return;
    const std::string text = std::to_string(lost - lost_told_) +
                             " lines are missing here because this log was not read in time, " +
                             std::to_string(lost) + " in all";
    spdlog::memory_buf_t line;
    formatter_->format({next.time, {}, next.logger_name, spdlog::level::warn, text}, line);
    if (write_whole(descriptor_, {line.data(), line.size()})) lost_told_ = lost;
  }

  int descriptor_;
  std::weak_ptr<spdlog::details::thread_pool> queue_;
  std::size_t overrun_counted_ = 0;
  std::size_t lost_told_ = 0;
  std::atomic<bool> is_writing_{false};
};

}  // namespace

struct DaemonLog::Writer {
  std::shared_ptr<spdlog::details::thread_pool> queue;
  std::shared_ptr<DescriptorSink> sink;

  [[nodiscard]] bool has_written_all() const {
    return queue->queue_size() == 0 && !sink->is_writing();
  }
};

DaemonLog::DaemonLog(int descriptor) : writer_(std::make_shared<Writer>()) {
  writer_->queue = std::make_shared<spdlog::details::thread_pool>(lines_max, 1U);
  writer_->sink = std::make_shared<DescriptorSink>(descriptor, writer_->queue);
  // What cannot even be queued, for want of memory, is lost; spdlog would write it here and now.
  spdlog::set_error_handler([](const std::string&) { ++lines_lost_of_process; });
  spdlog::set_default_logger(std::make_shared<spdlog::async_logger>(
      "stanokd", writer_->sink, writer_->queue, spdlog::async_overflow_policy::overrun_oldest));
}

DaemonLog::~DaemonLog() {
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("stanokd", std::make_shared<spdlog::sinks::null_sink_mt>()));
  const auto end = std::chrono::steady_clock::now() + last_lines_time;
  // Two looks: between the queue and the sink a line is in neither.
  int looks_without_lines = 0;
  while (looks_without_lines < 2 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(look_period);
    looks_without_lines = writer_->has_written_all() ? looks_without_lines + 1 : 0;
  }
  if (looks_without_lines == 2) return;
  // Its thread cannot be waited for; it ends with the process.
  // Without memory the process ends, as it does.
  // NOLINTNEXTLINE(bugprone-unhandled-exception-at-new)
  static auto* const left_behind = new std::vector<std::shared_ptr<Writer>>();
  left_behind->push_back(writer_);
}

std::size_t log_lines_lost() {
  return lines_lost_of_process;
}

}  // namespace stanok::daemon

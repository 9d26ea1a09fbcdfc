#include "daemon/recorder.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <stdexcept>

#include "protocol/version.h"
#include "runtime/run_setup.h"

namespace stanok::daemon {
namespace {

constexpr std::int64_t refresh_period_us = 200'000;
constexpr std::int64_t bytes_per_mb = 1'000'000;

std::int64_t wall_clock_us() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

std::unique_ptr<recording::LogWriter> open_log(const std::filesystem::path& file, int size_mb) {
  std::filesystem::create_directories(file.parent_path());
  auto log = recording::LogWriter::open(file, size_mb * bytes_per_mb);
  if (!log) throw std::runtime_error(log.error().text);
  return std::move(*log);
}

}  // namespace

Recorder::Recorder(const config::MachineFile& file, const std::string& build,
                   const RecorderOptions& options)
    : refresh_period_(std::max<std::int64_t>(1, refresh_period_us / file.machine.cycle_us)) {
  std::vector<recording::MessageSink*> sinks;
  if (options.lcm_url) {
    publisher_ = std::make_unique<recording::Publisher>(*options.lcm_url);
    if (!publisher_->good()) {
      spdlog::warn("LCM {} cannot be opened; nothing is published", publisher_->status().url);
    }
    sinks.push_back(publisher_.get());
  }
  if (options.log_file) {
    log_ = open_log(*options.log_file, file.recorder.size_mb);
    log_file_ = options.log_file->string();
    sinks.push_back(log_.get());
  }
  auto description = recording::describe(file.machine, std::string(protocol::version), build);
  description.utime_start = wall_clock_us();
  stream_ = std::make_unique<recording::MessageStream>(std::move(description), std::move(sinks));
  runtime::record_setup({}, file, *stream_);
  refresh_status();
}

Recorder::~Recorder() {
  if (log_) static_cast<void>(log_->flush());
}

void Recorder::on_output(const channels::CycleOutput& output) {
  cycle_ = output.cycle;
  stream_->allow_workpieces(workpieces_allowed_);
  stream_->cycle(output);
  if (output.cycle % refresh_period_ != 0) return;
  if (log_) static_cast<void>(log_->flush());
  refresh_status();
}

void Recorder::refresh_status() {
  const std::lock_guard lock(mutex_);
  if (publisher_) {
    const recording::PublisherStatus& lcm = publisher_->status();
    status_.lcm_url = lcm.url;
    status_.lcm_open = lcm.open;
    status_.lcm_sent = lcm.sent;
    status_.lcm_lost = lcm.lost;
  }
  if (!log_) return;
  const recording::LogStatus& log = log_->status();
  status_.log_file = log_file_;
  status_.log_bytes = log.bytes;
  status_.log_events = log.events;
  if (!log.error || has_told_error_) return;
  status_.log_error = log.error->text;
  has_told_error_ = true;
  spdlog::error("logging has stopped: {}", status_.log_error);
}

RecordingStatus Recorder::status() const {
  const std::lock_guard lock(mutex_);
  RecordingStatus status = status_;
  status.workpieces_allowed = workpieces_allowed_;
  return status;
}

std::filesystem::path log_file_name(const std::filesystem::path& directory,
                                    const std::string& machine) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &utc);
  return directory / (machine + "-" + text.data() + ".lcm");
}

}  // namespace stanok::daemon

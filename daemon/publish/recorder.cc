#include "daemon/publish/recorder.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/catalogue.h"
#include "protocol/version.h"
#include "runtime/run_setup.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t refresh_period_us = 200'000;
constexpr std::int64_t reopen_periods = 10;  // what is closed or gone is tried again
constexpr std::int64_t bytes_per_mb = 1'000'000;
constexpr std::int64_t us_per_s = 1'000'000;
constexpr std::int64_t flight_after_us = 2'000'000;  // what a fault leads to belongs to it

std::int64_t wall_clock_us() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

std::string flight_name(const std::string& machine) {
  return machine + "-flight";
}

bool stops_the_machine(const channels::Event& event) {
  const CatalogueRow* row = find_in_catalogue(event.code.view());
  return row != nullptr && row->reaction >= Reaction::feed_hold;
}

}  // namespace

Recorder::Recorder(const config::MachineFile& file, const std::string& build,
                   const RecorderOptions& options)
    : directory_(options.log_directory),
      machine_(file.machine.name),
      size_max_bytes_(file.recorder.size_mb * bytes_per_mb),
      cycle_us_(file.machine.cycle_us),
      refresh_period_(std::max<std::int64_t>(1, refresh_period_us / file.machine.cycle_us)) {
  std::vector<recording::MessageSink*> sinks{&log_};
  if (options.lcm_url) {
    publisher_ = std::make_unique<recording::Publisher>(*options.lcm_url);
    if (!publisher_->good()) {
      spdlog::warn("LCM {} cannot be opened; nothing is published", publisher_->status().url);
    }
    sinks.push_back(publisher_.get());
  }
  if (file.recorder.flight_s > 0.0) {
    flight_ = std::make_unique<recording::FlightRecorder>(
        static_cast<std::int64_t>(file.recorder.flight_s * us_per_s));
    sinks.push_back(flight_.get());
    flight_files_ = std::make_unique<FlightFiles>(directory_, flight_name(machine_),
                                                  [this](const auto& made) { note_flight(made); });
  }
  auto description = runtime::description_of(file, std::string(protocol::version), build);
  description.utime_start = wall_clock_us();
  if (options.logs_from_start) {
    status_.log_file = log_file_name(directory_, machine_);
    auto log = open_log(status_.log_file);
    if (!log) throw std::runtime_error(log.error().text);
    log_.turn_to(std::move(*log), description.utime_start);
  }
  stream_ = std::make_unique<recording::MessageStream>(std::move(description), std::move(sinks));
  runtime::record_setup({}, file, *stream_);
  refresh_status();
}

Recorder::~Recorder() {
  while (flight_due_cycle_ > 0) {
    write_flight();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::int64_t Recorder::utime() const {
  return stream_->description().utime_start + cycle_ * cycle_us_;
}

Expected<std::unique_ptr<recording::LogWriter>, recording::LogError> Recorder::open_log(
    const fs::path& file) const {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    return Unexpected<recording::LogError>(
        recording::log_error("cannot create " + file.parent_path().string(), error.value()));
  return recording::LogWriter::open(file, size_max_bytes_);
}

void Recorder::on_output(const channels::CycleOutput& output) {
  cycle_ = output.cycle;
  stream_->allow_workpieces(workpieces_allowed_);
  if (log_turns_.load(std::memory_order_acquire)) turn_log();
  if (has_new_paths_.load(std::memory_order_acquire)) take_new_paths();
  stream_->cycle(output);
  if (flight_due_cycle_ > 0 && cycle_ >= flight_due_cycle_) write_flight();
  if (output.cycle % refresh_period_ != 0) return;
  if (publisher_ && output.cycle % (reopen_periods * refresh_period_) == 0) open_bus_again();
  if (auto* log = log_.writer()) static_cast<void>(log->flush());
  refresh_status();
  if (output.cycle % (reopen_periods * refresh_period_) == 0) look_after_folder();
}

// A folder that was removed takes its log along: told, and a new log begins in a new folder.
void Recorder::look_after_folder() {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  const fs::path folder = fs::path(status_.log_file).parent_path();
  if (status_.log_file.empty() || log_turns_ || folder.empty()) return;
  if (fs::exists(folder, error) || error) return;
  const fs::path file = log_file_name(folder, machine_);
  auto log = open_log(file);
  if (!log) {
    if (!has_told_folder_) spdlog::error("the folder of the log is gone; {}", log.error().text);
    has_told_folder_ = true;
    return;
  }
  spdlog::error("the folder of the log {} is gone; a new one begins: {}", status_.log_file,
                file.string());
  has_told_folder_ = false;
  next_log_ = std::move(*log);
  status_.log_file = file;
  log_turns_.store(true, std::memory_order_release);
}

void Recorder::open_bus_again() {
  if (publisher_->good()) return;
  publisher_->reopen();
  if (publisher_->good()) spdlog::info("LCM {} is open now", publisher_->status().url);
}

void Recorder::show_path(recording::PathPreview path) {
  const std::lock_guard lock(mutex_);
  new_paths_.push_back(std::move(path));
  has_new_paths_.store(true, std::memory_order_release);
}

void Recorder::take_new_paths() {
  const std::lock_guard lock(mutex_);
  for (recording::PathPreview& path : new_paths_) stream_->path(std::move(path));
  new_paths_.clear();
  has_new_paths_ = false;
}

void Recorder::on_event(const channels::Event& event) {
  stream_->event(event);
  if (flight_ && flight_due_cycle_ == 0 && stops_the_machine(event))
    flight_due_cycle_ = event.cycle + flight_after_us / cycle_us_;
}

// Again in the next cycle while the file before is still being written.
void Recorder::write_flight() {
  if (!flight_files_->is_idle()) return;
  flight_files_->write(flight_->recording());
  flight_due_cycle_ = 0;
}

void Recorder::note_flight(const fs::path& file) {
  const std::lock_guard lock(mutex_);
  status_.flight_file = file;
}

std::optional<Expected<fs::path, recording::LogError>> Recorder::start_log() {
  const std::lock_guard lock(mutex_);
  if (!status_.log_file.empty() || log_turns_) return std::nullopt;
  fs::path file = log_file_name(directory_, machine_);
  auto log = open_log(file);
  if (!log) return Unexpected<recording::LogError>(log.error());
  next_log_ = std::move(*log);
  status_.log_file = file;
  status_.log_error.clear();
  log_turns_.store(true, std::memory_order_release);
  return file;
}

std::optional<fs::path> Recorder::stop_log() {
  const std::lock_guard lock(mutex_);
  if (status_.log_file.empty()) return std::nullopt;
  fs::path file = status_.log_file;
  next_log_.reset();
  status_.log_file.clear();
  status_.log_bytes = 0;
  status_.log_events = 0;
  log_turns_.store(true, std::memory_order_release);
  return file;
}

void Recorder::turn_log() {
  const std::lock_guard lock(mutex_);
  log_turns_ = false;
  if (auto* log = log_.writer()) static_cast<void>(log->finish());
  tell_error_of_log();
  log_.turn_to(std::move(next_log_), utime());
  has_told_error_ = false;
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
  if (log_.writer() == nullptr || log_turns_) return;
  const recording::LogStatus& log = log_.writer()->status();
  status_.log_bytes = log.bytes;
  status_.log_events = log.events;
  tell_error_of_log();
}

// Once for each log; also of what was still on its way to the disk when the log was ended.
void Recorder::tell_error_of_log() {
  if (log_.writer() == nullptr || log_.writer()->flush() || has_told_error_) return;
  status_.log_error = log_.writer()->status().error->text;
  has_told_error_ = true;
  spdlog::error("logging has stopped: {}", status_.log_error);
}

RecordingStatus Recorder::status() const {
  const std::lock_guard lock(mutex_);
  RecordingStatus status = status_;
  status.workpieces_allowed = workpieces_allowed_;
  return status;
}

}  // namespace stanok::daemon

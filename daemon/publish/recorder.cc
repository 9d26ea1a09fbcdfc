#include "daemon/publish/recorder.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>
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
    : logs_(options.log_directory, file.machine.name, file.recorder.size_mb * bytes_per_mb),
      cycle_us_(file.machine.cycle_us),
      refresh_period_(std::max<std::int64_t>(1, refresh_period_us / file.machine.cycle_us)) {
  std::vector<recording::MessageSink*> sinks{&logs_.sink()};
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
    flight_files_ =
        std::make_unique<FlightFiles>(options.log_directory, flight_name(file.machine.name),
                                      [this](const auto& made) { note_flight(made); });
  }
  auto description = runtime::description_of(file, std::string(protocol::version), build);
  description.utime_start = wall_clock_us();
  if (options.logs_from_start) logs_.begin(description.utime_start);
  stream_ = std::make_unique<recording::MessageStream>(std::move(description), std::move(sinks));
  runtime::record_setup({}, file, *stream_);
  status_.log_directory = options.log_directory;
  refresh_publisher_status();
  logs_.flush();
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

void Recorder::on_output(const channels::CycleOutput& output) {
  cycle_ = output.cycle;
  stream_->allow_workpieces(workpieces_allowed_);
  logs_.turn(utime());
  if (has_new_paths_.load(std::memory_order_acquire)) take_new_paths();
  stream_->cycle(output);
  if (flight_due_cycle_ > 0 && cycle_ >= flight_due_cycle_) write_flight();
  if (output.cycle % refresh_period_ != 0) return;
  if (publisher_ && output.cycle % (reopen_periods * refresh_period_) == 0) open_bus_again();
  refresh_publisher_status();
  logs_.flush();
  if (output.cycle % (reopen_periods * refresh_period_) == 0) logs_.look_after_folder();
}

void Recorder::open_bus_again() {
  if (publisher_->good()) return;
  publisher_->reopen();
  if (publisher_->good()) spdlog::info("LCM {} is open now", publisher_->status().url);
}

void Recorder::show_path(recording::PathPreview path) {
  const std::lock_guard lock(paths_mutex_);
  new_paths_.push_back(std::move(path));
  has_new_paths_.store(true, std::memory_order_release);
}

// Who shows them runs when nothing else wants to: it is not waited for, there is a next output.
void Recorder::take_new_paths() {
  const std::unique_lock lock(paths_mutex_, std::try_to_lock);
  if (!lock) return;
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

void Recorder::refresh_publisher_status() {
  if (!publisher_) return;
  const std::lock_guard lock(mutex_);
  const recording::PublisherStatus& lcm = publisher_->status();
  status_.lcm_url = lcm.url;
  status_.lcm_open = lcm.open;
  status_.lcm_sent = lcm.sent;
  status_.lcm_lost = lcm.lost;
}

RecordingStatus Recorder::status() const {
  LogFileStatus log = logs_.status();
  const std::lock_guard lock(mutex_);
  RecordingStatus status = status_;
  status.log_file = std::move(log.file);
  status.log_bytes = log.bytes;
  status.log_events = log.events;
  status.log_error = std::move(log.error);
  status.workpieces_allowed = workpieces_allowed_;
  return status;
}

}  // namespace stanok::daemon

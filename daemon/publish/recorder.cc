#include "daemon/publish/recorder.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <thread>
#include <utility>
#include <vector>

#include "base/catalogue.h"
#include "protocol/contract/version.h"
#include "runtime/run_setup.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t refresh_period_us = 200'000;
constexpr std::int64_t reopen_periods = 10;  // what is closed or gone is tried again
constexpr std::int64_t us_per_s = 1'000'000;
constexpr std::int64_t flight_after_us = 2'000'000;  // what a fault leads to belongs to it

std::int64_t wall_clock_us() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

bool stops_the_machine(const channels::Event& event) {
  const CatalogueRow* row = find_in_catalogue(event.code.view());
  return row != nullptr && row->reaction >= Reaction::feed_hold;
}

}  // namespace

Recorder::Recorder(const config::MachineFile& file, const std::string& build,
                   const RecorderOptions& options)
    : retention_(options.log_directory, file.machine.name, log_limits_of(file.recorder),
                 options.disk),
      logs_(options.log_directory, file.machine.name, retention_.limits().piece_bytes_max,
            [this](const std::string& why) { note_trouble(why); }),
      refresh_period_(std::max<std::int64_t>(1, refresh_period_us / file.machine.cycle_us)) {
  std::vector<recording::MessageSink*> sinks{&logs_.sink()};
  if (options.lcm_url) {
    publisher_ = std::make_unique<recording::LcmPublisher>(*options.lcm_url);
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
        std::make_unique<FlightFiles>(options.log_directory, file.machine.name, calls_of_flight());
  }
  auto description = runtime::description_of(file, std::string(protocol::version), build);
  description.utime_start = wall_clock_us();
  logs_.set_room(retention_.tidy({}).no_room);
  if (options.logs_from_start) logs_.begin(description.utime_start);
  stream_ = std::make_unique<recording::MessageStream>(std::move(description), std::move(sinks));
  runtime::record_setup({}, file, *stream_);
  status_.log_directory = options.log_directory;
  refresh_publisher_status();
  logs_.flush();
  disk_thread_ = std::jthread([this, period = options.disk_period](const std::stop_token& stop) {
    look_after_disk(stop, period);
  });
}

FlightFiles::Calls Recorder::calls_of_flight() {
  return {.make_room =
              [this](std::int64_t bytes) {
                return retention_.tidy(logs_.status().file, bytes).no_room;
              },
          .written = [this](const fs::path& file) { note_flight(file); },
          .failed = [this](const std::string& why) { note_trouble(why); }};
}

void Recorder::look_after_disk(const std::stop_token& stop, std::chrono::milliseconds period) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  while (!never.wait_for(lock, stop, period, [] { return false; }) && !stop.stop_requested())
    logs_.set_room(retention_.tidy(logs_.status().file).no_room);
}

void Recorder::note_trouble(const std::string& why) {
  const std::lock_guard lock(mutex_);
  trouble_.told ? trouble_.told(why) : trouble_.untold.push_back(why);
}

void Recorder::tell_trouble_to(LogFiles::Trouble told) {
  const std::lock_guard lock(mutex_);
  trouble_.told = std::move(told);
  for (const std::string& why : std::exchange(trouble_.untold, {})) trouble_.told(why);
}

Recorder::~Recorder() {
  while (flight_due_cycle_ > 0) {
    write_flight();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::int64_t Recorder::utime() const {
  const recording::LogDescription& log = stream_->description();
  return log.utime_start + cycle_ * log.cycle_us;
}

void Recorder::on_output(const channels::CycleOutput& output) {
  cycle_ = output.cycle;
  stream_->allow_workpieces(workpieces_allowed_);
  logs_.turn(utime());
  if (new_paths_.are_there.load(std::memory_order_acquire)) take_new_paths();
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
  const std::lock_guard lock(new_paths_.mutex);
  new_paths_.paths.push_back(std::move(path));
  new_paths_.are_there.store(true, std::memory_order_release);
}

// Who shows them runs when nothing else wants to: it is not waited for, there is a next output.
void Recorder::take_new_paths() {
  const std::unique_lock lock(new_paths_.mutex, std::try_to_lock);
  if (!lock) return;
  for (recording::PathPreview& path : new_paths_.paths) stream_->path(std::move(path));
  new_paths_.paths.clear();
  new_paths_.are_there = false;
}

void Recorder::on_event(const channels::Event& event) {
  stream_->event(event);
  if (flight_ && flight_due_cycle_ == 0 && stops_the_machine(event))
    flight_due_cycle_ = event.cycle + flight_after_us / stream_->description().cycle_us;
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

KeptLogsStatus Recorder::kept_logs() const {
  const KeptLogs kept = retention_.kept();
  const LogLimits& limits = retention_.limits();
  return {.files = kept.files,
          .bytes = kept.bytes,
          .bytes_max = limits.bytes_max,
          .age_max_s = limits.age_max.count(),
          .free_bytes = kept.free_bytes,
          .free_bytes_min = limits.free_bytes_min};
}

RecordingStatus Recorder::status() const {
  LogFileStatus log = logs_.status();
  const std::lock_guard lock(mutex_);
  RecordingStatus status = status_;
  status.log_file = std::move(log.file);
  status.log_bytes = log.bytes;
  status.log_events = log.events;
  status.log_error = std::move(log.error);
  status.log_rests = log.rests;
  status.kept = kept_logs();
  status.workpieces_allowed = workpieces_allowed_;
  return status;
}

}  // namespace stanok::daemon

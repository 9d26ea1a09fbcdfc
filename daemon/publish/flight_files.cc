#include "daemon/publish/flight_files.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <exception>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "daemon/publish/log_retention.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t flights_max = 10;  // files; older ones are removed

// By the time of writing: of one second the names do not sort by time.
void keep_newest_files(const fs::path& directory, const std::string& machine) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const auto name = log_file_name_of(entry.path().filename().string(), machine);
    if (!name || !name->is_flight) continue;
    std::error_code gone;
    files.emplace_back(fs::last_write_time(entry.path(), gone), entry.path());
  }
  std::sort(files.begin(), files.end());
  for (std::size_t k = 0; k + flights_max < files.size(); ++k) fs::remove(files[k].second, error);
}

}  // namespace

FlightFiles::FlightFiles(fs::path directory, std::string machine, Calls calls)
    : directory_(std::move(directory)),
      machine_(std::move(machine)),
      calls_(std::move(calls)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

FlightFiles::~FlightFiles() = default;

bool FlightFiles::is_idle() {
  const std::lock_guard lock(mutex_);
  return !next_;
}

void FlightFiles::write(recording::FlightRecording&& recording) {
  const std::lock_guard lock(mutex_);
  STANOK_ASSERT(!next_);
  next_ = std::move(recording);
  news_.notify_one();
}

void FlightFiles::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (news_.wait(lock, stop, [this] { return next_.has_value(); })) {
    lock.unlock();
    try {
      write_now(*next_);
    } catch (const std::exception& fault) {
      fail(fault.what());
    }
    lock.lock();
    next_.reset();
  }
}

void FlightFiles::fail(const std::string& why) const {
  spdlog::error("the flight recorder: {}", why);
  calls_.failed("the flight recorder could not write its log: " + why);
}

void FlightFiles::write_now(const recording::FlightRecording& recording) const {
  const std::string no_room = calls_.make_room(recording.bytes());
  if (!no_room.empty()) return fail(no_room);
  const fs::path file = log_file_name(directory_, machine_ + "-flight");
  std::error_code error;
  fs::create_directories(directory_, error);
  const auto written = recording.write(file);
  if (!written) {
    fs::remove(file, error);
    return fail(written.error().text);
  }
  keep_newest_files(directory_, machine_);
  spdlog::warn("a fault has stopped the machine: the last seconds are in {}", file.string());
  calls_.written(file);
}

fs::path log_file_name(const fs::path& directory, const std::string& name) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &utc);
  const std::string stem = name + "-" + text.data();
  fs::path file = directory / (stem + ".lcm");
  std::error_code error;
  for (int n = 2; fs::exists(file, error); ++n)
    file = directory / (stem + "-" + std::to_string(n) + ".lcm");
  return file;
}

}  // namespace stanok::daemon

#include "daemon/journal/journal.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <random>
#include <utility>

#include "daemon/host/unix_time.h"
#include "protocol/contract/version.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr auto writing_period = std::chrono::milliseconds(50);
constexpr std::int64_t journal_bytes_max = 8'000'000;
// What a disk that takes nothing may cost in memory.
constexpr std::size_t unwritten_max = 20'000;

std::string new_id() {
  std::random_device chance;
  std::string id;
  for (int k = 0; k < 4; ++k) id += fmt::format("{:08x}", chance());
  return id;
}

}  // namespace

Journal::Journal(const fs::path& directory)
    : file_(directory / "journal.jsonl"), path_(directory / "journal.jsonl") {
  read();
  id_ = contents_.id();
  if (!id_.empty()) return;
  id_ = new_id();
  added_.push_back({{"kind", journal_kind::journal}, {"id", id_}});
}

void Journal::read() {
  JournalFile::Contents told = file_.read();
  if (!told.fault.empty()) {
    const fs::path aside = path_.string() + ".damaged";
    std::error_code error;
    fs::rename(path_, aside, error);
    spdlog::error("the journal cannot be read: {}; {}", told.fault,
                  error ? error.message() : "it was renamed to " + aside.string());
    return;
  }
  if (told.damaged > 0)
    spdlog::warn("{} lines of the journal are damaged and were skipped", told.damaged);
  for (const json& record : told.records) contents_.take(record);
}

void Journal::begin(Watch watch, OnFault on_fault) {
  watch_ = std::move(watch);
  on_fault_ = std::move(on_fault);
  add({{"kind", journal_kind::start}, {"version", protocol::version}});
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Journal::~Journal() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  try {
    write();
    add({{"kind", journal_kind::end}});
    write();
  } catch (const std::exception& fault) {
    spdlog::error("the journal lacks its end: {}", fault.what());
  }
}

void Journal::add(json record) {
  if (!record.contains("at")) record["at"] = unix_time_s();
  const std::lock_guard lock(mutex_);
  added_.push_back(std::move(record));
}

std::vector<json> Journal::actions() const {
  const std::lock_guard lock(mutex_);
  return {contents_.actions().begin(), contents_.actions().end()};
}

std::optional<std::string> Journal::fault() const {
  const std::lock_guard lock(mutex_);
  return fault_;
}

void Journal::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    write();
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, stop, writing_period, [] { return false; });
  }
}

// Memory may end, too.
void Journal::write() {
  std::optional<std::string> fault;
  try {
    std::vector<json> seen = watch_();
    {
      const std::lock_guard lock(mutex_);
      seen.insert(seen.begin(), added_.begin(), added_.end());
      added_.clear();
      for (const json& record : seen) contents_.take(record);
    }
    unwritten_.insert(unwritten_.end(), seen.begin(), seen.end());
    fault = bring_to_disk();
  } catch (const std::exception& thrown) {
    fault = thrown.what();
  }
  note_outcome(fault);
}

// Where more waits for the disk than memory is for, only what is remembered of it is written, in
// the place of the file, as soon as the disk takes that.
std::optional<std::string> Journal::bring_to_disk() {
  if (unwritten_.size() > unwritten_max) {
    unwritten_.clear();
    is_behind_ = true;
  }
  const bool has_news = !unwritten_.empty();
  if (!is_behind_) {
    if (auto fault = file_.append(unwritten_)) return fault;
    unwritten_.clear();
  }
  const bool is_long = has_news && file_.bytes() > journal_bytes_max;
  if (!is_behind_ && !is_long) return std::nullopt;
  if (auto fault = file_.replace(contents_.records())) return fault;
  unwritten_.clear();
  is_behind_ = false;
  return std::nullopt;
}

void Journal::note_outcome(const std::optional<std::string>& fault) {
  bool is_new = false;
  bool is_over = false;
  {
    const std::lock_guard lock(mutex_);
    is_new = fault && !fault_;
    is_over = !fault && fault_;
    fault_ = fault;
  }
  if (is_new) {
    spdlog::error("the journal cannot be saved: {}; the daemon tries again", *fault);
    try {
      on_fault_(*fault);
    } catch (const std::exception& untold) {
      spdlog::error("operators cannot be told: {}", untold.what());
    }
  }
  if (is_over) spdlog::info("the journal is being saved again");
}

}  // namespace stanok::daemon

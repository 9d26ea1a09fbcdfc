#include "daemon/table_keeper.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "config/tables_file.h"
#include "daemon/durable_file.h"
#include "daemon/state_directory.h"

namespace stanok::daemon {
namespace {

constexpr DurableKind kind{.name = "tables", .version = 1};
constexpr std::string_view file_name = "tables.toml";
constexpr auto period = std::chrono::milliseconds(500);

}  // namespace

void load_tables(const std::filesystem::path& state, channels::MachineConfig& machine) {
  const std::filesystem::path file = state / file_name;
  auto kept = read_durably(file, kind);
  if (!kept) throw StateDirectoryError(kept.error());
  if (!*kept) return;
  if (!(*kept)->warning.empty()) spdlog::warn("{}", (*kept)->warning);
  machine.tables = config::read_tables_text((*kept)->text, file, config::names_of_axes(machine));
}

TableKeeper::TableKeeper(const std::filesystem::path& state, Snapshot snapshot)
    : file_(state / file_name),
      snapshot_(std::move(snapshot)),
      saved_(config::to_toml(snapshot_())) {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      wake.wait_for(lock, stop, period, [] { return false; });
      save_when_changed();
    }
  });
}

TableKeeper::~TableKeeper() = default;

void TableKeeper::save_when_changed() {
  std::string now = config::to_toml(snapshot_());
  if (now == saved_) return;
  if (const auto fault = write_durably(file_, kind, now)) {
    if (!has_told_fault_) spdlog::error("tables cannot be kept: {}; tried again", *fault);
    has_told_fault_ = true;
    return;
  }
  if (has_told_fault_) spdlog::info("tables are kept again");
  has_told_fault_ = false;
  saved_ = std::move(now);
}

}  // namespace stanok::daemon

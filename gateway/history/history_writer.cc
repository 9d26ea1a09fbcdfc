#include "gateway/history/history_writer.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "gateway/history/history.h"
#include "gateway/outbox/backoff.h"
#include "gateway/outbox/outbox.h"
#include "gateway/outbox/wall_clock.h"

namespace stanok::gateway {
namespace {

using namespace std::chrono_literals;

constexpr auto look_period = 200ms;
constexpr auto forget_period = 1h;
constexpr int at_once_max = 500;
constexpr double day_s = 86400.0;

}  // namespace

HistoryWriter::HistoryWriter(std::string database, std::filesystem::path outbox, int keep_days)
    : database_(std::move(database)), outbox_file_(std::move(outbox)), keep_days_(keep_days) {}

void HistoryWriter::run(const std::stop_token& stop) {
  Backoff backoff;
  while (!stop.stop_requested()) {
    has_stored_ = false;
    try {
      serve(stop);
    } catch (const std::exception& error) {
      if (has_stored_) backoff.reset();
      if (backoff.is_first()) spdlog::warn("history: {}; trying again", error.what());
      backoff.wait(stop);
    }
  }
}

void HistoryWriter::serve(const std::stop_token& stop) {
  Outbox outbox(outbox_file_);
  History history(database_);
  spdlog::info("history: the database is available");
  auto forgets = std::chrono::steady_clock::now();
  while (!stop.stop_requested()) {
    const auto events = outbox.behind(outbox.position(consumer), at_once_max);
    if (events.empty()) {
      wait_for(look_period, stop);
    } else {
      history.store(outbox.source(), events);
      has_stored_ = true;
      outbox.set_position(consumer, events.back().number);
    }
    if (std::chrono::steady_clock::now() < forgets) continue;
    history.forget_before(wall_clock_s() - keep_days_ * day_s);
    forgets = std::chrono::steady_clock::now() + forget_period;
  }
}

}  // namespace stanok::gateway

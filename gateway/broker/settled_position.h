// SettledPosition: up to which number the broker is trusted with what it has acknowledged.
//
// A broker may acknowledge an event that it holds in memory only. When it dies, whoever was not
// connected never gets it. What was acknowledged a short while ago is therefore kept, and sent
// again on the next connection; its number tells who has it already.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

namespace stanok::gateway {

class SettledPosition {
 public:
  using Clock = std::chrono::steady_clock;

  explicit SettledPosition(Clock::duration kept) : kept_(kept) {}

  // Everything up to `number` is acknowledged now. Numbers count up.
  void acknowledge(std::int64_t number, Clock::time_point now);
  // What was acknowledged that long ago and has not been asked for yet; nothing: no more than
  // before.
  [[nodiscard]] std::optional<std::int64_t> take(Clock::time_point now);
  // The connection has ended: what was acknowledged on it has still to prove itself.
  void clear() { acknowledged_.clear(); }

 private:
  struct Acknowledged {
    Clock::time_point since;
    std::int64_t number = 0;
  };
  Clock::duration kept_;
  std::deque<Acknowledged> acknowledged_;  // at most a few in each second
};

}  // namespace stanok::gateway

// Scope: signals of the machine at the full cycle rate, from before an event to some time behind
// it.
//
// It listens where the records are made (daemon/publish/publisher_thread.h): the cycle does nothing
// for it but what it does anyway, to put its output and times into rings that never wait. One
// recording at a time, in memory of a fixed bound, for all who look. The publisher's thread feeds
// it, any other starts and reads it.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "daemon/scope/scope_signals.h"

namespace stanok::daemon {

struct ScopeTrigger {
  enum class Kind : std::uint8_t { none, level, event, block, alarm };
  enum class Edge : std::uint8_t { rising, falling };
  Kind kind = Kind::none;
  std::size_t signal = 0;  // of those that are recorded, for `level`
  double level = 0.0;
  Edge edge = Edge::rising;
  std::string event;       // its code; empty: any
  int channel = 0;         // of a block or alarm; 0: any
  std::uint32_t line = 0;  // of a block
};

struct ScopeOrder {
  std::vector<ScopeSignal> signals;
  ScopeTrigger trigger;
  std::size_t before = 0;  // cycles that are kept from before the trigger
  std::size_t cycles = 0;  // of the whole recording
};

enum class ScopeState : std::uint8_t { off, waiting, recording, complete };

struct ScopeReading {
  std::uint32_t id = 0;  // of the recording, from 1
  ScopeState state = ScopeState::off;
  struct Named {
    std::string name;
    std::string unit;
    std::optional<double> limit;
  };
  std::vector<Named> signals;
  std::size_t cycles = 0;                    // recorded so far
  std::optional<std::size_t> trigger_cycle;  // which of them
  std::int64_t first_cycle = 0;              // of the machine
  std::size_t from = 0;
  // Of the cycles from `from` on: a value of each signal, cycle by cycle. Not a number: the cycle
  // was lost, or does not tell it.
  std::vector<float> values;
};

class Scope {
 public:
  static constexpr std::size_t signals_max = 8;
  static constexpr std::size_t cycles_max = 120'000;
  static constexpr std::size_t read_cycles_max = 4096;

  // What was recorded before is gone. Its id.
  std::uint32_t start(ScopeOrder order);
  // What has been recorded stays.
  void stop();
  [[nodiscard]] ScopeReading read(std::size_t from) const;

  // The publisher's thread.
  void take(const ScopeCycle& cycle);
  void take(const channels::Event& event);

 private:
  [[nodiscard]] bool is_triggered(const ScopeCycle& cycle);
  [[nodiscard]] bool has_crossed(double value) const;
  void record(const std::vector<float>& values, std::int64_t cycle);
  void fill_gap(std::int64_t cycle);
  void put(const std::vector<float>& values);
  [[nodiscard]] std::size_t row_of(std::size_t cycle) const;

  mutable std::mutex mutex_;
  std::uint32_t id_ = 0;
  ScopeState state_ = ScopeState::off;
  ScopeOrder order_;
  std::vector<float> values_;  // a ring of `order_.cycles` rows
  std::size_t first_row_ = 0;
  std::size_t count_ = 0;  // rows in it
  std::optional<std::size_t> trigger_;
  std::int64_t last_cycle_ = 0;  // of the machine
  std::vector<float> now_;
  // What the trigger saw last.
  double last_value_ = 0.0;
  bool event_came_ = false;
  bool was_there_ = false;  // the block, or the alarm
};

}  // namespace stanok::daemon

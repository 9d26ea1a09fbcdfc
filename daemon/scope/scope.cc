#include "daemon/scope/scope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stanok::daemon {
namespace {

using channels::ChannelOutput;

constexpr float lost = std::numeric_limits<float>::quiet_NaN();

bool runs_line(const ChannelOutput& channel, std::uint32_t line) {
  return channel.running && channel.tag.line == line;
}

}  // namespace

std::uint32_t Scope::start(ScopeOrder order) {
  std::vector<float> values(order.cycles * order.signals.size());
  const std::lock_guard lock(mutex_);
  order_ = std::move(order);
  values_ = std::move(values);
  now_.assign(order_.signals.size(), lost);
  first_row_ = count_ = 0;
  trigger_.reset();
  last_value_ = std::numeric_limits<double>::quiet_NaN();
  event_came_ = false;
  was_there_ = true;  // what is so already is no event
  state_ = ScopeState::waiting;
  return ++id_;
}

void Scope::stop() {
  const std::lock_guard lock(mutex_);
  if (state_ == ScopeState::waiting || state_ == ScopeState::recording)
    state_ = ScopeState::complete;
}

std::size_t Scope::row_of(std::size_t cycle) const {
  return (first_row_ + cycle) % order_.cycles * order_.signals.size();
}

ScopeReading Scope::read(std::size_t from) const {
  const std::lock_guard lock(mutex_);
  ScopeReading reading;
  reading.id = id_;
  reading.state = state_;
  for (const ScopeSignal& signal : order_.signals)
    reading.signals.push_back({signal.name, signal.unit, signal.limit});
  reading.cycles = count_;
  reading.trigger_cycle = trigger_;
  reading.first_cycle = last_cycle_ - static_cast<std::int64_t>(count_) + 1;
  reading.from = std::min(from, count_);
  const std::size_t end = std::min(count_, reading.from + read_cycles_max);
  reading.values.reserve((end - reading.from) * order_.signals.size());
  for (std::size_t cycle = reading.from; cycle < end; ++cycle) {
    const auto row = values_.begin() + static_cast<std::ptrdiff_t>(row_of(cycle));
    reading.values.insert(reading.values.end(), row,
                          row + static_cast<std::ptrdiff_t>(order_.signals.size()));
  }
  return reading;
}

void Scope::take(const channels::Event& event) {
  const std::lock_guard lock(mutex_);
  if (state_ != ScopeState::waiting || order_.trigger.kind != ScopeTrigger::Kind::event) return;
  const std::string& wanted = order_.trigger.event;
  event_came_ = event_came_ || wanted.empty() || event.code.view() == wanted;
}

void Scope::take(const ScopeCycle& cycle) {
  const std::lock_guard lock(mutex_);
  if (state_ != ScopeState::waiting && state_ != ScopeState::recording) return;
  for (std::size_t k = 0; k < order_.signals.size(); ++k)
    now_[k] = static_cast<float>(order_.signals[k].value(cycle));
  record(now_, cycle.output.cycle);
  if (state_ == ScopeState::waiting && is_triggered(cycle)) {
    trigger_ = count_ - 1;
    state_ = ScopeState::recording;
  }
  if (state_ == ScopeState::recording && count_ == order_.cycles) state_ = ScopeState::complete;
}

void Scope::record(const std::vector<float>& values, std::int64_t cycle) {
  if (count_ > 0) fill_gap(cycle);
  last_cycle_ = cycle;
  put(values);
}

// Cycles that the publisher was too late for keep their place.
void Scope::fill_gap(std::int64_t cycle) {
  const std::vector<float> nothing(order_.signals.size(), lost);
  const auto longest = static_cast<std::int64_t>(order_.cycles);
  const std::int64_t missing = std::min(cycle - last_cycle_ - 1, longest);
  for (std::int64_t k = 0; k < missing && (!trigger_ || count_ < order_.cycles - 1); ++k)
    put(nothing);
}

// Before the trigger the oldest row goes when there are as many as are wanted of that time.
void Scope::put(const std::vector<float>& values) {
  if (!trigger_ && count_ > order_.before) {
    first_row_ = (first_row_ + 1) % order_.cycles;
    --count_;
  }
  std::ranges::copy(values, values_.begin() + static_cast<std::ptrdiff_t>(row_of(count_)));
  ++count_;
}

bool Scope::has_crossed(double value) const {
  const double level = order_.trigger.level;
  if (order_.trigger.edge == ScopeTrigger::Edge::rising)
    return last_value_ < level && value >= level;
  return last_value_ > level && value <= level;
}

// A recording without a trigger begins at once.
bool Scope::is_triggered(const ScopeCycle& cycle) {
  const ScopeTrigger& trigger = order_.trigger;
  const auto any_channel = [&](auto&& is_so) {
    return std::ranges::any_of(cycle.output.of_channels(), [&](const ChannelOutput& channel) {
      return (trigger.channel == 0 || trigger.channel == channel.id) && is_so(channel);
    });
  };
  bool is_there = false;
  switch (trigger.kind) {
    case ScopeTrigger::Kind::none:
      return true;
    case ScopeTrigger::Kind::event:
      return event_came_;
    case ScopeTrigger::Kind::level: {
      const auto value = static_cast<double>(now_[trigger.signal]);
      const bool crossed = has_crossed(value);
      last_value_ = value;
      return crossed;
    }
    case ScopeTrigger::Kind::block:
      is_there = any_channel([&](const ChannelOutput& c) { return runs_line(c, trigger.line); });
      break;
    case ScopeTrigger::Kind::alarm:
      is_there = any_channel(
          [](const ChannelOutput& c) { return c.state == channels::ChannelState::alarm; });
      break;
  }
  const bool begins = is_there && !was_there_;
  was_there_ = is_there;
  return begins;
}

}  // namespace stanok::daemon

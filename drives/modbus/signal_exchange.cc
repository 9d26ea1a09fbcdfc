// Signals joined to blocks, and the packing of their bits and values.
#include "drives/modbus/signal_exchange.h"

#include <algorithm>
#include <tuple>

#include "base/place.h"

namespace stanok::drives {
namespace {

// Below the limits of all functions: 1968 coils, 123 registers written.
constexpr int count_max = 120;

auto request_of(const SignalConfig& signal) {
  return std::tuple(signal.unit, signal.table, signal.is_output());
}

std::vector<SignalBlock> blocks_of(std::vector<SignalConfig> signals) {
  std::ranges::sort(signals, {}, [](const SignalConfig& signal) {
    return std::tuple_cat(request_of(signal), std::tuple(signal.field.address));
  });
  std::vector<SignalBlock> blocks;
  for (const SignalConfig& signal : signals) {
    const RegisterField& field = signal.field;
    const bool goes_on = !blocks.empty() &&
                         request_of(signal) == std::tuple(blocks.back().unit, blocks.back().table,
                                                          blocks.back().is_output) &&
                         field.address <= blocks.back().first + blocks.back().count() &&
                         field.end() - blocks.back().first <= count_max;
    if (!goes_on) {
      blocks.push_back({.unit = signal.unit,
                        .table = signal.table,
                        .is_output = signal.is_output(),
                        .first = field.address,
                        .bits = {},
                        .words = {}});
    }
    SignalBlock& block = blocks.back();
    const auto size = checked_size(std::max(block.count(), field.end() - block.first));
    signal.is_of_bits() ? block.bits.resize(size) : block.words.resize(size);
  }
  return blocks;
}

// The field as it lies in the words of a block.
RegisterField within(const SignalBlock& block, RegisterField field) {
  field.address -= block.first;
  return field;
}

}  // namespace

SignalExchange::SignalExchange(std::vector<SignalConfig> signals, BusTime timeout)
    : signals_(std::move(signals)),
      blocks_(blocks_of(signals_)),
      patience_(blocks_.size(), Patience(timeout)),
      timeout_(timeout) {
  for (const SignalBlock& block : blocks_) {
    const bool is_known = std::ranges::any_of(
        silences_, [&](const Silence& silence) { return silence.unit == block.unit; });
    if (!is_known) silences_.push_back({block.unit, BusTime{0}});
  }
}

bool SignalExchange::holds(const SignalBlock& block, const SignalConfig& signal) {
  return request_of(signal) == std::tuple(block.unit, block.table, block.is_output) &&
         signal.field.address >= block.first && signal.field.end() <= block.first + block.count();
}

void SignalExchange::fill_outputs(const Signals& outputs) {
  for (SignalBlock& block : blocks_) {
    if (!block.is_output) continue;
    std::ranges::fill(block.bits, std::uint8_t{0});
    std::ranges::fill(block.words, std::uint16_t{0});
    for (const SignalConfig& signal : signals_) {
      if (holds(block, signal)) write_signal(block, signal, outputs);
    }
  }
}

void SignalExchange::write_signal(SignalBlock& block, const SignalConfig& signal,
                                  const Signals& outputs) const {
  const RegisterField field = within(block, signal.field);
  const std::size_t at = field.place();
  if (!signal.is_digital()) {
    const double value = outputs.analog[signal.number];
    write_field(field, field.saturated_increments(value), block.words);
    return;
  }
  const bool on = outputs.is_on(signal.number) != signal.is_inverted;
  if (signal.is_of_bits()) {
    block.bits[at] = on ? 1 : 0;
  } else if (on) {
    block.words[at] = static_cast<std::uint16_t>(block.words[at] | 1U << signal.bit);
  }
}

void SignalExchange::read_signal(const SignalBlock& block, const SignalConfig& signal) {
  const RegisterField field = within(block, signal.field);
  const std::size_t at = field.place();
  if (!signal.is_digital()) {
    inputs_.analog[signal.number] = field.value(read_field(field, block.words));
    return;
  }
  const bool level =
      signal.is_of_bits() ? block.bits[at] != 0 : (block.words[at] >> signal.bit & 1U) != 0;
  inputs_.set(signal.number, level != signal.is_inverted);
}

SignalExchange::Silence& SignalExchange::silence_of(int unit) {
  return *std::ranges::find(silences_, unit, &Silence::unit);
}

bool SignalExchange::is_due(const SignalBlock& block, BusTime now) const {
  return std::ranges::find(silences_, block.unit, &Silence::unit)->until <= now;
}

void SignalExchange::take(const SignalBlock& block) {
  if (block.is_output) return;
  for (const SignalConfig& signal : signals_) {
    if (holds(block, signal)) read_signal(block, signal);
  }
}

void SignalExchange::fail(const SignalBlock& block, BusTime now) {
  silence_of(block.unit).until = now + timeout_;
}

}  // namespace stanok::drives

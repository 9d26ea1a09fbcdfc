// The signals of a bus: which requests carry them, and what is in the requests. No sockets, no
// clock.
//
// Signals of one unit and table whose addresses follow each other go in one request. A unit that
// does not answer is left alone for the timeout, so that it does not hold up the drives; its inputs
// keep their last values.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "drives/modbus/contact_watch.h"
#include "drives/modbus/patience.h"
#include "drives/signals.h"

namespace stanok::drives {

// One request: consecutive coils, inputs or registers of a unit.
struct SignalBlock {
  int unit = 1;
  SignalTable table = SignalTable::coil;
  bool is_output = false;
  int first = 0;
  std::vector<std::uint8_t> bits;    // of coils and discrete inputs
  std::vector<std::uint16_t> words;  // of registers

  [[nodiscard]] int count() const { return static_cast<int>(bits.size() + words.size()); }
};

class SignalExchange {
 public:
  SignalExchange(std::vector<SignalConfig> signals, BusTime timeout);

  [[nodiscard]] std::vector<SignalBlock>& blocks() { return blocks_; }
  // With the unit of a block.
  [[nodiscard]] Patience& patience(std::size_t place) { return patience_[place]; }
  // Outputs into the blocks; an output of no signal is 0.
  void fill_outputs(const Signals& outputs);

  // Whether the unit of the block is asked now.
  [[nodiscard]] bool is_due(const SignalBlock& block, BusTime now) const;
  // The block has been read or written.
  void take(const SignalBlock& block);
  // The unit did not answer, or with an exception.
  void fail(const SignalBlock& block, BusTime now);

  [[nodiscard]] const Signals& inputs() const { return inputs_; }

 private:
  struct Silence {
    int unit;
    BusTime until;
  };

  [[nodiscard]] static bool holds(const SignalBlock& block, const SignalConfig& signal);
  [[nodiscard]] Silence& silence_of(int unit);
  void write_signal(SignalBlock& block, const SignalConfig& signal, const Signals& outputs) const;
  void read_signal(const SignalBlock& block, const SignalConfig& signal);

  std::vector<SignalConfig> signals_;
  std::vector<SignalBlock> blocks_;
  std::vector<Patience> patience_;  // with each block
  std::vector<Silence> silences_;
  Signals inputs_;
  BusTime timeout_;
};

}  // namespace stanok::drives

// A machine of two channels whose preparation a test steps by hand, where MachineBench would run it
// to its end before each cycle.
#pragma once

#include <string>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {

class SteppedMachine {
 public:
  explicit SteppedMachine(const lang::Files& files)
      : machine(config, files, {.on_at_start = true, .stops_go_on = true}) {}

  // A cycle with a command to channel 1.
  void ask(channels::OperatorAction action, const std::string& text = "") {
    channels::OperatorEvent event;
    event.command =
        channels::command_of({.action = action, .text = std::string_view(text)}).value();
    event.channel = 1;
    channels::CycleInputs inputs;
    inputs.events = {&event, 1};
    machine.cycle(inputs, output);
  }
  void cycle() { machine.cycle({}, output); }
  [[nodiscard]] const channels::ChannelOutput& channel() const { return output.channels[0]; }

  channels::MachineConfig config = two_channel_machine();
  channels::Machine machine;
  channels::CycleOutput output;
};

}  // namespace stanok::testing

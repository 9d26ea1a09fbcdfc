// SimulatedWorkpieces: the virtual workpieces of a machine on the virtual clock, cut in every
// cycle, and what a probe and a tool setter find of them before the next one.
//
// One for a run: what is cut is what is measured. Deterministic: positions go in, inputs come out.
// Thread: the one of the simulation, outside of the cycle, which gets the inputs as it gets those
// of drives (docs/developer/adr/0028-simulated-probe.md).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/signals.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::runtime {

class SimulatedWorkpieces {
 public:
  // Takes what cannot be followed: channel, code of the catalogue and text.
  using Complaint =
      std::function<void(int channel, const std::string& code, const std::string& text)>;
  // Where an axis of the machine really stands.
  using AxisPosition = std::function<double(int axis)>;

  // `file` outlives it.
  SimulatedWorkpieces(const config::MachineFile& file, std::uint64_t memory_max,
                      const Complaint& complain);

  // Whether a channel has anything that could switch its probe_input: a tool of kind probe, or a
  // tool setter.
  [[nodiscard]] static bool can_probe(const config::MachineFile& file);

  // Behind each cycle.
  void observe(const channels::CycleOutput& output);

  // Before the next cycle: the inputs that are on because something touches; nullptr: no channel
  // can probe. `last`: the output that was observed last.
  [[nodiscard]] const Signals* touched(const channels::CycleOutput& last,
                                       const AxisPosition& position_of);

  [[nodiscard]] const std::vector<std::unique_ptr<ChannelFeed>>& feeds() const { return feeds_; }

 private:
  // What is known of a channel that can probe.
  struct Probing {
    bool is_known = false;
    bool touches = false;
    simulation::Sample sample;
    std::uint32_t announcements = 0;
    channels::ToolRow tool;
  };

  [[nodiscard]] bool touches(std::size_t seat, const channels::ChannelOutput& channel,
                             simulation::Sample sample, const AxisPosition& position_of);

  const config::MachineFile& file_;
  double cycle_s_;
  bool can_probe_;
  std::vector<std::unique_ptr<ChannelFeed>> feeds_;  // by channel of the machine
  std::vector<Probing> probing_;                     // likewise
  Signals inputs_;
};

}  // namespace stanok::runtime

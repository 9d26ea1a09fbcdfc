#include "runtime/workpiece/simulated_workpieces.h"

#include <algorithm>

namespace stanok::runtime {
namespace {

bool stands_as(const simulation::Sample& one, const simulation::Sample& other) {
  return one.axes_M == other.axes_M && one.scheme == other.scheme && one.tool == other.tool &&
         one.edge == other.edge;
}

}  // namespace

SimulatedWorkpieces::SimulatedWorkpieces(const config::MachineFile& file, std::uint64_t memory_max,
                                         const Complaint& complain)
    : file_(file),
      cycle_s_(file.machine.cycle_us * 1e-6),
      can_probe_(can_probe(file)),
      probing_(file.machine.channels.size()) {
  for (const channels::ChannelConfig& channel : file.machine.channels) {
    feeds_.push_back(std::make_unique<ChannelFeed>(
        file.machine, channel, memory_max,
        [complain, id = channel.id](const std::string& code, const std::string& text) {
          complain(id, code, text);
        }));
    feeds_.back()->take_real_tools(file.simulation.tools);
  }
}

bool SimulatedWorkpieces::can_probe(const config::MachineFile& file) {
  const bool has_input = std::ranges::any_of(
      file.machine.channels,
      [](const channels::ChannelConfig& channel) { return channel.probe_input >= 0; });
  const bool has_probe =
      std::ranges::any_of(file.machine.tables.tools,
                          [](const channels::ToolEdge& tool) { return tool.kind == "probe"; });
  return has_input && (has_probe || file.simulation.setter.channel > 0);
}

void SimulatedWorkpieces::observe(const channels::CycleOutput& output) {
  const double time_s = static_cast<double>(output.cycle) * cycle_s_;
  for (std::size_t k = 0; k < feeds_.size(); ++k) {
    const channels::ChannelOutput& channel = output.channels[k];
    if (channel.axis_count == 0) continue;
    feeds_[k]->take(sample_of(channel, time_s), channel.tool_row, channel.workpiece);
  }
}

const Signals* SimulatedWorkpieces::touched(const channels::CycleOutput& last,
                                            const AxisPosition& position_of) {
  if (!can_probe_) return nullptr;
  inputs_ = {};
  if (last.channel_count == 0) return &inputs_;
  for (std::size_t k = 0; k < feeds_.size(); ++k) {
    const int input = file_.machine.channels[k].probe_input;
    const channels::ChannelOutput& channel = last.channels[k];
    if (input < 0 || channel.axis_count == 0) continue;
    const simulation::Sample sample =
        sample_of(channel, static_cast<double>(last.cycle) * cycle_s_);
    if (touches(k, channel, sample, position_of)) inputs_.set(input, true);
  }
  return &inputs_;
}

// Where nothing has changed the answer is the one from before.
bool SimulatedWorkpieces::touches(std::size_t seat, const channels::ChannelOutput& channel,
                                  simulation::Sample sample, const AxisPosition& position_of) {
  const channels::ChannelConfig& config = file_.machine.channels[seat];
  for (std::size_t k = 0; k < config.axes.size(); ++k)
    sample.axes_M[k] = position_of(config.axes[k]);
  Probing& probing = probing_[seat];
  if (probing.is_known && stands_as(probing.sample, sample) && probing.tool == channel.tool_row &&
      probing.announcements == channel.workpiece.announcements)
    return probing.touches;
  const bool touched_before = probing.touches;
  probing = {.is_known = true,
             .touches = feeds_[seat]->follower().touches_workpiece(sample),
             .sample = sample,
             .announcements = channel.workpiece.announcements,
             .tool = channel.tool_row};
  // From a touch it may go back at rapid.
  if (probing.touches && !touched_before && sample.rapid)
    feeds_[seat]->follower().find_probe_at_rapid(sample);
  const config::ToolSetterConfig& setter = file_.simulation.setter;
  if (!probing.touches && setter.channel == config.id) {
    const simulation::Disc disc{.top = {setter.x, setter.y, setter.z},
                                .radius = setter.diameter / 2.0,
                                .height = setter.height};
    probing.touches = feeds_[seat]->follower().touches(sample, disc);
  }
  return probing.touches;
}

}  // namespace stanok::runtime

#include "daemon/start/assembled_machine.h"

#include <spdlog/spdlog.h>

#include "base/enum_names.h"
#include "base/place.h"

namespace stanok::daemon {
namespace {

constexpr auto drive_choice_names = enum_names<runtime::DriveChoice>({
    {runtime::DriveChoice::ideal, "ideal"},
    {runtime::DriveChoice::simulated, "simulated"},
    {runtime::DriveChoice::embedded, "embedded"},
    {runtime::DriveChoice::real, "real"},
});

// What is known of a machine of which no cycle has been: its axes are where they stood last, and no
// drive has answered.
channels::CycleOutput before_the_first_cycle(const channels::MachineConfig& machine) {
  channels::CycleOutput output;
  for (const channels::ChannelConfig& config : machine.channels) {
    channels::ChannelOutput& channel = output.channels.at(checked_size(output.channel_count++));
    channel.id = config.id;
    channel.axis_count = static_cast<std::int32_t>(config.axes.size());
    channel.scheme = config.scheme;
    channel.has_feedback = true;
    for (std::size_t k = 0; k < config.axes.size(); ++k)
      channel.axes[k].position = machine.axes[config.axes[k]].start;
  }
  return output;
}

void refuse_overtaken(std::span<const channels::OperatorEvent> events, channels::Machine& machine)
    RT_SAFE {
  for (const channels::OperatorEvent& event : events) {
    channels::OperatorReply reply;
    reply.id = event.id;
    reply.ok = false;
    reply.code = FixedText<8>("E6072");
    reply.text = FixedText<240>("a stop that was given later arrived before this command");
    machine.answer(reply);
  }
}

}  // namespace

AssembledMachine::AssembledMachine(runtime::Assembly& assembly, Recorder& recorder,
                                   std::filesystem::path program_root,
                                   std::vector<std::filesystem::path> program_roots)
    : assembly_(assembly),
      machine_(assembly.machine()),
      recorder_(recorder),
      program_root_(std::move(program_root)),
      program_roots_(std::move(program_roots)),
      newest_(before_the_first_cycle(assembly.file().machine)),
      foresight_(
          assembly.file(), program_roots_,
          [this](recording::PathPreview path) { recorder_.show_path(std::move(path)); },
          [](const std::string& obstacle) { spdlog::warn("{}", obstacle); }),
      workpieces_(assembly.file().machine,
                  [](const std::string& complaint) { spdlog::warn("{}", complaint); }) {}

void AssembledMachine::set_real_time_rights(const RealTimeRights& rights) {
  const std::lock_guard lock(mutex_);
  rights_ = rights;
}

void AssembledMachine::cycle(std::int64_t lost) RT_SAFE {
  const EventQueue::Taken taken = events_.take();
  const channels::CycleOutput& output = assembly_.late_cycle(lost, taken.events);
  newest_.put(output);
  cycles_.store(output.cycle, std::memory_order_release);
  refuse_overtaken(taken.overtaken, machine_);
}

std::optional<channels::OperatorReply> AssembledMachine::stop_reply() {
  channels::OperatorReply reply;
  if (!assembly_.machine().stop_replies().pop(reply)) return std::nullopt;
  return reply;
}

void AssembledMachine::on_output(const channels::CycleOutput& output) {
  workpieces_.observe(output);
}

LoopStatistics AssembledMachine::loop_statistics() {
  return loop_ == nullptr ? LoopStatistics{} : loop_->statistics();
}

RealTimeRights AssembledMachine::real_time_rights() {
  const std::lock_guard lock(mutex_);
  return rights_;
}

std::string AssembledMachine::drive_choice() {
  return std::string(drive_choice_names[assembly_.drives()]);
}

}  // namespace stanok::daemon

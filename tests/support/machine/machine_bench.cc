#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {

Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> MemoryFiles::read(
    std::string_view name, std::string_view from) const {
  static_cast<void>(from);
  const auto found = texts.find(std::string(name));
  if (found == texts.end()) {
    Diagnostic missing;
    missing.code = "E7001";
    missing.message = "the file was not found: " + std::string(name);
    return Unexpected<Diagnostic>(missing);
  }
  auto source = std::make_shared<lang::SourceText>();
  source->name = found->first;
  source->path = found->first;
  source->text = found->second;
  return std::shared_ptr<const lang::SourceText>(source);
}

namespace {

channels::AxisConfig linear_axis(const std::string& name) {
  channels::AxisConfig axis;
  axis.name = name;
  axis.limits.position_min = -500.0;
  axis.limits.position_max = 500.0;
  axis.limits.velocity_max = 250.0;
  axis.limits.acceleration_max = 2500.0;
  axis.limits.jerk_max = 50000.0;
  axis.limits.rapid_max = axis.limits.velocity_max;
  return axis;
}

channels::AxisConfig rotary_axis(const std::string& name) {
  channels::AxisConfig axis;
  axis.name = name;
  axis.rotary = true;
  axis.limits.linear = false;
  axis.limits.velocity_max = 120.0;
  axis.limits.acceleration_max = 1200.0;
  axis.limits.jerk_max = 24000.0;
  axis.limits.rapid_max = axis.limits.velocity_max;
  return axis;
}

kinematics::SchemeConfig cartesian_scheme(int id, std::vector<int> axes,
                                          const std::array<int, 3>& linear) {
  kinematics::SchemeConfig scheme;
  scheme.id = id;
  scheme.type = "cartesian";
  scheme.axes = std::move(axes);
  scheme.linear = linear;
  return scheme;
}

}  // namespace

channels::MachineConfig turning_machine() {
  channels::MachineConfig machine;
  machine.name = "lathe";
  machine.file = "turning.toml";
  machine.axes = {linear_axis("X"), linear_axis("Z"), rotary_axis("C1")};
  channels::SpindleConfig spindle;
  spindle.speed_max = 3000.0;
  spindle.acceleration = 1500.0;
  spindle.encoder_pulses = 1024;
  spindle.axis = "C1";
  machine.spindles = {spindle};
  channels::ChannelConfig turn;
  turn.name = "turn";
  turn.kind = lang::ChannelKind::lathe;
  turn.axes = {0, 1, 2};
  turn.words = {"X", "Z", "C"};
  turn.spindles = {1};
  turn.scheme = 1;
  turn.schemes = {cartesian_scheme(1, {0, 1, 2}, {0, -1, 1})};
  machine.channels = {turn};
  return machine;
}

channels::MachineConfig machine_with_a_shared_axis() {
  channels::MachineConfig machine;
  machine.name = "shared";
  machine.file = "shared.toml";
  machine.axes = {linear_axis("X1"), linear_axis("X2"), rotary_axis("C")};
  for (int k = 0; k < 2; ++k) {
    channels::ChannelConfig channel;
    channel.id = k + 1;
    channel.name = "side" + std::to_string(k + 1);
    channel.axes = {k, 2};
    channel.words = {"X", "C"};
    channel.scheme = 1;
    channel.schemes = {cartesian_scheme(1, {0}, {0, -1, -1}),
                       cartesian_scheme(2, {0, 1}, {0, -1, -1})};
    machine.channels.push_back(channel);
  }
  return machine;
}

channels::MachineConfig two_channel_machine() {
  channels::MachineConfig machine;
  machine.name = "bench";
  machine.file = "bench.toml";
  for (const char* name : {"X", "Y", "Z", "B", "C"}) {
    channels::AxisConfig axis;
    axis.name = name;
    axis.rotary = *name == 'B' || *name == 'C';
    axis.limits.linear = !axis.rotary;
    axis.limits.position_min = axis.rotary ? -motion::unlimited : -500.0;
    axis.limits.position_max = axis.rotary ? motion::unlimited : 500.0;
    axis.limits.velocity_max = axis.rotary ? 120.0 : 250.0;
    axis.limits.acceleration_max = axis.rotary ? 1200.0 : 2500.0;
    axis.limits.jerk_max = axis.rotary ? 24000.0 : 50000.0;
    axis.limits.rapid_max = axis.limits.velocity_max;
    machine.axes.push_back(axis);
  }
  channels::SpindleConfig spindle;
  spindle.speed_max = 18000.0;
  machine.spindles.push_back(spindle);

  channels::ChannelConfig work;
  work.id = 1;
  work.name = "work";
  work.axes = {0, 1, 2, 3, 4};
  work.words = {"X", "Y", "Z", "B", "C"};
  work.spindles = {1};
  work.scheme = 1;
  kinematics::SchemeConfig three_axes;
  three_axes.id = 1;
  three_axes.type = "cartesian";
  three_axes.axes = {0, 1, 2};
  three_axes.linear = {0, 1, 2};
  three_axes.parking = {{.axis = 3}, {.axis = 4}};
  kinematics::SchemeConfig five_axes;
  five_axes.id = 2;
  five_axes.type = "head_table";
  five_axes.axes = {0, 1, 2, 3, 4};
  five_axes.linear = {0, 1, 2};
  five_axes.geometry = kinematics::HeadTable::Geometry{
      .head_axis = 3, .table_axis = 4, .pivot_to_spindle = {0.0, 0.0, -200.0}};
  work.schemes = {three_axes, five_axes};
  channels::ChannelConfig master;
  master.id = 2;
  master.name = "master";
  master.kind = lang::ChannelKind::master;
  machine.channels = {work, master};
  return machine;
}

channels::MachineConfig machine_of_one_axis_channels(int count) {
  channels::MachineConfig machine;
  machine.name = "lanes";
  machine.file = "lanes.toml";
  for (int k = 0; k < count; ++k) {
    machine.axes.push_back(linear_axis("X" + std::to_string(k + 1)));
    channels::ChannelConfig channel;
    channel.id = k + 1;
    channel.name = "lane" + std::to_string(k + 1);
    channel.axes = {k};
    channel.words = {"X"};
    channel.scheme = 1;
    channel.schemes = {cartesian_scheme(1, {0}, {0, -1, -1})};
    machine.channels.push_back(channel);
  }
  return machine;
}

MachineBench::MachineBench(channels::MachineConfig config, const channels::MachineOptions& options)
    : config_(std::move(config)),
      machine_(std::make_unique<channels::Machine>(config_, files_, options)) {}

void MachineBench::ask(channels::OperatorAction action, int channel, const std::string& text,
                       double value, int number) {
  channels::OperatorEvent event;
  event.channel = channel;
  event.command =
      channels::command_of(
          {.action = action, .number = number, .value = value, .text = std::string_view(text)})
          .value();
  ask(event);
}

void MachineBench::ask(channels::OperatorEvent event) {
  event.id = next_id_++;
  events_.push_back(event);
}

const channels::CycleOutput& MachineBench::cycle() {
  bool worked = true;
  while (worked) {
    worked = false;
    for (int k = 0; k < static_cast<int>(config_.channels.size()); ++k) {
      while (machine_->prepare(k) != channels::Progress::blocked) worked = true;
    }
  }
  machine_->cycle({.events = events_,
                   .feedback = feedback_,
                   .signals = inputs_ ? &*inputs_ : nullptr,
                   .sensors = sensors_},
                  output_);
  events_.clear();
  channels::OperatorReply reply;
  while (machine_->replies().pop(reply)) replies_.push_back(reply);
  channels::Event event;
  while (machine_->events().pop(event)) event_codes_.emplace_back(event.code.view());
  channels::InputRecord input;
  while (machine_->input_records().pop(input)) {
  }
  return output_;
}

MachineBench::~MachineBench() {
  if (are_replies_seen_) return;
  for (const channels::OperatorReply& reply : replies_)
    EXPECT_TRUE(reply.ok) << reply.code.view() << " " << reply.text.view();
}

void MachineBench::run_to_end(const std::function<void(const channels::CycleOutput&)>& watch,
                              int cycles_max) {
  for (int n = 0; n < cycles_max; ++n) {
    const bool asked = !events_.empty();
    cycle();
    if (watch) watch(output_);
    if (!asked && machine_->waits_for_operator()) return;
  }
  ADD_FAILURE() << "the machine still works after " << cycles_max << " cycles";
}

const channels::ChannelOutput& MachineBench::channel(int id) const {
  for (const auto& candidate : output_.channels) {
    if (candidate.id == id) return candidate;
  }
  ADD_FAILURE() << "no channel " << id;
  return output_.channels[0];
}

std::vector<std::string> MachineBench::alarm_codes() const {
  std::vector<std::string> codes;
  for (const auto& alarm : machine_->alarms()) codes.push_back(alarm.diagnostic.code);
  return codes;
}

}  // namespace stanok::testing

#include "channels/machine/machine.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/place.h"
#include "channels/contract/motion_config.h"
#include "channels/coordinator/coordinator.h"
#include "channels/cycle/channel.h"
#include "channels/machine/input_watch.h"
#include "channels/preparation/preparation.h"
#include "channels/stores/change_book.h"
#include "channels/stores/input_book.h"

namespace stanok::channels {
namespace {

constexpr std::size_t events_max = 4096;
constexpr std::size_t inputs_max = 4096;
constexpr std::size_t replies_max = 256;

// A controller may ask for this much more than the fastest setpoint, to catch up with it.
constexpr double demand_reserve = 1.2;

// Index in the channel of the axis that a spindle becomes; -1: none.
int channel_axis_of(const MachineConfig& machine, const ChannelConfig& channel,
                    const SpindleConfig& spindle) {
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    const AxisConfig& axis = machine.axes[channel.axes[k]];
    if (!spindle.axis.empty() && axis.name == spindle.axis) return static_cast<int>(k);
  }
  return -1;
}

// Twice what the slowest axis or spindle of the channel takes from its highest speed, and a second.
std::int64_t stop_cycles_max(const MachineConfig& machine, const ChannelConfig& channel) {
  double slowest_s = 0.0;
  for (const int index : channel.axes) {
    const motion::AxisLimits& limits = machine.axes[index].limits;
    slowest_s = std::max(slowest_s, limits.velocity_max / limits.acceleration_max +
                                        limits.acceleration_max / limits.jerk_max);
  }
  for (const SpindleConfig& spindle : machine.spindles) {
    const bool is_its = std::ranges::find(channel.spindles, spindle.id) != channel.spindles.end();
    if (is_its && spindle.acceleration > 0.0)
      slowest_s = std::max(slowest_s, spindle.speed_max / spindle.acceleration);
  }
  const double bound_s =
      machine.stop_time_max_s > 0.0 ? machine.stop_time_max_s : 2.0 * slowest_s + 1.0;
  return std::llround(bound_s * 1e6 / machine.cycle_us);
}

ChannelConstants channel_constants(const MachineConfig& machine, const ChannelConfig& channel,
                                   const MachineOptions& options) {
  ChannelConstants constants;
  constants.id = channel.id;
  constants.axis_count = static_cast<int>(channel.axes.size());
  constants.cycle_s = machine.cycle_us * 1e-6;
  constants.stop_cycles_max = stop_cycles_max(machine, channel);
  // Nobody goes back where nobody holds a program.
  if (!channel.axes.empty() && !options.stops_go_on)
    constants.retrace_bytes = static_cast<std::size_t>(machine.retrace_memory_mb) << 20;
  constants.probe_input = channel.probe_input;
  constants.stops_go_on = options.stops_go_on;
  constants.first_run = machine.first_run && !options.stops_go_on;
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    const AxisConfig& axis = machine.axes[channel.axes[k]];
    const bool homed_at_start = options.on_at_start || axis.homing.order == 0;
    constants.axes[k] = {.codes = {axis.resolution, axis.kmv},
                         .brake_s = axis.brake_s,
                         .power_s = axis.power_s,
                         .homed_at_start = homed_at_start,
                         .name = FixedText<16>(axis.name),
                         .controller = axis.controller,
                         .demand_max = demand_reserve * axis.limits.velocity_max,
                         .manual = {.name = FixedText<16>(axis.name),
                                    .limits = axis.limits,
                                    .homing = axis.homing,
                                    .following_error_max = axis.following_error_max}};
    constants.start[k] = axis.start;
    constants.machine_axis[k] = channel.axes[k];
  }
  for (const int id : channel.spindles) {
    const auto spindle =
        std::find_if(machine.spindles.begin(), machine.spindles.end(),
                     [id](const SpindleConfig& candidate) { return candidate.id == id; });
    if (spindle == machine.spindles.end() || constants.spindle_count == spindles_max) continue;
    const int s = constants.spindle_count++;
    constants.spindles[s] = *spindle;
    constants.spindle_axis[s] = channel_axis_of(machine, channel, *spindle);
    constants.machine_spindle[s] = static_cast<int>(spindle - machine.spindles.begin());
  }
  std::copy_n(channel.automatic_feeds.begin(),
              std::min(channel.automatic_feeds.size(), constants.automatic_feeds.size()),
              constants.automatic_feeds.begin());
  const std::size_t index = checked_size(&channel - machine.channels.data());
  if (index < options.feed_modifiers.size())
    constants.feed_modifier = options.feed_modifiers[index];
  return constants;
}

// One channel whole: both sides and the rings between them.
struct Seat {
  Seat(const MachineConfig& machine, const ChannelConfig& config, const MachineOptions& options,
       const lang::Files& files, LiveTables& tables, SharedVariables& shared, CycleBooks books)
      : schemes(make_schemes(config)),
        preparation(machine, config, schemes, files,
                    {tables, shared, link, *books.reports, situations}, options.gives_up),
        channel(motion_config(machine, config), channel_constants(machine, config, options),
                schemes, config.scheme, link, books) {}

  SchemeSet schemes;
  ChannelLink link;
  SituationBook situations;
  Preparation preparation;
  Channel channel;
  RowAtWork row_at_work;
};

// What all channels, axes and sensors may change in each of the cycles that a recorder may be late.
std::size_t changes_max(const MachineConfig& machine, double kept_s) {
  if (kept_s <= 0.0) return 0;
  const double cycles = std::ceil(kept_s / (machine.cycle_us * 1e-6));
  const std::size_t often = machine.channels.size() + machine.axes.size() + machine.spindles.size();
  const std::size_t at_once = often + 2 * machine.spindles.size() + Signals::analog_count;
  return at_once + static_cast<std::size_t>(cycles) * often;
}

OwnerFailures owner_rules(const MachineConfig& config) {
  OwnerFailures rules{};
  for (std::size_t k = 0; k < config.channels.size(); ++k)
    rules.at(k) = config.channels[k].on_owner_failure;
  return rules;
}

}  // namespace

struct Machine::Parts {
  Parts(const MachineConfig& machine, const lang::Files& files, const MachineOptions& options)
      : config(machine),
        tables(machine),
        reports(options.reports_kept_max),
        events(events_max),
        inputs(inputs_max, events),
        changes(changes_max(machine, options.changes_kept_s), inputs),
        watch(machine.spindles.size(), options.outputs_to_inputs ? &signals_out : nullptr,
              {inputs, changes}),
        replies{.usual = Ring<OperatorReply>(replies_max),
                .stops = Ring<OperatorReply>(replies_max)} {
    if (machine.channels.empty() || machine.channels.size() > channels_max) {
      throw std::invalid_argument("a machine has 1 to " + std::to_string(channels_max) +
                                  " channels");
    }
    std::vector<Channel*> channels;
    for (const ChannelConfig& channel : machine.channels) {
      seats.push_back(std::make_unique<Seat>(
          machine, channel, options, files, tables, shared,
          CycleBooks{&events, &reports, &signals_out, &watch.signals(), &tables}));
      channels.push_back(&seats.back()->channel);
      if (options.on_at_start) channels.back()->power(Power::on);
    }
    coordinator = std::make_unique<Coordinator>(
        channels, owner_rules(machine),
        CoordinatorTimes{machine.cycle_us * 1e-6, machine.request_age_max_s},
        ReplyRings{replies.usual, replies.stops, replies.lost},
        MachineStores{&shared, &tables, &watch.signals()});
    for (const auto& seat : seats) settle_at_start(*seat);
  }

  // Before the first cycle, so that its output shows how the channel stands.
  static void settle_at_start(Seat& seat) {
    seat.channel.items().settling().ask_at_start(seat.channel.items().stand());
    while (seat.preparation.step() != Progress::blocked) {
    }
  }

  // What is the case behind a gap is told when its last period has been made up for.
  [[nodiscard]] Period pass_gap(const ClockGap& now) RT_SAFE {
    if (now.periods > 0) {
      inputs.note({.cycle = cycle, .content = Overrun{now.periods}});
      for (const auto& seat : seats) seat->channel.runs.note_lost_periods(now.periods);
      gap = now;
    }
    if (gap.carried > 0) {
      --gap.carried;
      return Period::made_up;
    }
    if (gap.periods > 0) {
      for (const auto& seat : seats) seat->channel.see_gap(gap);
      gap = {};
    }
    return Period::present;
  }

  // Before what was made behind them.
  void note_takings() RT_SAFE {
    for (const auto& seat : seats) {
      TableTaking taking;
      while (seat->link.takings.pop(taking))
        inputs.note({.cycle = cycle, .channel = seat->channel.id(), .content = taking});
    }
  }

  // Reports of runs and alarms that found no place.
  void tell_lost_reports() RT_SAFE {
    const std::uint64_t lost = reports.lost();
    if (lost == reports_lost) return;
    Event event;
    event.cycle = cycle;
    event.code = FixedText<8>("W722");
    event.text.append(static_cast<long>(lost - reports_lost))
        .append(" runs or alarms are missing from the history: it was not read in time");
    if (events.put(event)) reports_lost = lost;
  }

  const MachineConfig& config;
  LiveTables tables;
  SharedVariables shared;
  Signals signals_out;
  ReportBook reports;
  EventBook events;
  std::uint64_t reports_lost = 0;  // told of
  InputBook inputs;
  ChangeBook changes;
  InputWatch watch;
  struct {
    Ring<OperatorReply> usual;
    Ring<OperatorReply> stops;
    std::atomic<std::uint64_t> lost{0};
  } replies;
  NumberedList<std::unique_ptr<Seat>> seats;
  std::unique_ptr<Coordinator> coordinator;
  std::int64_t cycle = 0;
  ClockGap gap;  // that is being made up for
};

Machine::Machine(const MachineConfig& config, const lang::Files& files,
                 const MachineOptions& options)
    : parts_(std::make_unique<Parts>(config, files, options)) {}

Machine::~Machine() = default;

const MachineConfig& Machine::config() const {
  return parts_->config;
}

Progress Machine::prepare(int index) {
  return parts_->seats[index]->preparation.step();
}

Progress Machine::prepare(int index, RecordedWork& recorded) {
  Seat& seat = *parts_->seats[index];
  return seat.preparation.step(&recorded,
                               [&] { return seat.channel.window().may_prepare(recorded.known); });
}

bool Machine::is_urgent(int index) const {
  return parts_->seats[index]->preparation.is_urgent();
}

bool Machine::has_prepared(int index, const Arrivals& recorded) const {
  return parts_->seats[index]->channel.window().has_prepared(recorded);
}

bool Machine::select_scheme_at_start(int channel, int scheme) {
  for (const auto& seat : parts_->seats) {
    if (seat->channel.id() != channel || seat->channel.schemes.find(scheme) == nullptr) continue;
    seat->channel.motion.select_scheme(scheme);
    Parts::settle_at_start(*seat);
    parts_->coordinator->settle_owners();
    if (seat->channel.state().is_powered()) seat->channel.power(Power::on);
    return true;
  }
  return false;
}

void Machine::cycle(const CycleInputs& inputs, CycleOutput& output) RT_SAFE {
  Parts& parts = *parts_;
  ++parts.cycle;
  for (std::size_t k = 0; k < parts.seats.size(); ++k) {
    Channel& channel = parts.seats[k]->channel;
    k < inputs.arrivals.size() ? channel.see_arrivals(inputs.arrivals[k]) : channel.see_arrivals();
  }
  parts.note_takings();
  parts.coordinator->note_gap(parts.cycle, inputs.gap.periods - inputs.gap.carried);
  for (const OperatorEvent& event : inputs.events) {
    if (!parts.coordinator->admits(event, parts.cycle)) continue;  // no input: it has no effect
    parts.inputs.note({.cycle = parts.cycle, .channel = event.channel, .content = event.command});
    parts.coordinator->take(event);
  }
  parts.watch.take(parts.cycle, inputs.signals, inputs.sensors);
  const Period period = parts.pass_gap(inputs.gap);
  for (const auto& seat : parts.seats) {
    seat->channel.watch_drives(inputs.feedback);
    seat->channel.sense(parts.watch.sensors());
    const bool is_probe = seat->row_at_work.row().kind.view() == "probe";
    seat->channel.items().probe().see_tool(is_probe ? AtWork::probe : AtWork::other);
    seat->channel.advance(parts.cycle, period);
  }
  parts.coordinator->step();
  parts.tell_lost_reports();
  output.cycle = parts.cycle;
  output.signals = parts.signals_out;
  output.channel_count = static_cast<std::int32_t>(parts.seats.size());
  for (std::size_t k = 0; k < parts.seats.size(); ++k) {
    ChannelOutput& shown = output.channels[k];
    parts.seats[k]->channel.fill(shown);
    shown.tool_row =
        parts.seats[k]->row_at_work.of(parts.tables, shown.tool.number, shown.tool.edge);
  }
  parts.coordinator->show_owners(output);
  parts.changes.note(output);
}

bool Machine::may_carry_on() const RT_SAFE {
  bool moves = false;
  for (const auto& seat : parts_->seats) {
    if (seat->channel.looks_for_contact()) return false;
    moves = moves || !seat->channel.motion.is_standing() || seat->channel.spindles.any_turns();
  }
  return moves;
}

bool Machine::is_idle() const RT_SAFE {
  return parts_->coordinator->is_quiet() &&
         std::all_of(parts_->seats.begin(), parts_->seats.end(),
                     [](const auto& seat) RT_SAFE { return seat->channel.is_quiet(); });
}

bool Machine::waits_for_operator() const RT_SAFE {
  bool all_quiet = true;
  for (std::size_t k = 0; k < parts_->seats.size(); ++k) {
    const Channel& channel = parts_->seats[k]->channel;
    if (channel.is_quiet()) continue;
    all_quiet = false;
    if (channel.state().is_ending()) return false;
    const bool is_held =
        channel.state().shown() == ChannelState::held && channel.motion.is_standing();
    if (!is_held && !parts_->coordinator->is_waiting_for_channels(static_cast<int>(k)))
      return false;
  }
  // Between channels that are quiet the coordinator may still wait for drives.
  return !all_quiet || parts_->coordinator->is_quiet();
}

Ring<Event>& Machine::events() {
  return parts_->events.events();
}
Ring<InputRecord>& Machine::input_records() {
  return parts_->inputs.records();
}
Ring<InputChange>& Machine::input_changes() {
  return parts_->changes.changes();
}
std::uint64_t Machine::inputs_lost() const RT_SAFE {
  return parts_->inputs.lost();
}
Ring<OperatorReply>& Machine::replies() {
  return parts_->replies.usual;
}
void Machine::answer(const OperatorReply& reply) RT_SAFE {
  if (!parts_->replies.usual.push(reply))
    parts_->replies.lost.fetch_add(1, std::memory_order_relaxed);
}
std::uint64_t Machine::replies_lost() const RT_SAFE {
  return parts_->replies.lost.load(std::memory_order_relaxed);
}
Ring<OperatorReply>& Machine::stop_replies() {
  return parts_->replies.stops;
}
void Machine::recall(Past past, TimeOfCycle time_of) {
  parts_->reports.recall(std::move(past), std::move(time_of));
}

std::uint64_t Machine::note(AlarmReport alarm) {
  return parts_->reports.note(std::move(alarm));
}

std::vector<RunReport> Machine::runs() const {
  return parts_->reports.runs();
}
std::vector<AlarmReport> Machine::alarms() const {
  return parts_->reports.alarms();
}
std::optional<SearchReport> Machine::search(int channel) const {
  return parts_->reports.search(channel);
}

SituationReport Machine::situation(const ChannelOutput& shown) const {
  for (const auto& seat : parts_->seats) {
    if (seat->channel.id() == shown.id) return seat->situations.at(shown.tag);
  }
  return {};
}

std::vector<AlarmReport> Machine::load_diagnostics() const {
  return parts_->reports.load_diagnostics();
}
TablesConfig Machine::tables() const {
  return parts_->tables.snapshot();
}

}  // namespace stanok::channels

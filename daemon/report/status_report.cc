#include "daemon/report/status_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/catalogue.h"
#include "base/enum_names.h"
#include "base/place.h"
#include "base/units.h"
#include "daemon/host/daemon_log.h"
#include "daemon/journal/journal_contents.h"
#include "daemon/report/channel_display.h"
#include "daemon/report/part_json.h"
#include "daemon/report/process_status.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::daemon {
namespace {

using channels::ChannelOutput;
using channels::ChannelState;
using nlohmann::json;

// OPC 40501, channel state machine.
const char* channel_state_word(ChannelState state) {
  switch (state) {
    case ChannelState::idle:
    case ChannelState::ready:
      return "Reset";
    case ChannelState::running:
      return "Active";
    case ChannelState::held:
    case ChannelState::alarm:
      return "Interrupted";
  }
  return "";
}

// OPC 40502, program status.
const char* program_status_word(const ChannelOutput& output) {
  switch (output.state) {
    case ChannelState::idle:
    case ChannelState::ready:
      return "Stopped";
    case ChannelState::running:
      return output.waiting ? "Waiting" : "Running";
    case ChannelState::held:
      return "Interrupted";
    case ChannelState::alarm:
      return "Canceled";
  }
  return "";
}

constexpr auto channel_kind_names = enum_names<lang::ChannelKind>({
    {lang::ChannelKind::mill, "mill"},
    {lang::ChannelKind::lathe, "lathe"},
    {lang::ChannelKind::grind, "grind"},
    {lang::ChannelKind::master, "master"},
});

json percentiles_us(const Histogram& histogram) {
  const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
  return {{"p50", us(histogram.percentile(0.5))},
          {"p99", us(histogram.percentile(0.99))},
          {"p999", us(histogram.percentile(0.999))},
          {"max", us(histogram.max())}};
}

json text_or_null(const std::string& text) {
  return text.empty() ? json(nullptr) : json(text);
}

json number_or_null(int number) {
  return number == 0 ? json(nullptr) : json(number);
}

json number_or_null(const std::optional<double>& number) {
  return number ? json(*number) : json(nullptr);
}

// Of the clock of the wall.
json wall_time_or_null(double unix_s) {
  return unix_s > 0.0 ? json(unix_s) : json(nullptr);
}

// A history says how many older entries are not kept any more.
json with_forgotten(json history, std::uint64_t count) {
  if (count > 0) history["forgotten"] = count;
  return history;
}

// Where the next run begins, when that is not the first block.
json begins_at(const std::optional<channels::SearchReport>& search) {
  return search ? json(search->file + ":" + std::to_string(search->line)) : json(nullptr);
}

json words_of(const channels::ChannelConfig& config) {
  return config.words;
}

// Lowest and highest position of each axis; null for one that has no end.
json travel_of(const channels::MachineConfig& machine, const channels::ChannelConfig& config) {
  json travel = json::array();
  for (const int index : config.axes) {
    const motion::AxisLimits& limits = machine.axes[index].limits;
    const bool has_ends =
        limits.position_min > -motion::unlimited && limits.position_max < motion::unlimited;
    travel.push_back(has_ends ? json{limits.position_min, limits.position_max} : json(nullptr));
  }
  return travel;
}

json axis_names(const channels::MachineConfig& machine, const channels::ChannelConfig& config) {
  json names = json::array();
  for (const int axis : config.axes) names.push_back(machine.axes[axis].name);
  return names;
}

// Whether a drive in contact says that the position belongs to the machine. An axis that its drive
// does not hold must be where it is shown, too: it may have been moved meanwhile.
bool is_verified(const channels::AxisConfig& config, const ChannelOutput& output,
                 std::size_t axis) {
  if (!output.has_feedback) return true;
  const channels::AxisFeedback& feedback = output.feedback[axis];
  const double apart = std::abs(feedback.position - output.axes[axis].position);
  return feedback.valid && feedback.referenced &&
         (feedback.enabled || apart <= config.following_error_max);
}

// Which axes take part in the scheme with this number, bit k: axis k of the channel; all do where
// there is none.
unsigned participants_of(const channels::ChannelConfig& config, int scheme) {
  const auto at = std::find_if(config.schemes.begin(), config.schemes.end(),
                               [&](const auto& one) { return one.id == scheme; });
  if (at == config.schemes.end()) return ~0U;
  unsigned axes = 0;
  for (const int axis : at->axes) axes |= 1U << static_cast<unsigned>(axis);
  return axes;
}

json axes_json(const channels::MachineConfig& machine, const channels::ChannelConfig& config,
               const ChannelOutput& output) {
  json axes = json::object();
  const unsigned participants = participants_of(config, output.scheme);
  for (std::size_t k = 0; k < config.axes.size(); ++k) {
    const channels::AxisConfig& axis = machine.axes[config.axes[k]];
    axes[axis.name] = {{"position", output.axes[k].position},
                       {"verified", is_verified(axis, output, k)},
                       {"takes_part", (participants >> k & 1U) != 0},
                       {"enabled", output.drives[k].enabled},
                       {"brake", output.drives[k].brake_closed}};
  }
  return axes;
}

bool any_drive_enabled(const channels::CycleOutput& output) {
  for (const ChannelOutput& channel : output.of_channels()) {
    const auto end = channel.drives.begin() + channel.axis_count;
    if (std::any_of(channel.drives.begin(), end, [](const auto& d) { return d.enabled; }))
      return true;
  }
  return false;
}

bool is_at_rest(const channels::CycleOutput& output) {
  return std::ranges::none_of(output.of_channels(),
                              [](const ChannelOutput& c) { return c.moving || c.running; });
}

// The program of the current run, or of the last one; the one that is loaded else.
std::string program_of_channel(const ChannelOutput& output,
                               const std::vector<channels::RunReport>& runs,
                               const std::string& loaded) {
  if (!output.running && !loaded.empty()) return loaded;
  const auto run = std::find_if(runs.rbegin(), runs.rend(), [&](const auto& report) {
    return report.channel == output.id && report.run == output.run;
  });
  return run == runs.rend() || run->program.empty() ? loaded : run->program;
}

// Of the current line: the program, or what it calls or includes.
std::string file_of(const ChannelOutput& output, const std::vector<channels::RunReport>& runs) {
  if (!output.running || output.tag.line == 0) return {};
  const auto run = std::find_if(runs.rbegin(), runs.rend(), [&](const auto& report) {
    return report.channel == output.id && report.run == output.run;
  });
  const bool is_named = run != runs.rend() && output.tag.file < run->files.size();
  return is_named ? run->files[output.tag.file] : std::string();
}

// Of the newest cycle: how long it has been over.
std::int64_t age_ms(RunningMachine& machine) {
  return std::chrono::round<std::chrono::milliseconds>(machine.output_age()).count();
}

}  // namespace

json alarm_json(const channels::AlarmReport& alarm) {
  const CatalogueRow* row = find_in_catalogue(alarm.diagnostic.code);
  return {{"channel", alarm.channel},
          {"number", alarm.number},
          {"cycle", alarm.cycle},
          {"at", wall_time_or_null(alarm.at)},
          {"code", alarm.diagnostic.code},
          {"text", alarm.diagnostic.message},
          {"file", text_or_null(alarm.diagnostic.place.file)},
          {"line", number_or_null(alarm.diagnostic.place.line)},
          {"column", number_or_null(alarm.diagnostic.place.column)},
          {"reaction", row == nullptr ? json(nullptr) : json(static_cast<int>(row->reaction))},
          {"remedy", row == nullptr ? json(nullptr) : json(row->remedy)}};
}

const channels::ChannelConfig& config_of(const channels::MachineConfig& machine, int channel) {
  return *std::find_if(machine.channels.begin(), machine.channels.end(),
                       [&](const auto& config) { return config.id == channel; });
}

ChannelOutput output_of(const channels::CycleOutput& output, int channel) {
  if (const ChannelOutput* const found = output.of_channel(channel)) return *found;
  ChannelOutput none;
  none.id = channel;
  return none;
}

StatusReport::StatusReport(RunningMachine& machine, const NotesOfChannels& notes)
    : machine_(machine), notes_(notes) {
  const auto& config = machine.file().machine;
  for (const auto& channel : config.channels) {
    geometries_.emplace(channel.id, runtime::geometry_of(config, channel));
    part_places_.emplace(channel.id, jobs::PartPlace(config, channel));
  }
}

// From the tip of the tool into the spindle, in the base of the scheme that is active.
json StatusReport::tool_direction(const ChannelOutput& output) const {
  const auto geometry = geometries_.find(output.id);
  if (geometry == geometries_.end() || !geometry->second.has_scheme(output.scheme)) return nullptr;
  simulation::Axes axes_M{};
  for (std::size_t k = 0; k < axes_M.size(); ++k) axes_M[k] = output.axes[k].position;
  const auto axis = geometry->second.place_in(output.scheme, output.scheme, axes_M, {}).axis;
  constexpr double finest = 1e4;  // what a picture does not show is no change
  json direction = json::array();
  for (const double part : {axis.x(), axis.y(), axis.z()})
    direction.push_back(std::round(part * finest) / finest + 0.0);
  return direction;
}

// In the part system of the planned path, or else in the one that would begin now.
json StatusReport::on_part(const ChannelOutput& output, const jobs::PlannedPath* path) const {
  const auto place = part_places_.find(output.id);
  if (place == part_places_.end()) return nullptr;
  auto part = path == nullptr ? std::nullopt : path->state().part;
  if (!part) part = place->second.system_of(output);
  const auto tool = part ? place->second.tool_in(*part, output) : std::nullopt;
  if (!tool) return nullptr;
  return on_part_json(*tool, place->second.work_in(*part, output),
                      place->second.machine_in(*part, output));
}

json StatusReport::machine() const {
  const auto& config = machine_.file().machine;
  const auto output = machine_.newest_output();
  const LoopStatistics statistics = machine_.loop_statistics();
  const RealTimeRights rights = machine_.real_time_rights();
  const CycleLosses losses = machine_.losses();
  json channels = json::array();
  for (const auto& channel : config.channels) {
    const ChannelOutput of_channel = output_of(output, channel.id);
    channels.push_back({{"id", channel.id},
                        {"name", channel.name},
                        {"state", channel_state_word(of_channel.state)},
                        {"program_status", program_status_word(of_channel)}});
  }
  return {{"name", config.name},
          {"cycle_us", config.cycle_us},
          {"cycle", output.cycle},
          {"age_ms", age_ms(machine_)},
          {"machine_time_s", static_cast<double>(output.cycle) * config.cycle_us * 1e-6},
          {"on", any_drive_enabled(output)},
          {"idle", is_at_rest(output)},
          {"drives", machine_.drive_choice()},
          {"rt",
           {{"cycle_us", percentiles_us(statistics.cycle_time)},
            {"latency_us", percentiles_us(statistics.latency)},
            {"overruns", statistics.overruns},
            {"periods_skipped", statistics.periods_skipped}}},
          {"real_time",
           {{"scheduling", rights.has_fifo_scheduling ? "fifo" : "other"},
            {"memory_locked", rights.has_locked_memory},
            {"notes", rights.notes}}},
          {"outputs_lost", losses.outputs},
          {"replies_lost", losses.replies},
          {"log_lines_lost", log_lines_lost()},
          {"channels", std::move(channels)}};
}

json StatusReport::channel_list() const {
  const auto& config = machine_.file().machine;
  const auto output = machine_.newest_output();
  json list = json::array();
  for (const auto& channel : config.channels) {
    const ChannelOutput of_channel = output_of(output, channel.id);
    list.push_back({{"id", channel.id},
                    {"name", channel.name},
                    {"kind", channel_kind_names[channel.kind]},
                    {"axes", axis_names(config, channel)},
                    {"words", words_of(channel)},
                    {"travel", travel_of(config, channel)},
                    {"scheme", of_channel.scheme},
                    {"state", channel_state_word(of_channel.state)},
                    {"program_status", program_status_word(of_channel)}});
  }
  return {{"channels", std::move(list)}};
}

json StatusReport::channel(int id) const {
  const auto output = machine_.newest_output();
  return channel(config_of(machine_.file().machine, id), output_of(output, id),
                 books(output.cycle));
}

json StatusReport::channels() const {
  const auto output = machine_.newest_output();
  const Books of_machine = books(output.cycle);
  json all = json::object();
  for (const auto& config : machine_.file().machine.channels) {
    all[std::to_string(config.id)] = channel(config, output_of(output, config.id), of_machine);
  }
  return all;
}

StatusReport::Books StatusReport::books(std::int64_t cycle) const {
  return {cycle, machine_.alarms(), machine_.runs(), machine_.tables(), machine_.drive_status()};
}

json StatusReport::channel(const channels::ChannelConfig& config, const ChannelOutput& output,
                           const Books& books) const {
  const ChannelNotes notes = notes_of(config.id);
  const jobs::Outlook outlook = machine_.outlook(config.id);
  const auto path = machine_.planned_path(config.id);
  json alarm = nullptr;
  if (output.state == ChannelState::alarm) {
    const auto last = std::find_if(
        books.alarms.rbegin(), books.alarms.rend(),
        [&](const auto& report) { return report.channel == config.id && report.cycle > 0; });
    if (last != books.alarms.rend()) alarm = alarm_json(*last);
  }
  const channels::SituationReport situation = machine_.situation(output);
  const lang::Meaning& meaning = situation.meaning;
  const lang::ActiveCodes codes = codes_in_effect(meaning, output);
  return {{"id", config.id},
          {"name", config.name},
          {"words", words_of(config)},
          {"axis_names", axis_names(machine_.file().machine, config)},
          {"cycle", books.cycle},
          {"age_ms", age_ms(machine_)},
          {"state", channel_state_word(output.state)},
          {"program_status", program_status_word(output)},
          {"waits_for", wait_of(output)},
          {"single_block", notes.single_block},
          {"optional_stop", notes.optional_stop},
          {"first_part", notes.first_part},
          {"block_skip", notes.levels_skipped},
          {"work_offset", work_offset_of(lang::names_of(codes, 'G'))},
          {"coolant", coolant_of(lang::names_of(codes, 'M'))},
          {"held_by", text_or_null(std::string(channels::text_of(output.hold_cause)))},
          {"aside", output.aside},
          {"retrace", retrace_of(output.retrace)},
          {"spindles_off", output.spindles_off},
          {"coolant_off", output.coolant_off},
          {"tap_in_hole", output.tap_in_hole},
          {"controlled_by", text_or_null(notes.controlled_by)},
          {"alarm", std::move(alarm)},
          {"program", text_or_null(program_of_channel(output, books.runs, notes.program))},
          {"run", output.run},
          {"file", text_or_null(file_of(output, books.runs))},
          {"line", output.tag.line},
          {"block", output.tag.block},
          {"scheme", output.scheme},
          {"situation", situation.number},
          {"units", meaning.inches() ? "inch" : "mm"},
          {"diameter", diameters_of(config, meaning)},
          {"position", position_of(config, output, meaning)},
          {"point_W", point_of(config, output)},
          {"to_go", distance_to_go(config, output, situation)},
          {"axes", axes_json(machine_.file().machine, config, output)},
          {"feed_mm_s", output.feed_commanded},
          {"speed_mm_s", output.path_speed},
          {"feed_mm_min", output.feed_commanded * seconds_per_minute},
          {"feed_mm_rev", output.process.feed_mm_per_rev},
          {"speed_mm_min", output.path_speed * seconds_per_minute},
          {"g_codes", lang::names_of(codes, 'G')},
          {"m_codes", lang::names_of(codes, 'M')},
          {"tool", tool_at_work(output.tool, books.tables)},
          {"tool_direction", tool_direction(output)},
          {"on_part", on_part(output, path.get())},
          {"spindles", spindles_of(config, output, books.bus)},
          {"override",
           {{"feed", output.feed_override * 100.0},
            {"rapid", notes.rapid_override_percent},
            {"spindle", notes.spindle_override_percent}}},
          {"begins_at", begins_at(machine_.search(config.id))},
          {"predicted_s", number_or_null(outlook.predicted_s)},
          {"remaining_s", number_or_null(outlook.remaining_s)},
          {"queue",
           {{"programs", notes.queue.programs},
            {"started", notes.queue.is_started},
            {"version", notes.queue.version}}},
          {"planned_path", path == nullptr ? json(nullptr) : json(path->id())},
          {"foreseen", outlook.foreseen ? alarm_json(*outlook.foreseen) : json(nullptr)}};
}

json StatusReport::kinematics_list(int channel) const {
  const auto& config = config_of(machine_.file().machine, channel);
  const int active = output_of(machine_.newest_output(), channel).scheme;
  json schemes = json::array();
  for (const auto& scheme : config.schemes) {
    json axes = json::array();
    for (const int axis : scheme.axes) axes.push_back(config.words.at(checked_size(axis)));
    schemes.push_back({{"id", scheme.id},
                       {"type", scheme.type},
                       {"file", text_or_null(scheme.file)},
                       {"axes", std::move(axes)},
                       {"active", scheme.id == active}});
  }
  return {{"channel", channel}, {"schemes", std::move(schemes)}};
}

json StatusReport::kinematics(int channel) const {
  const auto& machine = machine_.file().machine;
  const auto& config = config_of(machine, channel);
  const auto output = output_of(machine_.newest_output(), channel);
  const auto scheme = std::find_if(config.schemes.begin(), config.schemes.end(),
                                   [&](const auto& s) { return s.id == output.scheme; });
  json axes = json::array();
  for (std::size_t k = 0; k < config.axes.size(); ++k) {
    const bool takes_part =
        scheme != config.schemes.end() && std::find(scheme->axes.begin(), scheme->axes.end(),
                                                    static_cast<int>(k)) != scheme->axes.end();
    axes.push_back({{"name", machine.axes[config.axes[k]].name},
                    {"takes_part", takes_part},
                    {"enabled", output.drives[k].enabled},
                    {"brake", output.drives[k].brake_closed}});
  }
  return {{"channel", channel},
          {"scheme", output.scheme},
          {"type", scheme == config.schemes.end() ? json(nullptr) : json(scheme->type)},
          {"axes", std::move(axes)}};
}

json StatusReport::process(int channel) const {
  return process_status(output_of(machine_.newest_output(), channel));
}

json StatusReport::alarms_standing(int channel) const {
  return alarm_rows(channel, AlarmChoice::active);
}

json StatusReport::alarm_history(int channel) const {
  return alarm_rows(channel, AlarmChoice::all);
}

json StatusReport::program_history(int channel) const {
  const double cycle_s = machine_.file().machine.cycle_us * 1e-6;
  const std::int64_t now = machine_.newest_output().cycle;
  json rows = json::array();
  const std::vector<channels::RunReport> runs = machine_.runs();
  for (const channels::RunReport& run : runs) {
    if (channel != 0 && run.channel != channel) continue;
    const bool has_cycles = run.run != channels::RunReport::recalled;
    const std::int64_t end = run.ended ? run.end_cycle : now;
    const double time_s = has_cycles ? static_cast<double>(end - run.start_cycle) * cycle_s
                                     : run.ended_at - run.begun_at;
    const auto outcome = run_outcome_name(run.end);
    rows.push_back({{"channel", run.channel},
                    {"number", run.number},
                    {"program", run.program},
                    {"begun_cycle", has_cycles ? json(run.start_cycle) : json(nullptr)},
                    {"ended_cycle", has_cycles && run.ended ? json(run.end_cycle) : json(nullptr)},
                    {"begun_at", wall_time_or_null(run.begun_at)},
                    {"ended_at", wall_time_or_null(run.ended_at)},
                    {"end", outcome ? json(*outcome) : json(nullptr)},
                    {"blocks", run.blocks},
                    {"time_s", time_s},
                    {"path_mm", run.path_mm},
                    {"lost_periods", run.lost.total},
                    {"longest_gap_ms", static_cast<double>(run.lost.longest) * cycle_s * 1e3},
                    {"ended", run.ended},
                    {"ok", run.ok}});
  }
  return with_forgotten({{"runs", std::move(rows)}}, channels::forgotten(runs, channel));
}

json StatusReport::alarm_rows(int channel, AlarmChoice choice) const {
  const auto output = machine_.newest_output();
  const auto alarms = machine_.alarms();
  json rows = json::array();
  for (const channels::AlarmReport& alarm : alarms) {
    if (channel != 0 && alarm.channel != channel) continue;
    if (choice == AlarmChoice::active && !is_active(alarm, output)) continue;
    json row = alarm_json(alarm);
    row["acknowledged"] =
        alarm.is_over || alarm.number <= notes_of(alarm.channel).alarms_acknowledged;
    rows.push_back(std::move(row));
  }
  return with_forgotten({{"alarms", std::move(rows)}}, channels::forgotten(alarms, channel));
}

// An alarm is active until somebody has acknowledged it, and as long as its channel is in that
// state; what a reset has cleared does not come back with the next one.
bool StatusReport::is_active(const channels::AlarmReport& alarm,
                             const channels::CycleOutput& output) const {
  const ChannelNotes notes = notes_of(alarm.channel);
  if (alarm.is_over || alarm.number <= notes.alarms_cleared) return false;
  const bool is_acknowledged = alarm.number <= notes.alarms_acknowledged;
  return !is_acknowledged || output_of(output, alarm.channel).state == ChannelState::alarm;
}

ChannelNotes StatusReport::notes_of(int channel) const {
  const auto notes = notes_.find(channel);
  return notes == notes_.end() ? ChannelNotes{} : notes->second;
}

}  // namespace stanok::daemon

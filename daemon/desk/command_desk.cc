#include "daemon/desk/command_desk.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "daemon/host/unix_time.h"
#include "daemon/report/search_report.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

constexpr auto standing_cycle_max = std::chrono::seconds(2);

// The name of the program that the command loads, or nothing.
std::optional<std::string> program_loaded_by(const channels::OperatorCommand& command) {
  namespace commands = channels::commands;
  if (const auto* load = std::get_if<commands::ProgramLoad>(&command))
    return std::string(load->program.view());
  if (const auto* run = std::get_if<commands::ProgramRun>(&command))
    return std::string(run->program.view());
  return std::nullopt;
}

bool begins_program(OperatorAction action) {
  return action == OperatorAction::program_run || action == OperatorAction::program_start;
}

bool changes_tables(OperatorAction action) {
  return action == OperatorAction::tool_set || action == OperatorAction::offset_set;
}

// Its refusal is told with a place.
bool reads_program(OperatorAction action) {
  return action == OperatorAction::program_load || action == OperatorAction::program_run ||
         action == OperatorAction::program_search || action == OperatorAction::mdi;
}

Failure failure_of(FailureKind kind, const char* code, std::string text, int channel) {
  return {kind, code, std::move(text), channel, {}};
}

// The first error of a program that was refused, with a word on the others.
Failure failure_of_load(const std::vector<channels::AlarmReport>& errors, int channel) {
  const Diagnostic& first = errors.front().diagnostic;
  std::string text = first.message;
  if (errors.size() > 1) text += " (and " + std::to_string(errors.size() - 1) + " more)";
  return {FailureKind::program_error, first.code, text, channel, first.place};
}

void note_switches(const channels::OperatorCommand& command, ChannelNotes& notes) {
  namespace commands = channels::commands;
  if (const auto* step = std::get_if<commands::SingleBlock>(&command))
    notes.single_block = step->to == channels::Switch::on;
  if (const auto* stop = std::get_if<commands::OptionalStop>(&command))
    notes.optional_stop = stop->to == channels::Switch::on;
  if (const auto* part = std::get_if<commands::FirstPart>(&command))
    notes.first_part = part->to == channels::Switch::on;
  if (const auto* skip = std::get_if<commands::BlockSkip>(&command))
    notes.levels_skipped.insert(skip->level);
  if (const auto* skip = std::get_if<commands::BlockSkipOff>(&command))
    notes.levels_skipped.erase(skip->level);
}

}  // namespace

bool acknowledges_alarms(OperatorAction action) {
  return action == OperatorAction::alarm_acknowledge || action == OperatorAction::program_reset;
}

void CommandDesk::submit(channels::OperatorEvent event, WaitFor wait, Answer answer) {
  event.id = ++last_id_;
  Pending pending{event, wait, std::move(answer), 0, jobs::runs_of(machine_.newest_output())};
  if (reads_program(event.action()))
    pending.diagnostics_before =
        channels::newest_number(machine_.load_diagnostics(), event.channel);
  if (!machine_.submit(event)) {
    return pending.answer(Unexpected<Failure>(failure_of(
        FailureKind::refused, "E9007", "there are too many requests at once", event.channel)));
  }
  pending_.emplace(event.id, std::move(pending));
}

void CommandDesk::on_reply(const channels::OperatorReply& reply) {
  auto node = pending_.extract(reply.id);
  if (node.empty()) return;  // answered already, because the cycle had stood
  Pending& pending = node.mapped();
  if (!reply.ok) return pending.answer(Unexpected<Failure>(refusal(pending, reply)));
  note_acceptance(pending.event);
  if (changes_tables(pending.event.action())) tables_have_changed_ = true;
  if (begins_program(pending.event.action())) look_again();
  if (const auto program = program_loaded_by(pending.event.command))
    machine_.foresee(pending.event.channel, *program);
  if (begins_program(pending.event.action()))
    machine_.foreseen_begins(pending.event.channel, std::move(pending.runs_before));
  if (pending.wait == WaitFor::end_of_run) {
    return await_run(pending.event.channel, std::move(pending.answer));
  }
  const auto search = pending.event.action() == OperatorAction::program_search
                          ? machine_.search(pending.event.channel)
                          : std::nullopt;
  if (!search) return pending.answer(json{{"accepted", true}});
  const channels::CycleOutput output = machine_.newest_output();
  const channels::ChannelOutput* const channel = output.of_channel(pending.event.channel);
  pending.answer(search_json(*search, channel == nullptr ? channels::ChannelOutput{} : *channel));
}

Failure CommandDesk::refusal(const Pending& pending, const channels::OperatorReply& reply) const {
  const int channel = pending.event.channel;
  if (reads_program(pending.event.action()) && reply.code.empty()) {
    std::vector<channels::AlarmReport> errors;
    for (const channels::AlarmReport& told : machine_.load_diagnostics()) {
      const bool is_ours = told.channel == channel && told.number > pending.diagnostics_before;
      if (is_ours && told.diagnostic.severity == Severity::error) errors.push_back(told);
    }
    if (!errors.empty()) return failure_of_load(errors, channel);
  }
  const std::string code(reply.code.view());
  return {FailureKind::refused, code, std::string(reply.text.view()), channel, {}};
}

void CommandDesk::note_acceptance(const channels::OperatorEvent& event) {
  const std::vector<channels::AlarmReport> alarms = machine_.alarms();
  for (const auto& channel : machine_.file().machine.channels) {
    if (event.channel != 0 && event.channel != channel.id) continue;
    ChannelNotes& notes = notes_[channel.id];
    if (auto program = program_loaded_by(event.command)) notes.program = std::move(*program);
    if (const auto* rapid = std::get_if<channels::commands::OverrideRapid>(&event.command))
      notes.rapid_override_percent = rapid->factor * 100.0;
    note_switches(event.command, notes);
    if (const auto* spindle = std::get_if<channels::commands::OverrideSpindle>(&event.command))
      notes.spindle_override_percent = spindle->factor * 100.0;
    if (acknowledges_alarms(event.action())) {
      const bool resets = event.action() == OperatorAction::program_reset;
      notes.alarms_acknowledged = channels::newest_number(alarms, channel.id);
      if (resets || !is_in_alarm(channel.id)) notes.alarms_cleared = notes.alarms_acknowledged;
    }
  }
  if (on_accepted_) on_accepted_(event);
}

bool CommandDesk::is_in_alarm(int channel) const {
  const channels::CycleOutput output = machine_.newest_output();
  const channels::ChannelOutput* const one = output.of_channel(channel);
  return one != nullptr && one->state == channels::ChannelState::alarm;
}

// Loaded programs lead elsewhere, take other times and meet other limits with other tables. Many
// values may change at once, as with tool.load.
void CommandDesk::look_again() {
  if (!std::exchange(tables_have_changed_, false)) return;
  for (const auto& [channel, notes] : notes_)
    if (!notes.program.empty()) machine_.foresee(channel, notes.program);
}

void CommandDesk::await_run(int channel, Answer answer) {
  const auto runs = machine_.runs();
  const auto last = std::find_if(runs.rbegin(), runs.rend(),
                                 [&](const auto& run) { return run.channel == channel; });
  if (last == runs.rend()) {
    return answer(Unexpected<Failure>(
        failure_of(FailureKind::internal, "", "the machine has no record of this run", channel)));
  }
  awaited_.push_back({channel, last->run, std::move(answer)});
}

void CommandDesk::tick(SteadyTime now) {
  if (tables_.look(unix_time_s())) tables_have_changed_ = true;
  look_again();
  if (!awaited_.empty()) answer_ended_runs();
  watch_cycle(now);
}

// An ended run is looked at once more at the next tick: its alarm is told right behind its end. It
// counts as ended when the newest output is behind it: who hears of the end finds the axes at it.
void CommandDesk::answer_ended_runs() {
  const auto runs = machine_.runs();
  std::vector<AwaitedRun> still_awaited;
  for (AwaitedRun& awaited : awaited_) {
    const auto run = std::find_if(runs.rbegin(), runs.rend(), [&](const auto& report) {
      return report.channel == awaited.channel && report.run == awaited.run;
    });
    const bool has_ended =
        run != runs.rend() && run->ended && machine_.newest_output().cycle >= run->end_cycle;
    if (has_ended && awaited.seen_ended) {
      awaited.answer(
          command_result(*run, machine_.alarms(), machine_.file().machine.cycle_us * 1e-6));
      continue;
    }
    awaited.seen_ended = has_ended;
    still_awaited.push_back(std::move(awaited));
  }
  awaited_ = std::move(still_awaited);
}

void CommandDesk::watch_cycle(SteadyTime now) {
  const std::int64_t cycle = machine_.cycles();
  if (cycle != newest_cycle_ || newest_cycle_seen_ == SteadyTime{}) {
    newest_cycle_ = cycle;
    newest_cycle_seen_ = now;
  }
  if (pending_.empty() || now - newest_cycle_seen_ < standing_cycle_max) return;
  // What the cycle has begun to take before it stood it answers when it goes on.
  const auto first_void = pending_.upper_bound(machine_.withdraw(last_id_));
  std::map<std::uint64_t, Pending> given_up;
  for (auto pending = first_void; pending != pending_.end();)
    given_up.insert(pending_.extract(pending++));
  for (const auto& [id, pending] : given_up) {
    pending.answer(Unexpected<Failure>(failure_of(
        FailureKind::timed_out, "E9006",
        "the machine does not answer: its real-time cycle has stopped", pending.event.channel)));
  }
}

CommandResult command_result(const channels::RunReport& run,
                             const std::vector<channels::AlarmReport>& alarms, double cycle_s) {
  if (run.ok) {
    return json{{"program", run.program},
                {"ok", true},
                {"blocks", run.blocks},
                {"path_mm", run.path_mm},
                {"time_s", static_cast<double>(run.end_cycle - run.start_cycle) * cycle_s}};
  }
  const auto alarm = std::find_if(alarms.rbegin(), alarms.rend(), [&](const auto& report) {
    return report.channel == run.channel && report.cycle >= run.start_cycle;
  });
  if (alarm == alarms.rend()) {
    return Unexpected<Failure>(failure_of(FailureKind::refused, "E9010",
                                          "the program was ended before its end", run.channel));
  }
  const Diagnostic& diagnostic = alarm->diagnostic;
  return Unexpected<Failure>(Failure{protocol::kind_of_alarm(diagnostic.code), diagnostic.code,
                                     diagnostic.message, run.channel, diagnostic.place});
}

}  // namespace stanok::daemon

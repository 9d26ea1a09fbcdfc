#include "jobs/dry_run/dry_run.h"

#include <algorithm>
#include <stdexcept>

#include "base/place.h"
#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"
#include "channels/preparation/program_requests.h"
#include "channels/preparation/search_sink.h"
#include "lang/text/limits.h"

namespace stanok::jobs {
namespace {

constexpr std::size_t diagnostics_max = 100;  // per program, as at load

const channels::ChannelConfig& channel_with_id(const channels::MachineConfig& machine, int id) {
  const auto found = std::find_if(machine.channels.begin(), machine.channels.end(),
                                  [id](const channels::ChannelConfig& c) { return c.id == id; });
  if (found == machine.channels.end()) {
    throw std::invalid_argument(machine.file + " has no channel " + std::to_string(id));
  }
  return *found;
}

bool is_table_request(lang::RequestKind kind) {
  using lang::RequestKind;
  return kind == RequestKind::tool_table_write || kind == RequestKind::tool_table_read ||
         kind == RequestKind::offset_table_write || kind == RequestKind::offset_table_read;
}

motion::Point start_of(const channels::MachineConfig& machine,
                       const channels::ChannelConfig& channel) {
  motion::Point point{};
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    point[k] = machine.axes[channel.axes[k]].start;
  }
  return point;
}

Diagnostic left_warning(const std::string& message, std::string help) {
  Diagnostic warning;
  warning.code = "W820";
  warning.severity = Severity::warning;
  warning.message = message + "; it was followed up to here";
  warning.help = {std::move(help)};
  return warning;
}

}  // namespace

DryRun::DryRun(const channels::MachineConfig& machine, int channel, int scheme,
               const lang::Files& files)
    : channel_(channel_with_id(machine, channel)),
      files_(files),
      motion_(channels::motion_config(machine, channel_)),
      description_(channels::channel_description(machine, channel_)),
      live_(machine),
      tables_(live_, machine, channel_),
      schemes_(channels::make_schemes(channel_)),
      sink_(motion_, feed_),
      feed_(machine, channel_, motion_, sink_),
      interpreter_(description_, tables_, files),
      judges_{{}, {machine, channel_}, {tables_, channel_.words}} {
  const int id = scheme < 0 ? channel_.scheme : scheme;
  const auto found = schemes_.find(id);
  if (found != schemes_.end()) scheme_ = found->second.get();
  if (scheme_ == nullptr && !channel_.axes.empty()) {
    throw std::invalid_argument("channel " + std::to_string(channel) + " has no kinematic scheme " +
                                std::to_string(id));
  }
  feed_.blocks().restart(scheme_, start_of(machine, channel_));
  if (scheme_ != nullptr) tables_.set_scheme(*scheme_);
  feed_.give_transform();
}

DryRunResult DryRun::run(const std::string& program, Reachability reachability,
                         const RecordSink& record, const RequestSink& request, RunManner manner) {
  DryRunResult result;
  if (!load(program, result.diagnostics)) return result;
  result.loaded = true;
  manner_ = std::move(manner);
  const bool is_checked = reachability == Reachability::checked;
  sink_.begin(program_, is_checked ? channels::FeedDepth::path : channels::FeedDepth::positions,
              record);
  interpreter_.start(program_, feed_.blocks().position_B());
  go_on(request, result);
  result.laws = sink_.take_laws();
  result.planes = judges_.planes.take();
  return result;
}

bool DryRun::load(const std::string& program, Diagnostics& diagnostics) {
  auto compiled = lang::compile(program, files_, &description_, diagnostics);
  if (!compiled) {
    const Diagnostics& errors = compiled.error();
    diagnostics.insert(diagnostics.end(), errors.begin(), errors.end());
    return false;
  }
  program_ = *compiled;
  feed_.set_program(program_);
  steps_max_ = description_.bounds.steps +
               std::uint64_t{lang::limits::steps_of_block} * lang::line_count(*program_);
  return true;
}

// False, with a warning, when a program that moves, waits or asks again and again takes too long to
// follow; one that only computes is ended by the interpreter (E8005).
bool DryRun::may_go_on(const lang::Command& command, Diagnostics& diagnostics) {
  interpreter_.renew_steps();
  const std::uint64_t blocks_max = description_.bounds.blocks;
  const bool has_blocks_left = blocks_max == 0 || command.block <= blocks_max;
  if (interpreter_.steps() <= steps_max_ && has_blocks_left) return true;
  const std::string begin = "the program did not come to its end within ";
  Diagnostic warning =
      has_blocks_left
          ? left_warning(
                begin + std::to_string(description_.bounds.steps / 1'000'000) + " million steps",
                "if it is to come to an end, see the loop; else raise `program_steps_max` of the "
                "machine file, or --steps")
          : left_warning(begin + std::to_string(blocks_max) + " blocks",
                         "if it is to come to an end, see the loop; else raise --limit");
  lang::put_at_block(*program_, command.origin, warning);
  diagnostics.push_back(std::move(warning));
  return false;
}

void DryRun::go_on(const RequestSink& request, DryRunResult& result) {
  follow(request, result);
  feed_.end_chain();
  if (sink_.feed_warning()) result.diagnostics.push_back(*sink_.feed_warning());
}

void DryRun::follow(const RequestSink& request, DryRunResult& result) {
  lang::Command command;
  while (result.diagnostics.size() < diagnostics_max) {
    if (manner_.gives_up && manner_.gives_up()) return;
    switch (interpreter_.next(command)) {
      case lang::Step::command:
        result.blocks = std::max(result.blocks, command.block);
        if (take(command, request, result.diagnostics) && !may_go_on(command, result.diagnostics))
          return;
        break;
      case lang::Step::working:
      case lang::Step::waiting:
      case lang::Step::stopped:
        break;
      case lang::Step::ended:
        return;
      case lang::Step::failed:
        if (!passes_fault(result.diagnostics)) return;
        break;
    }
  }
  Diagnostic warning;
  warning.code = "W213";
  warning.severity = Severity::warning;
  warning.message =
      "there may be more errors: the check ends at " + std::to_string(diagnostics_max);
  lang::put_at_block(*program_, interpreter_.origin(), warning);
  result.diagnostics.push_back(std::move(warning));
}

// Whether the run goes on behind the fault that stopped it.
bool DryRun::passes_fault(Diagnostics& diagnostics) {
  const Diagnostic& fault = interpreter_.error();
  if (judges_.sieve.is_new(fault) && judges_.sieve.lets_through(fault))
    diagnostics.push_back(fault);
  if (manner_.faults == BlockFaults::end_the_run || !judges_.sieve.may_pass()) return false;
  judges_.sieve.pass();
  const lang::Passed passed = interpreter_.pass_fault();
  if (passed == lang::Passed::unknown_position) judges_.sieve.lose_position();
  return passed != lang::Passed::no;
}

DryRunResult DryRun::run_from(const std::string& program, const Beginning& beginning,
                              const RecordSink& record, const SearchSink& found) {
  DryRunResult result;
  if (!load(program, result.diagnostics)) return result;
  const auto place = lang::find_place(*program_, beginning.target);
  if (!place) {
    result.diagnostics.push_back(place.error());
    return result;
  }
  lang::SearchCollector collector;
  const auto fault = beginning.calculation == Calculation::without
                         ? interpreter_.start_at(program_, feed_.blocks().position_B(), *place)
                         : search(*place, collector);
  if (fault) {
    result.diagnostics.push_back(*fault);
    return result;
  }
  found(collector.state(), {place->file, place->line});
  sink_.begin(program_, channels::FeedDepth::positions, record);
  go_on([](const lang::ProgramRequest&, const lang::Command&) {}, result);
  return result;
}

// Interprets up to `place`. Nothing: it is reached.
std::optional<Diagnostic> DryRun::search(const lang::StopPlace& place,
                                         lang::SearchCollector& collector) {
  interpreter_.start_search(program_, feed_.blocks().position_B(), place);
  channels::SearchSink sink(collector);
  lang::Command command;
  while (true) {
    switch (interpreter_.next(command)) {
      case lang::Step::command:
        if (const auto taken = feed_.pass(command, sink); !taken) return taken.error();
        if (const auto* request = std::get_if<lang::ProgramRequest>(&command.payload)) {
          if (auto unknown = pass_request(*request, command, collector)) return unknown;
        }
        break;
      case lang::Step::working:
      case lang::Step::waiting:
        break;
      case lang::Step::stopped:
        return std::nullopt;
      case lang::Step::failed:
        return interpreter_.error();
      case lang::Step::ended:
        return lang::ended_before(*program_, place);
    }
  }
}

// A request is not executed, tables are those of the dry run; where the program goes on with a
// value of the machine, the search ends.
std::optional<Diagnostic> DryRun::pass_request(const lang::ProgramRequest& request,
                                               const lang::Command& command,
                                               const lang::SearchCollector& collector) {
  auto answer = is_table_request(request.kind) ? std::optional(answer_of(request))
                                               : collector.answer(request);
  if (!answer) return lang::answer_is_unknown(*program_, command.origin);
  const bool own = request.kind == lang::RequestKind::kinematics && request.channel == channel_.id;
  if (own) switch_scheme(request.number);
  answer->position_B = feed_.blocks().position_B();
  answer->position_valid = true;
  interpreter_.answer(*answer);
  return std::nullopt;
}

// Whether something came of the command: time passes, and the program does not compute only. A
// block that is refused is left out; the program goes on at its end.
bool DryRun::take(const lang::Command& command, const RequestSink& request,
                  Diagnostics& diagnostics) {
  const motion::Point before = feed_.blocks().position_W();
  note_plane(command);
  auto taken = feed_.take(command);
  if (!taken) {
    if (judges_.sieve.lets_through(taken.error())) diagnostics.push_back(std::move(taken.error()));
    return feed_.blocks().position_W() != before;
  }
  if (auto advice = judges_.advice.advice(command)) {
    lang::put_at_block(*program_, command.origin, *advice);
    diagnostics.push_back(std::move(*advice));
  }
  if (const auto* wish = std::get_if<lang::ProgramRequest>(&command.payload))
    take_request(command, *wish, request);
  return taken->gives;
}

// Also of a tool that cannot be aligned since another axis ends on the way: the other position of
// the rotary axes may do.
void DryRun::note_plane(const lang::Command& command) {
  const auto* move = std::get_if<lang::Move>(&command.payload);
  if (move == nullptr || !move->aligns_tool) return;
  const lang::AxisValues from_B = feed_.blocks().position_B();
  lang::AxisValues to_B = from_B;
  for (std::size_t k = 0; k < to_B.size(); ++k) {
    if ((move->words & lang::axis_bit(k)) != 0)
      to_B[k] += move->end[k] - feed_.blocks().position_W()[k];
  }
  Place place;
  place.file = std::string(lang::file_name(*program_, command.origin.file));
  place.line = static_cast<int>(command.origin.line);
  judges_.planes.note(place, from_B, to_B);
}

void DryRun::take_request(const lang::Command& command, const lang::ProgramRequest& request,
                          const RequestSink& sink) {
  const bool own = request.kind == lang::RequestKind::kinematics && request.channel == channel_.id;
  if (own) {
    switch_scheme(request.number);
  } else {
    sink(request, command);
  }
  lang::Answer answer = answer_of(request);
  answer.probe_B = feed_.blocks().position_B();  // a probe is taken to change at the end of its way
  answer.rehearsed = true;
  answer.position_B = feed_.blocks().position_B();
  answer.position_valid = true;
  interpreter_.answer(answer);
}

// Tables are those of this run; everything else is taken for done.
lang::Answer DryRun::answer_of(const lang::ProgramRequest& request) {
  lang::Answer answer;
  answer.ok = request.kind != lang::RequestKind::program_restart;
  if (!is_table_request(request.kind)) return answer;
  const channels::Request asked = channels::table_request_of(request);
  const auto reason = channels::implausible_entry(live_, asked, channel_.axes);
  if (!reason.empty()) {
    answer.ok = false;
    answer.raises = true;
    answer.text = "E5022 " + std::string(reason.view());
    return answer;
  }
  const auto value = channels::execute_table_request(live_, asked, channel_.axes);
  tables_.advance_to(tables_.newest_version());
  answer.ok = value.has_value();
  answer.number = value.value_or(0.0);
  if (!answer.ok) answer.text = "no such entry of the tables, or a value out of range";
  return answer;
}

void DryRun::switch_scheme(int id) {
  const auto found = schemes_.find(id);
  if (found == schemes_.end()) return;
  scheme_ = found->second.get();
  feed_.pass_switch(*scheme_);
  tables_.set_scheme(*scheme_);
}

}  // namespace stanok::jobs

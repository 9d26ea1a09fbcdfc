#include "runtime/dry_run.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/overloaded.h"
#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"
#include "channels/preparation/feed_limit.h"
#include "channels/preparation/scheme_switch.h"
#include "lang/text/limits.h"

namespace stanok::runtime {
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

// What takes time or an answer of the machine, but for moves to where the axes stand.
bool gives_work(const lang::Payload& payload) {
  return std::visit(Overloaded{
                        [](const lang::Move& move) { return move.kind == lang::MoveKind::arc; },
                        [](const lang::ToolPrepare&) { return false; },
                        [](const lang::ToolLength&) { return false; },
                        [](const lang::FrameChange&) { return false; },
                        [](const lang::FeedLawChange&) { return false; },
                        [](const lang::ModalReport&) { return false; },
                        [](const auto&) { return true; },
                    },
                    payload);
}

motion::Point start_of(const channels::MachineConfig& machine,
                       const channels::ChannelConfig& channel) {
  motion::Point point{};
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    point[k] = machine.axes[static_cast<std::size_t>(channel.axes[k])].start;
  }
  return point;
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
      blocks_(machine, channel_, motion_),
      builder_(motion_),
      threads_(machine, channel_, motion_),
      interpreter_(description_, tables_, files) {
  const int id = scheme < 0 ? channel_.scheme : scheme;
  const auto found = schemes_.find(id);
  if (found != schemes_.end()) scheme_ = found->second.get();
  if (scheme_ == nullptr && !channel_.axes.empty()) {
    throw std::invalid_argument("channel " + std::to_string(channel) + " has no kinematic scheme " +
                                std::to_string(id));
  }
  blocks_.restart(scheme_, start_of(machine, channel_));
  if (scheme_ != nullptr) tables_.set_scheme(*scheme_);
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

DryRunResult DryRun::run(const std::string& program, Reachability reachability,
                         const RecordSink& record, const RequestSink& request, BlockFaults faults) {
  DryRunResult result;
  if (!load(program, result.diagnostics)) return result;
  result.loaded = true;
  faults_ = faults;
  interpreter_.start(program_, blocks_.position_B());
  go_on(reachability, record, request, result);
  result.laws = std::move(laws_);
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
  steps_max_ = description_.bounds.steps +
               std::uint64_t{lang::limits::steps_of_block} * lang::line_count(*program_);
  return true;
}

// False, with a warning, when a program that moves, waits or asks again and again takes too long to
// follow; one that only computes is ended by the interpreter (E8005).
bool DryRun::may_go_on(const lang::Command& command, const motion::Point& before,
                       Diagnostics& diagnostics) {
  if (!gives_work(command.payload) && blocks_.position_W() == before) return true;
  interpreter_.renew_steps();
  if (interpreter_.steps() <= steps_max_) return true;
  Diagnostic warning;
  warning.code = "W820";
  warning.severity = Severity::warning;
  warning.message = "the program did not come to its end within " +
                    std::to_string(description_.bounds.steps / 1'000'000) +
                    " million steps; it was followed up to here";
  warning.help = {
      "if it is to come to an end, see the loop; else raise `program_steps_max` of the "
      "machine file, or --steps"};
  lang::put_at_block(*program_, command.origin, warning);
  diagnostics.push_back(std::move(warning));
  return false;
}

void DryRun::go_on(Reachability reachability, const RecordSink& record, const RequestSink& request,
                   DryRunResult& result) {
  lang::Command command;
  while (result.diagnostics.size() < diagnostics_max) {
    const motion::Point before = blocks_.position_W();
    switch (interpreter_.next(command)) {
      case lang::Step::command:
        result.blocks = std::max(result.blocks, command.block);
        take(command, reachability, record, request, result.diagnostics);
        if (!may_go_on(command, before, result.diagnostics)) return;
        break;
      case lang::Step::working:
      case lang::Step::waiting:
      case lang::Step::stopped:
        break;
      case lang::Step::ended:
        builder_.finish();
        watch_feed(result.diagnostics);
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
  if (sieve_.is_new(fault) && sieve_.lets_through(fault)) diagnostics.push_back(fault);
  if (faults_ == BlockFaults::end_the_run || !sieve_.may_pass()) return false;
  sieve_.pass();
  const lang::Passed passed = interpreter_.pass_fault();
  if (passed == lang::Passed::unknown_position) sieve_.lose_position();
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
                         ? interpreter_.start_at(program_, blocks_.position_B(), *place)
                         : search(*place, collector);
  if (fault) {
    result.diagnostics.push_back(*fault);
    return result;
  }
  found(collector.state(), {place->file, place->line});
  go_on(Reachability::unchecked, record, [](const lang::Request&, const lang::Command&) {}, result);
  return result;
}

// Interprets up to `place`. Nothing: it is reached.
std::optional<Diagnostic> DryRun::search(const lang::StopPlace& place,
                                         lang::SearchCollector& collector) {
  interpreter_.start_search(program_, blocks_.position_B(), place);
  Diagnostics faults;
  lang::Command command;
  const auto nothing = [](const lang::Command&, const motion::PathBlock*) {};
  while (faults.empty()) {
    switch (interpreter_.next(command)) {
      case lang::Step::command:
        collector.take(command);
        if (const auto* request = std::get_if<lang::Request>(&command.payload)) {
          if (auto unknown = pass_request(*request, command, collector)) return unknown;
        } else {
          take(command, Reachability::unchecked, nothing, {}, faults);
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
  return faults.front();
}

// A request is not executed, tables are those of the dry run; where the program goes on with a
// value of the machine, the search ends.
std::optional<Diagnostic> DryRun::pass_request(const lang::Request& request,
                                               const lang::Command& command,
                                               const lang::SearchCollector& collector) {
  auto answer = is_table_request(request.kind) ? std::optional(answer_of(request))
                                               : collector.answer(request);
  if (!answer) return lang::answer_is_unknown(*program_, command.origin);
  const bool own = request.kind == lang::RequestKind::kinematics && request.channel == channel_.id;
  if (own) switch_scheme(request.number);
  answer->position_B = blocks_.position_B();
  answer->position_valid = true;
  interpreter_.answer(*answer);
  return std::nullopt;
}

void DryRun::take(const lang::Command& command, Reachability reachability, const RecordSink& record,
                  const RequestSink& request, Diagnostics& diagnostics) {
  if (const lang::Move* const move = lang::move_of(command.payload)) {
    if (const auto* synchronous = std::get_if<lang::SynchronousMove>(&command.payload)) {
      return take_synchronous(command, *synchronous, reachability, record, diagnostics);
    }
    threads_.forget();
    if (const auto* spline = std::get_if<lang::SplineMove>(&command.payload))
      return take_curve(command, *spline, reachability, record, diagnostics);
    return take_move(command, *move, reachability, record, diagnostics);
  }
  record(command, nullptr);
  if (channels::ThreadPreparation::ends_at(command.payload)) threads_.forget();
  if (const auto* spindle = std::get_if<lang::SpindleCommand>(&command.payload))
    threads_.take_spindle(*spindle);
  if (const auto* wish = std::get_if<lang::Request>(&command.payload)) {
    return take_request(command, *wish, request);
  }
  if (const auto* change = std::get_if<lang::TransformationChange>(&command.payload)) {
    if (auto refusal = blocks_.refusal(*change)) {
      lang::put_at_block(*program_, command.origin, *refusal);
      diagnostics.push_back(std::move(*refusal));
      return;
    }
  }
  if (blocks_.take_state(command.payload) && reachability == Reachability::checked) {
    threads_.forget();
    builder_.finish();
    watch_feed(diagnostics);
    builder_.restart(blocks_.position_W(), blocks_.geometry());
  }
}

// The end of a block with its words to the last bit: on a cylinder the path has lengths for
// degrees.
motion::Point DryRun::as_programmed(const lang::Move& move, const motion::PathBlock& block) const {
  motion::Point end = blocks_.programmed(block.end);
  for (std::size_t k = 0; k < end.size() && !move.machine_coordinates; ++k) {
    if ((move.words >> k & 1U) != 0) end[k] = move.end[k];
  }
  return end;
}

void DryRun::take_move(const lang::Command& command, const lang::Move& move,
                       Reachability reachability, const RecordSink& record,
                       Diagnostics& diagnostics) {
  const motion::BlockTag tag{0, command.block, command.origin.line, command.origin.file};
  const motion::Point start = blocks_.position_W();
  const double steady_speed = blocks_.steady_speed();
  const auto block = blocks_.block(move, tag);
  if (!block) return refuse(command, block.error(), diagnostics);
  motion::PathBlock programmed = *block;
  programmed.end = as_programmed(move, *block);
  record(command, &programmed);
  if (reachability == Reachability::unchecked) return;
  estimate_law(*block, steady_speed);
  if (move.is_tap) {
    if (auto refusal = channels::tap_refusal(*block, start, blocks_.geometry(), motion_))
      return skip(command, std::move(*refusal), diagnostics);
  }
  static_cast<void>(follow(*block, command, diagnostics));
}

// In the stretches that the path can hold, under one law.
void DryRun::take_curve(const lang::Command& command, const lang::SplineMove& spline,
                        Reachability reachability, const RecordSink& record,
                        Diagnostics& diagnostics) {
  const motion::BlockTag tag{0, command.block, command.origin.line, command.origin.file};
  const double steady_speed = blocks_.steady_speed();
  const auto blocks = blocks_.curve(spline, tag);
  if (!blocks) return refuse(command, blocks.error(), diagnostics);
  motion::PathBlock whole = blocks->back();
  motion::BlockProcess& process = whole.process;
  process.way_length += process.way_start - blocks->front().process.way_start;
  process.way_start = blocks->front().process.way_start;
  motion::PathBlock programmed = whole;
  programmed.end = as_programmed(spline.base, whole);
  record(command, &programmed);
  if (reachability == Reachability::unchecked) return;
  estimate_law(whole, steady_speed);
  for (const motion::PathBlock& block : *blocks) {
    if (!follow(block, command, diagnostics)) return;
  }
}

// Whether the axes can reach every pose of the block.
bool DryRun::follow(const motion::PathBlock& block, const lang::Command& command,
                    Diagnostics& diagnostics) {
  const auto pose = builder_.add(block);
  if (pose) skip(command, channels::unreachable_pose(*pose, channel_), diagnostics);
  watch_feed(diagnostics);
  return !pose;
}

// The block is not taken; the path goes on at its end.
void DryRun::skip(const lang::Command& command, Diagnostic diagnostic, Diagnostics& diagnostics) {
  refuse(command, std::move(diagnostic), diagnostics);
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

void DryRun::refuse(const lang::Command& command, Diagnostic diagnostic, Diagnostics& diagnostics) {
  lang::put_at_block(*program_, command.origin, diagnostic);
  if (sieve_.lets_through(diagnostic)) diagnostics.push_back(std::move(diagnostic));
}

// The spindle has `steady_speed` where the block begins.
void DryRun::estimate_law(const motion::PathBlock& block, double steady_speed) {
  const motion::BlockProcess& process = block.process;
  if (process.law == nullptr) return;
  const double planned = process.rev_per_min;
  const motion::LawPart part{
      .from_mm = process.way_start,
      .to_mm = process.way_start + process.way_length,
      .feed_per_s = block.feed_per_s,
      .rev_per_min = planned > 0.0 ? planned : steady_speed,
  };
  const auto estimate = motion::estimate(*process.law, part);
  if (!estimate) return;
  const motion::LawUnits& units = process.law->units();
  const bool follows_diameter = steady_speed <= 0.0 || units.speed == motion::LawSpeed::m_per_min;
  LawBlock found{.place = {},
                 .kind = process.law->kind(),
                 .units = units,
                 .way_mm = process.way_length,
                 .estimate = *estimate,
                 .time_is_least = planned > 0.0 && follows_diameter};
  found.place.file = std::string(lang::file_name(*program_, block.tag.file));
  found.place.line = static_cast<int>(block.tag.line);
  laws_.push_back(std::move(found));
}

// Looks at the pieces that are final, and takes them away.
void DryRun::watch_feed(Diagnostics& diagnostics) {
  for (const motion::PathBuilder::Built& built : builder_.built()) {
    if (feed_is_warned_of_) break;
    auto warning = channels::feed_above_limit(built.piece, motion_);
    if (!warning) continue;
    feed_is_warned_of_ = true;
    lang::put_at_block(*program_, {built.piece.tag.file, built.piece.tag.line}, *warning);
    diagnostics.push_back(std::move(*warning));
  }
  builder_.built().clear();
}

// The spindle gives the feed, and whether axes and spindle can cut it is known here. A rigid tap
// comes back.
void DryRun::take_synchronous(const lang::Command& command, const lang::SynchronousMove& move,
                              Reachability reachability, const RecordSink& record,
                              Diagnostics& diagnostics) {
  const motion::BlockTag tag{0, command.block, command.origin.line, command.origin.file};
  const motion::Point start_W = blocks_.position_W();
  if (!threads_.continues(move)) threads_.forget();
  const auto line = blocks_.thread_line(move.line, tag);
  if (!line) return refuse(command, line.error(), diagnostics);
  motion::PathBlock programmed = *line;
  programmed.end = as_programmed(move.line, *line);
  record(command, &programmed);
  if (move.kind == lang::SynchronousMove::Kind::rigid_tap) blocks_.return_to(start_W);
  if (reachability == Reachability::unchecked) return;
  if (auto refusal = threads_.add(move, *line, start_W, blocks_.geometry())) {
    threads_.forget();
    refuse(command, std::move(*refusal), diagnostics);
  }
  builder_.finish();
  watch_feed(diagnostics);
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

void DryRun::take_request(const lang::Command& command, const lang::Request& request,
                          const RequestSink& sink) {
  const bool own = request.kind == lang::RequestKind::kinematics && request.channel == channel_.id;
  if (own) {
    switch_scheme(request.number);
  } else {
    sink(request, command);
  }
  lang::Answer answer = answer_of(request);
  answer.probe_B = blocks_.position_B();  // a probe is taken to change at the end of its way
  answer.position_B = blocks_.position_B();
  answer.position_valid = true;
  interpreter_.answer(answer);
}

// Tables are those of this run; everything else is taken for done.
lang::Answer DryRun::answer_of(const lang::Request& request) {
  using lang::RequestKind;
  lang::Answer answer;
  answer.ok = request.kind != RequestKind::program_restart;
  const bool offsets = request.kind == RequestKind::offset_table_write ||
                       request.kind == RequestKind::offset_table_read;
  if (!is_table_request(request.kind)) return answer;
  channels::RequestData data;
  data.kind = request.kind;
  data.channel = request.channel;
  data.number = request.number;
  data.index = request.index;
  data.value = request.value;
  const int axis = offsets && request.index >= 0
                       ? channel_.axes[static_cast<std::size_t>(request.index)]
                       : request.index;
  const auto value = channels::execute_table_request(live_, data, axis);
  answer.ok = value.has_value();
  answer.number = value.value_or(0.0);
  if (!answer.ok) answer.text = "no such entry of the tables, or a value out of range";
  return answer;
}

void DryRun::switch_scheme(int id) {
  const auto found = schemes_.find(id);
  if (found == schemes_.end()) return;
  scheme_ = found->second.get();
  blocks_.change_scheme(scheme_, channels::axes_behind_switch(*scheme_, blocks_.axes_M()));
  tables_.set_scheme(*scheme_);
  builder_.restart(blocks_.position_W(), blocks_.geometry());
}

}  // namespace stanok::runtime

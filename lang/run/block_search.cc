#include "lang/run/block_search.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/overloaded.h"
#include "lang/program/program.h"
#include "lang/text/block_number.h"
#include "lang/text/reporter.h"

namespace stanok::lang {
namespace {

Diagnostic no_place(const Source& source, std::string message) {
  Diagnostic diagnostic;
  diagnostic.code = "E6040";
  diagnostic.message = std::move(message);
  diagnostic.place.file = source.name();
  return diagnostic;
}

std::optional<std::uint16_t> file_called(const Program& program, const std::string& name) {
  if (name.empty()) return std::uint16_t{0};
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    if (program.files[i]->source.name() == name) return static_cast<std::uint16_t>(i);
  }
  return std::nullopt;
}

// The lines that begin with N `number`.
std::vector<std::uint32_t> lines_numbered(const Source& source, int number) {
  std::vector<std::uint32_t> lines;
  const char* const text = source.text().data();
  std::uint32_t line = source.begin_line();
  for (const char* at = text + source.begin(); at != text + source.end(); ++line) {
    const std::size_t offset = source.offset_of(at);
    if (block_number(source.line_at(offset)) == number) lines.push_back(line);
    at = behind_line(at, text + source.end());
  }
  return lines;
}

Expected<std::uint32_t, Diagnostic> wanted_line(const Source& source, const SearchTarget& target) {
  if (target.line) return *target.line;
  if (target.offset) {
    if (*target.offset < source.end()) return source.line_number(*target.offset);
    return Unexpected<Diagnostic>(no_place(source, "the file is shorter than that"));
  }
  if (!target.block_number) return source.begin_line();
  const std::string number = "N" + std::to_string(*target.block_number);
  const auto lines = lines_numbered(source, *target.block_number);
  if (lines.size() == 1) return lines.front();
  if (lines.empty())
    return Unexpected<Diagnostic>(no_place(source, "the file has no block " + number));
  Diagnostic twice = no_place(source, "block " + number + " appears more than once");
  for (const std::uint32_t line : lines) {
    twice.notes.push_back({"here", source.place(source.words_of_line(line))});
  }
  return Unexpected<Diagnostic>(std::move(twice));
}

// The first line from `line` on that has code.
std::optional<std::uint32_t> line_with_code(const CompiledFile& file, std::uint32_t line) {
  std::optional<std::uint32_t> found;
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    if (file.code[i].op == Op::end_of_text) continue;
    std::uint32_t first = file.spans[i].line;
    if (file.code[i].op == Op::plain_lines) {
      const PlainLines& lines = file.plain_lines[file.code[i].operand];
      const std::uint32_t last = file.source.line_number(lines.end - 1);
      first = std::clamp(line, lines.first_line, std::max(last, lines.first_line));
    }
    if (first >= line && (!found || first < *found)) found = first;
  }
  return found;
}

const char* omission_of(RequestKind kind) {
  switch (kind) {
    case RequestKind::channel_load:
    case RequestKind::channel_start:
    case RequestKind::channel_run:
    case RequestKind::channel_wait:
    case RequestKind::channel_stop:
    case RequestKind::channel_reset:
      return "channel functions";
    case RequestKind::kinematics:
      return "switches of kinematics";
    case RequestKind::tap_out:
      return "taps that are taken out";
    case RequestKind::spindle_to_axis:
    case RequestKind::axis_to_spindle:
      return "switches between spindle and axis";
    case RequestKind::tool_table_write:
    case RequestKind::offset_table_write:
      return "table writes";
    case RequestKind::shared_write:
    case RequestKind::shared_combine:
      return "shared variables";
    default:
      return nullptr;
  }
}

constexpr int longest_number = 9;  // digits

std::optional<int> number_of(std::string_view digits) {
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc() && end == digits.data() + digits.size();
  if (!is_number || number < 0 || digits.size() > longest_number) return std::nullopt;
  return number;
}

}  // namespace

std::optional<SearchTarget> search_target(std::string_view text) {
  SearchTarget target;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    target.file = text.substr(0, colon);
    text.remove_prefix(colon + 1);
    if (target.file.empty()) return std::nullopt;
  }
  const bool is_block = text.starts_with('N') || text.starts_with('n');
  const auto number = number_of(is_block ? text.substr(1) : text);
  if (!number || (!is_block && *number == 0)) return std::nullopt;
  if (is_block) {
    target.block_number = number;
  } else {
    target.line = static_cast<std::uint32_t>(*number);
  }
  return target;
}

Expected<StopPlace, Diagnostic> find_place(const Program& program, const SearchTarget& target) {
  const auto file = file_called(program, target.file);
  if (!file) {
    return Unexpected<Diagnostic>(
        no_place(program.files[0]->source, "the program has no file \"" + target.file + "\""));
  }
  const CompiledFile& compiled = *program.files[*file];
  const auto wanted = wanted_line(compiled.source, target);
  if (!wanted) return Unexpected<Diagnostic>(wanted.error());
  const auto line = line_with_code(compiled, *wanted);
  if (!line) {
    return Unexpected<Diagnostic>(no_place(
        compiled.source, "nothing is executed at or after line " + std::to_string(*wanted)));
  }
  return StopPlace{*file, *line, target.calls, target.passes};
}

std::optional<Answer> SearchCollector::answer(const ProgramRequest& request) const {
  switch (request.kind) {
    case RequestKind::sync:
    case RequestKind::mark_wait:
      return Answer{};
    default:
      // A statement does not use the value; an expression would.
      if (omission_of(request.kind) == nullptr) return std::nullopt;
      const bool asks_for_value =
          request.kind >= RequestKind::channel_load && request.kind <= RequestKind::channel_reset;
      if (asks_for_value && !request.statement) return std::nullopt;
      return Answer{};
  }
}

void SearchCollector::omit(const std::string& what, const Origin& origin) {
  auto& list = state_.omissions;
  const auto known = std::find_if(list.begin(), list.end(),
                                  [&](const auto& omission) { return omission.what == what; });
  if (known != list.end()) {
    ++known->count;
  } else {
    list.push_back({what, 1, origin});
  }
}

void SearchCollector::take(const Command& command) {
  state_.calculated = true;
  if (const Move* const move = move_of(command.payload)) {
    if (!move->machine_coordinates) state_.position_W = move->end;
  }
  const auto omitted = [&](const char* what) { omit(what, command.origin); };
  std::visit(Overloaded{
                 [&](const SpindleCommand& spindle) { take(spindle); },
                 [&](const CuttingSpeedMode& mode) { state_.cutting_speeds[mode.spindle] = mode; },
                 [&](const OverrideControl& control) { state_.overrides = control; },
                 [&](const ForceControl& order) { take(order); },
                 [&](const CoolantCommand& coolant) { state_.coolant = coolant; },
                 [&](const FeedLawChange& change) {
                   if (!change.of_next_block) state_.feed_law = change.law;
                 },
                 [&](const ToolPrepare& prepare) { state_.tool_prepared = prepare.tool; },
                 [&](const ToolChange& change) {
                   state_.tool = change.tool;
                   state_.tool_changed = true;
                 },
                 [&](const ToolLength& length) { state_.length = length; },
                 [&](const FrameChange& frame) { state_.frame = frame; },
                 [&](const OutputCommand&) { omitted("outputs"); },
                 [&](const MachineFunction&) { omitted("machine functions"); },
                 [&](const MarkCommand&) { omitted("marks"); },
                 [&](const Message&) { omitted("messages"); },
                 [&](const ProgramStop&) { omitted("program stops"); },
                 [&](const SynchronousMove&) { omitted("threads"); },
                 [&](const ProbeMove&) { omitted("probing moves"); },
                 [&](const ProgramRequest& request) { take(request, command.origin); },
                 [](const auto&) {},
             },
             command.payload);
}

void SearchCollector::take(const SpindleCommand& command) {
  if (command.action == SpindleAction::set_speed) {
    state_.speeds[command.spindle] = command.speed_rev_per_min;
  } else {
    state_.spindles[command.spindle] = command;
  }
}

void SearchCollector::take(const ForceControl& order) {
  if (order.kind == ForceControl::Kind::off) return state_.force_commands.clear();
  std::erase_if(state_.force_commands, [&](const auto& old) { return old.kind == order.kind; });
  state_.force_commands.push_back(order);
}

void SearchCollector::take(const ProgramRequest& request, const Origin& origin) {
  if (const char* const what = omission_of(request.kind)) omit(what, origin);
  if (request.kind == RequestKind::spindle_to_axis) state_.spindles_as_axes.insert(request.number);
  if (request.kind == RequestKind::axis_to_spindle) state_.spindles_as_axes.erase(request.number);
}

Diagnostic answer_is_unknown(const Program& program, const Origin& origin) {
  Diagnostic unknown;
  unknown.code = "E6041";
  unknown.message = "the search ends here: the answer of the machine is not known";
  put_at_block(program, origin, unknown);
  return unknown;
}

Diagnostic ended_before(const Program& program, const StopPlace& place) {
  Diagnostic end;
  end.code = "E6041";
  end.message = "the program ends before line " + std::to_string(place.line) + " is reached";
  end.place.file = std::string(file_name(program, place.file));
  return end;
}

}  // namespace stanok::lang

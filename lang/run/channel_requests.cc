#include "lang/run/channel_requests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/block/mode_exclusion.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr int terminate_code_min = 1000;
constexpr int terminate_code_max = 9999;

}  // namespace

bool ChannelRequests::execute(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::request:
      ask_builtin(instruction);
      return true;
    case Op::request_value:
      ask_value(instruction);
      return true;
    case Op::kinematics:
      ask_kinematics();
      return true;
    case Op::terminate:
      terminate();
      return true;
    case Op::table:
      ask_table(instruction);
      return true;
    case Op::read_shared:
      read_shared(instruction);
      return true;
    case Op::write_shared:
    case Op::combine_shared:
      send_shared(instruction);
      return true;
    case Op::mark:
      take_mark(instruction);
      return true;
    default:
      return false;
  }
}

void ChannelRequests::ask(ProgramRequest request) {
  state_.begin_commands(vm_.instruction_origin());
  state_.queue.emit(std::move(request));
}

void ChannelRequests::ask(ProgramRequest request, AnswerUse use) {
  pending_.expect(use);
  ask(std::move(request));
}

// The channel a call names; it must exist.
std::optional<int> ChannelRequests::channel_of(double number, OwnChannel own) {
  if (!is_integer(number)) {
    vm_.fail("E3010", "a channel number must be whole", "not a channel");
    return std::nullopt;
  }
  const int id = static_cast<int>(std::lround(number));
  const std::vector<int>& channels = state_.channel.channels;
  if (std::find(channels.begin(), channels.end(), id) == channels.end()) {
    vm_.fail("E6001", "there is no channel " + std::to_string(id), "unknown channel");
    return std::nullopt;
  }
  if (own == OwnChannel::refused && id == state_.channel.id) {
    vm_.fail("E6031", "this function cannot name its own channel",
             "this is the program's own channel");
    return std::nullopt;
  }
  return id;
}

std::optional<int> ChannelRequests::mark_of(double number) {
  if (is_integer(number) && number >= 0.0 && number <= mark_max) {
    return static_cast<int>(std::lround(number));
  }
  vm_.fail("E6023", "marks are the whole numbers 0 to 199", "not a mark");
  return std::nullopt;
}

void ChannelRequests::ask_builtin(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  ProgramRequest request;
  request.kind = builtin.request;
  request.text = builtin.request_text;
  request.statement = instruction.extra != 0;
  if (!name_arguments(builtin, instruction, request)) return;
  vm_.stack().cut_to(vm_.stack().height() - instruction.count);
  if (request.statement) {
    pending_.expect_statement({builtin.failure_code, builtin.name});
  } else if (builtin.result == Type::number || builtin.request == RequestKind::mark_state) {
    pending_.expect_number(1.0);
  } else {
    pending_.expect(builtin.result == Type::boolean ? AnswerUse::push_truth
                                                    : AnswerUse::position_only);
  }
  ask(std::move(request));
}

bool ChannelRequests::name_arguments(const Builtin& builtin, const Instruction& instruction,
                                     ProgramRequest& request) {
  const std::span<const Value> arguments = vm_.stack().top(instruction.count);
  if (builtin.takes_channel) {
    const OwnChannel own = builtin.refuses_own_channel ? OwnChannel::refused : OwnChannel::allowed;
    const auto channel = channel_of(arguments[0].number, own);
    if (!channel) return false;
    request.channel = *channel;
  }
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (builtin.arguments[i] == 's') request.text = text_of(arguments[i]);
    if (builtin.request == RequestKind::channel_wait) request.seconds = arguments[i].number;
    if (builtin.request != RequestKind::mark_state) continue;
    const auto mark = mark_of(arguments[i].number);
    if (!mark) return false;
    request.number = *mark;
  }
  return true;
}

void ChannelRequests::ask_value(const Instruction& instruction) {
  const SystemVariable& variable = system_variables()[instruction.operand];
  ProgramRequest request;
  request.kind = RequestKind::machine_value;
  request.text = variable.name;
  if (instruction.count != 0) {
    const auto index = vm_.pop_integer("the index");
    if (!index) return;
    request.index = *index;
  }
  pending_.expect_number(1.0);
  ask(std::move(request));
}

// What would mean something else under another scheme must be off.
bool ChannelRequests::check_own_kinematics() {
  const auto mode =
      active_mode(state_.modal, {Exclusion::tcp, Exclusion::transformation, Exclusion::rotation,
                                 Exclusion::drilling_cycle, Exclusion::carried_offset});
  if (!mode) return true;
  Diagnostic diagnostic =
      vm_.diagnostic("E5011", "the kinematic scheme cannot change while " + std::string(mode->name),
                     "not in this mode");
  diagnostic.notes.push_back(mode->set_by);
  diagnostic.help.emplace_back(mode->remedy);
  vm_.fail_with(std::move(diagnostic));
  return false;
}

void ChannelRequests::ask_kinematics() {
  const double channel_number = vm_.stack().pop_number();
  const auto scheme = vm_.pop_integer("the kinematic scheme");
  if (!scheme) return;
  const auto channel = channel_of(channel_number, OwnChannel::allowed);
  if (!channel) return;
  if (*channel == state_.channel.id && !check_own_kinematics()) return;
  ProgramRequest request;
  request.kind = RequestKind::kinematics;
  request.channel = *channel;
  request.number = *scheme;
  ask(std::move(request), AnswerUse::position_only);
}

// The channel is told first; with its answer the run has failed with the code of the program.
void ChannelRequests::terminate() {
  const Value text = vm_.stack().pop();
  const auto code = vm_.pop_integer("the code of terminate");
  if (!code) return;
  if (*code < terminate_code_min || *code > terminate_code_max) {
    return vm_.fail("E3009", "the code of terminate must be from 1000 to 9999", "out of range");
  }
  pending_.expect_end(
      vm_.diagnostic("U" + std::to_string(*code), text_of(text), "terminated by the program"));
  ProgramRequest request;
  request.kind = RequestKind::terminate;
  request.number = *code;
  request.text = text_of(text);
  ask(std::move(request));
}

// mark_wait asks the channel; the others travel in the queue. mark_clear is a sync point besides.
void ChannelRequests::take_mark(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  const std::span<const Value> arguments = vm_.stack().top(instruction.count);
  const auto id = mark_of(arguments[0].number);
  if (!id) return;
  std::uint32_t channels = std::uint32_t{1} << state_.channel.id;
  for (const Value& argument : arguments.subspan(1)) {
    const auto channel = channel_of(argument.number, OwnChannel::allowed);
    if (!channel) return;
    channels |= std::uint32_t{1} << *channel;
  }
  vm_.stack().cut_to(vm_.stack().height() - instruction.count);
  if (builtin.effect == Effect::mark_wait) {
    ProgramRequest request;
    request.kind = RequestKind::mark_wait;
    request.number = *id;
    request.channels = channels;
    return ask(std::move(request), AnswerUse::position_only);
  }
  state_.begin_commands(vm_.instruction_origin());
  state_.queue.emit(MarkCommand{builtin.mark, *id, channels});
  if (builtin.mark == MarkCommand::Kind::clear) ask({}, AnswerUse::position_only);
}

}  // namespace stanok::lang

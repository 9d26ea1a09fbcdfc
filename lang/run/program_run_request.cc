// What a run asks of its channel.
#include <algorithm>
#include <utility>

#include "lang/run/program_run.h"
#include "lang/text/number.h"
#include "lang/text/reporter.h"

namespace stanok::lang {
namespace {

constexpr int terminate_code_min = 1000;
constexpr int terminate_code_max = 9999;

}  // namespace

void ProgramRun::ask(Request request, AnswerUse use) {
  queue_.set_origin({frames_.back().file, span().line}, block_);
  answer_use_ = use;
  queue_.emit(std::move(request));
}

// The channel a call names: it must exist and, where `refuse_own`, not be the own one.
std::optional<int> ProgramRun::channel_of(double number, bool refuse_own) {
  if (!is_integer(number)) {
    fail("E3010", "a channel id is a whole number", "not a channel");
    return std::nullopt;
  }
  const int id = static_cast<int>(std::lround(number));
  if (std::find(channel_.channels.begin(), channel_.channels.end(), id) ==
      channel_.channels.end()) {
    fail("E6001", "there is no channel " + std::to_string(id), "unknown channel");
    return std::nullopt;
  }
  if (refuse_own && id == channel_.id) {
    fail("E6031", "this function cannot name the own channel", "this is the own channel");
    return std::nullopt;
  }
  return id;
}

void ProgramRun::ask_builtin(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  const std::size_t first = stack_.size() - instruction.count;
  Request request;
  request.kind = builtin.request;
  request.text = builtin.request_text;
  request.statement = instruction.extra != 0;
  if (builtin.takes_channel) {
    const auto channel = channel_of(stack_[first].number, builtin.refuses_own_channel);
    if (!channel) return;
    request.channel = *channel;
  }
  for (std::size_t i = 1; i < instruction.count; ++i) {
    if (builtin.arguments[i] == 's') request.text = text_of(stack_[first + i]);
    if (builtin.request == RequestKind::channel_wait) request.seconds = stack_[first + i].number;
    if (builtin.request == RequestKind::mark_state) {
      const auto mark = mark_of(stack_[first + i].number);
      if (!mark) return;
      request.number = *mark;
    }
  }
  stack_.resize(first);
  AnswerUse use = AnswerUse::position_only;
  if (builtin.result == Type::boolean) use = AnswerUse::push_truth;
  if (builtin.request == RequestKind::mark_state) use = AnswerUse::push_number;
  if (builtin.result == Type::number) use = AnswerUse::push_number;
  if (request.statement) {
    use = AnswerUse::statement;
    statement_code_ = builtin.failure_code;
    statement_name_ = builtin.name;
  }
  ask(std::move(request), use);
}

void ProgramRun::ask_value(const Instruction& instruction) {
  const SystemVariable& variable = system_variables()[instruction.operand];
  Request request;
  request.kind = RequestKind::machine_value;
  request.text = variable.name;
  if (instruction.count != 0) {
    const auto index = pop_integer("the index");
    if (!index) return;
    request.index = *index;
  }
  ask(std::move(request), AnswerUse::push_number);
}

// What would mean something else under another scheme must be off.
bool ProgramRun::check_own_kinematics() {
  const auto mode = active_mode(modal_, {Exclusion::tip_control, Exclusion::transformation,
                                         Exclusion::rotation, Exclusion::drilling_cycle});
  if (!mode) return true;
  Diagnostic diagnostic = diagnostic_at(
      file().source, "E5011", span(),
      "the kinematic scheme cannot change while " + std::string(mode->name), "not in this mode");
  diagnostic.notes.push_back(mode->set_by);
  diagnostic.help.emplace_back(mode->remedy);
  fail_with(std::move(diagnostic));
  return false;
}

void ProgramRun::ask_kinematics() {
  const double channel_number = pop_number();
  const auto scheme = pop_integer("the kinematic scheme");
  if (!scheme) return;
  const auto channel = channel_of(channel_number, false);
  if (!channel) return;
  if (*channel == channel_.id && !check_own_kinematics()) return;
  Request request;
  request.kind = RequestKind::kinematics;
  request.channel = *channel;
  request.number = *scheme;
  ask(std::move(request), AnswerUse::position_only);
}

// The channel is told first; with its answer the run has failed with the code of the program.
void ProgramRun::terminate() {
  const Value text = pop();
  const auto code = pop_integer("the code of terminate");
  if (!code) return;
  if (*code < terminate_code_min || *code > terminate_code_max) {
    return fail("E3009", "the code of terminate lies between 1000 and 9999", "out of range");
  }
  error_after_answer_ = diagnostic_at(file().source, "U" + std::to_string(*code), span(),
                                      text_of(text), "terminated by the program");
  error_after_answer_.stack = call_stack();
  Request request;
  request.kind = RequestKind::terminate;
  request.number = *code;
  request.text = text_of(text);
  ask(std::move(request), AnswerUse::fail_run);
}

}  // namespace stanok::lang

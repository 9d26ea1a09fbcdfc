// Work offsets and tools of the machine's tables, read and written by programs.
#include <cmath>
#include <utility>

#include "lang/block/tool_value.h"
#include "lang/run/program_run.h"
#include "lang/text/number.h"

namespace stanok::lang {
// Table, page and axis; an axis the channel has not is -1.
bool ProgramRun::name_offset(std::size_t first, Request& request) {
  if (!is_integer(stack_[first].number) || !is_integer(stack_[first + 1].number)) {
    fail("E3010", "table and page are whole numbers", "not a whole number");
    return false;
  }
  request.channel = static_cast<int>(std::lround(stack_[first].number));
  request.number = static_cast<int>(std::lround(stack_[first + 1].number));
  request.index = channel_words_.axis_called(text_of(stack_[first + 2]));
  const bool is_length =
      request.index >= 0 && !channel_.axes[static_cast<std::size_t>(request.index)].rotary;
  answer_unit_ = is_length && modal_.inches() ? mm_per_inch : 1.0;
  return true;
}

// Tool, edge and value; a value that does not exist is 0.
bool ProgramRun::name_tool_value(std::size_t first, bool by_number, Request& request) {
  if (!is_integer(stack_[first].number) || !is_integer(stack_[first + 1].number)) {
    fail("E3010", "tool and edge are whole numbers", "not a whole number");
    return false;
  }
  request.number = static_cast<int>(std::lround(stack_[first].number));
  request.index = static_cast<int>(std::lround(stack_[first + 1].number));
  const Value& name = stack_[first + 2];
  int value = 0;
  if (by_number && is_integer(name.number)) value = static_cast<int>(std::lround(name.number));
  if (!by_number) value = tool_value_number(folded(text_of(name)));
  request.channel = value;
  const bool is_length = value >= 1 && value <= tool_lengths;
  answer_unit_ = is_length && modal_.inches() ? mm_per_inch : 1.0;
  return true;
}

void ProgramRun::ask_table(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  const std::size_t first = stack_.size() - instruction.count;
  Request request;
  request.kind = builtin.request;
  request.statement = (instruction.extra & 1U) != 0;
  const bool offsets = builtin.request == RequestKind::offset_table_write ||
                       builtin.request == RequestKind::offset_table_read;
  const bool good = offsets ? name_offset(first, request)
                            : name_tool_value(first, (instruction.extra & 2U) != 0, request);
  if (!good) return;
  if (builtin.result == Type::number) {
    stack_.resize(first);
    return ask(std::move(request), AnswerUse::push_number);
  }
  request.value = stack_[first + 3].number * std::exchange(answer_unit_, 1.0);
  stack_.resize(first);
  AnswerUse use = AnswerUse::push_truth;
  if (request.statement) {
    use = AnswerUse::statement;
    statement_code_ = builtin.failure_code;
    statement_name_ = builtin.name;
  }
  ask(std::move(request), use);
}

}  // namespace stanok::lang

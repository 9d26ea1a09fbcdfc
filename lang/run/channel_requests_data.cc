// Work offsets and tools of the machine's tables, and shared variables. Each read and write of
// these is asked from the machine, so that text order is real order.
#include <cmath>
#include <utility>

#include "lang/block/tool_value.h"
#include "lang/run/channel_requests.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr std::size_t shared_text_max = 255;

}  // namespace

// Table, page and axis; "R" is the rotation, an axis the channel has not is -1.
bool ChannelRequests::name_offset(std::span<const Value> arguments, ProgramRequest& request,
                                  double& unit) {
  if (!is_integer(arguments[0].number) || !is_integer(arguments[1].number)) {
    vm_.fail("E3010", "table and page are whole numbers", "not a whole number");
    return false;
  }
  request.channel = static_cast<int>(std::lround(arguments[0].number));
  request.number = static_cast<int>(std::lround(arguments[1].number));
  const std::string_view axis = text_of(arguments[2]);
  request.index = state_.channel_words.axis_called(axis).number();
  if (request.index < 0 && folded(axis) == "r") request.index = rotation_of_offset;
  const bool is_length = request.index >= 0 && !state_.channel.axes[request.index].rotary;
  unit = is_length ? state_.length_unit() : 1.0;
  return true;
}

// Tool, edge and value; a value that does not exist is 0.
bool ChannelRequests::name_tool_value(const Instruction& instruction,
                                      std::span<const Value> arguments, ProgramRequest& request,
                                      double& unit) {
  if (!is_integer(arguments[0].number) || !is_integer(arguments[1].number)) {
    vm_.fail("E3010", "tool and edge are whole numbers", "not a whole number");
    return false;
  }
  request.number = static_cast<int>(std::lround(arguments[0].number));
  request.index = static_cast<int>(std::lround(arguments[1].number));
  const Value& name = arguments[2];
  const bool by_number = (instruction.extra & 2U) != 0;
  int value = 0;
  if (by_number && is_integer(name.number)) value = static_cast<int>(std::lround(name.number));
  if (!by_number) value = tool_value_number(folded(text_of(name)));
  request.channel = value;
  const bool is_length = value >= 1 && is_tool_length(value);
  unit = is_length ? state_.length_unit() : 1.0;
  return true;
}

void ChannelRequests::ask_table(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  const std::span<const Value> arguments = vm_.stack().top(instruction.count);
  ProgramRequest request;
  request.kind = builtin.request;
  request.statement = (instruction.extra & 1U) != 0;
  const bool offsets = builtin.request == RequestKind::offset_table_write ||
                       builtin.request == RequestKind::offset_table_read;
  double unit = 1.0;
  const bool good = offsets ? name_offset(arguments, request, unit)
                            : name_tool_value(instruction, arguments, request, unit);
  if (!good) return;
  if (builtin.result == Type::number) {
    pending_.expect_number(unit);
  } else {
    request.value = arguments[3].number * unit;
    if (request.statement) {
      pending_.expect_statement({builtin.failure_code, builtin.name});
    } else {
      pending_.expect(AnswerUse::push_truth);
    }
  }
  vm_.stack().cut_to(vm_.stack().height() - instruction.count);
  ask(std::move(request));
}

bool ChannelRequests::pop_shared_element(const Instruction& instruction, ProgramRequest& request) {
  const SharedVariable& variable = vm_.file().shared[instruction.operand];
  double index[2] = {0.0, 0.0};
  for (std::size_t i = instruction.count; i-- > 0;) index[i] = vm_.stack().pop_number();
  const double limits[2] = {static_cast<double>(variable.rows),
                            static_cast<double>(variable.columns)};
  for (std::size_t i = 0; i < instruction.count; ++i) {
    if (is_integer(index[i]) && index[i] > -0.5 && index[i] < limits[i] - 0.5) continue;
    vm_.fail("E3011", "index outside the array `" + variable.name + "`",
             "valid indices are 0 to " + std::to_string(std::lround(limits[i]) - 1));
    return false;
  }
  const long columns = variable.columns == 0 ? 1 : static_cast<long>(variable.columns);
  request.text = variable.name;
  request.index = static_cast<int>(std::lround(index[0]) * columns + std::lround(index[1]));
  return true;
}

void ChannelRequests::read_shared(const Instruction& instruction) {
  ProgramRequest request;
  request.kind = RequestKind::shared_read;
  if (!pop_shared_element(instruction, request)) return;
  if (vm_.file().shared[instruction.operand].is_text) {
    pending_.expect(AnswerUse::push_text);
  } else {
    pending_.expect_number(1.0);
  }
  ask(std::move(request));
}

// A combination is one request, so that no other channel comes between the reading and the writing.
void ChannelRequests::send_shared(const Instruction& instruction) {
  ProgramRequest request;
  request.kind = RequestKind::shared_write;
  if (instruction.op == Op::combine_shared) {
    request.kind = RequestKind::shared_combine;
    request.combination = static_cast<Combination>(instruction.extra);
  }
  const Value value = vm_.stack().pop();
  request.value = value.number;
  request.value_text = text_of(value);
  if (request.value_text.size() > shared_text_max) {
    return vm_.fail("E3009", "a shared string has at most 255 bytes", "too long");
  }
  if (pop_shared_element(instruction, request)) ask(std::move(request), AnswerUse::position_only);
}

}  // namespace stanok::lang

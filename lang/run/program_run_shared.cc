// Shared variables: each read and write is asked from the machine, so that text order is real
// order.
#include <cmath>
#include <utility>

#include "lang/run/program_run.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr std::size_t shared_text_max = 255;

}  // namespace

bool ProgramRun::pop_shared_element(const Instruction& instruction, Request& request) {
  const SharedVariable& variable = file().shared[instruction.operand];
  double index[2] = {0.0, 0.0};
  for (std::size_t i = instruction.count; i-- > 0;) index[i] = pop_number();
  const double limits[2] = {static_cast<double>(variable.rows),
                            static_cast<double>(variable.columns)};
  for (std::size_t i = 0; i < instruction.count; ++i) {
    if (is_integer(index[i]) && index[i] > -0.5 && index[i] < limits[i] - 0.5) continue;
    fail("E3011", "index outside the array `" + variable.name + "`",
         "valid are 0 to " + std::to_string(std::lround(limits[i]) - 1));
    return false;
  }
  const long columns = variable.columns == 0 ? 1 : static_cast<long>(variable.columns);
  request.text = variable.name;
  request.index = static_cast<int>(std::lround(index[0]) * columns + std::lround(index[1]));
  return true;
}

void ProgramRun::read_shared(const Instruction& instruction) {
  Request request;
  request.kind = RequestKind::shared_read;
  if (!pop_shared_element(instruction, request)) return;
  const bool is_text = file().shared[instruction.operand].is_text;
  ask(std::move(request), is_text ? AnswerUse::push_text : AnswerUse::push_number);
}

void ProgramRun::write_shared(const Instruction& instruction) {
  Request request;
  request.kind = RequestKind::shared_write;
  send_shared(instruction, std::move(request));
}

// One request, so that no other channel comes between the reading and the writing.
void ProgramRun::combine_shared(const Instruction& instruction) {
  Request request;
  request.kind = RequestKind::shared_combine;
  request.combination = static_cast<Combination>(instruction.extra);
  send_shared(instruction, std::move(request));
}

void ProgramRun::send_shared(const Instruction& instruction, Request request) {
  const Value value = pop();
  request.value = value.number;
  request.value_text = text_of(value);
  if (request.value_text.size() > shared_text_max) {
    return fail("E3009", "a shared string has at most 255 bytes", "too long");
  }
  if (pop_shared_element(instruction, request)) ask(std::move(request), AnswerUse::position_only);
}

}  // namespace stanok::lang

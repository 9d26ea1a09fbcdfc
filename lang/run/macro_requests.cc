#include "lang/run/macro_requests.h"

#include <cmath>
#include <utility>

#include "lang/block/tool_value.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

using VariableKind = MachineVariable::Kind;

constexpr double ms_per_s = 1000.0;
constexpr int first_edge = 1;
constexpr int first_table = 1;
constexpr int parts_made = 3901;
constexpr int single_block_switch = 3003;

ProgramRequest request_of_machine_value(std::string_view name, int index) {
  ProgramRequest request;
  request.kind = RequestKind::machine_value;
  request.text = name;
  request.index = index;
  return request;
}

}  // namespace

bool MacroRequests::execute(const Instruction& instruction) {
  if (instruction.op != Op::parameter && instruction.op != Op::settings) return false;
  if (!vm_.file().source.rules().is_fanuc()) return false;
  return instruction.op == Op::parameter ? read() : set(vm_.file().settings[instruction.operand]);
}

bool MacroRequests::read() {
  const double number = vm_.stack().top().number;
  if (!is_integer(number) || number < 1000.0) return false;
  const auto variable = machine_variable(static_cast<int>(std::lround(number)), state_.channel,
                                         vm_.file().source.rules());
  if (!variable || variable->kind == VariableKind::work_offset) return false;
  vm_.stack().drop();
  read_machine(*variable);
  return true;
}

void MacroRequests::read_machine(const MachineVariable& variable) {
  switch (variable.kind) {
    case VariableKind::machine_position:
      pending_.expect_number(from_programmed(state_.around, variable.index, 1.0) *
                             state_.around.tables.machine_reading().counts(variable.index));
      return requests_.ask(request_of_machine_value("pos_mcs", variable.index));
    case VariableKind::work_position:
      position_axis_ = variable.index;
      return requests_.ask({}, AnswerUse::work_position);
    case VariableKind::timer:
      pending_.expect_number(1.0 / ms_per_s, -timer_zero_s_ * ms_per_s);
      return requests_.ask(request_of_machine_value("clock", 0));
    case VariableKind::input:
      pending_.expect_number(1.0);
      return requests_.ask(request_of_machine_value("in", variable.index));
    case VariableKind::tool_value:
      return read_tool_value(variable);
    case VariableKind::parts:
      return vm_.stack().push(value_of(value_or_zero(parameters_.kept_variable(variable.index))));
    case VariableKind::override_switch:
      return vm_.stack().push(value_of(override_switches(variable.index)));
    case VariableKind::output:
    case VariableKind::work_offset:
      break;
  }
  vm_.fail("E3015", "outputs can be set, not read", "cannot be read");
}

double MacroRequests::unit_of_tool_value(int value) const {
  if (!is_tool_length(value)) return 1.0;
  const bool halved = state_.modal.diameters() && is_along_x(value);
  return state_.length_unit() * (halved ? 0.5 : 1.0);
}

void MacroRequests::read_tool_value(const MachineVariable& variable) {
  ProgramRequest request;
  request.kind = RequestKind::tool_table_read;
  request.number = variable.index;
  request.index = first_edge;
  request.channel = variable.value;
  pending_.expect_number(unit_of_tool_value(variable.value));
  requests_.ask(std::move(request));
}

bool MacroRequests::set(const std::vector<SettingTarget>& targets) {
  const bool alone = targets.size() == 1;
  if (!alone || targets[0].kind != SettingTarget::Kind::numbered) return false;
  const auto values = vm_.stack().top(2);
  const double number = values[0].number;
  const double value = value_or_zero(values[1].number);
  if (!is_integer(number) || number < 1000.0) return false;
  const auto variable = machine_variable(static_cast<int>(std::lround(number)), state_.channel,
                                         vm_.file().source.rules());
  if (!variable) return false;
  vm_.stack().cut_to(vm_.stack().height() - 2);
  set_machine(*variable, value);
  return true;
}

void MacroRequests::set_machine(const MachineVariable& variable, double value) {
  switch (variable.kind) {
    case VariableKind::timer:
      timer_set_ms_ = value;
      return requests_.ask(request_of_machine_value("clock", 0), AnswerUse::timer);
    case VariableKind::output:
      state_.begin_commands(vm_.instruction_origin());
      return state_.queue.emit(OutputCommand{false, false, variable.index, value});
    case VariableKind::tool_value:
    case VariableKind::work_offset:
      return write_table(variable, value);
    case VariableKind::parts:
      return parameters_.set_kept_variable(variable.index, value);
    case VariableKind::override_switch:
      return set_override_switches(variable.index, value);
    default:
      return vm_.fail("E3013", "this variable shows the state of the machine", "cannot be set");
  }
}

// #3003: bit 0 keeps single block from stopping, bit 1 the functions from being waited for; here
// both do what they always do. #3004: bit 0 lets a feed hold wait, bit 1 keeps the feed override
// from acting, bit 2 switches exact stop off, which programs choose here by G61 and G64 alone.
// Source: Fanuc B-63944EN, 16.2.
double MacroRequests::override_switches(int number) const {
  if (number == single_block_switch) return single_block_;
  const ModalSwitches& switches = state_.modal.switches;
  return (switches.feed_stop ? 0.0 : 1.0) + (switches.feed_override ? 0.0 : 2.0);
}

void MacroRequests::set_override_switches(int number, double value) {
  const int largest = number == single_block_switch ? 3 : 7;
  if (!is_integer(value) || value < 0.0 || value > largest) {
    return vm_.fail(
        "E3009",
        "#" + std::to_string(number) + " takes a whole number from 0 to " + std::to_string(largest),
        "out of range");
  }
  if (number == single_block_switch) {
    single_block_ = value;
    return;
  }
  const int bits = static_cast<int>(std::lround(value));
  ModalSwitches& switches = state_.modal.switches;
  switches.feed_stop = (bits & 1) == 0;
  switches.feed_override = (bits & 2) == 0;
  state_.begin_commands(vm_.instruction_origin());
  state_.queue.emit(OverrideControl{switches.feed_override, switches.spindle_override,
                                    switches.adaptive_feed, switches.feed_stop});
}

void MacroRequests::write_table(const MachineVariable& variable, double value) {
  ProgramRequest request;
  request.statement = true;
  if (variable.kind == VariableKind::tool_value) {
    request.kind = RequestKind::tool_table_write;
    request.number = variable.index;
    request.index = first_edge;
    request.channel = variable.value;
    request.value = value * unit_of_tool_value(variable.value);
    pending_.expect_statement({"E5020", "settable_tool"});
  } else {
    request.kind = RequestKind::offset_table_write;
    request.channel = first_table;
    request.number = variable.value;
    request.index = variable.index;
    request.value = from_programmed(state_.around, variable.index, value);
    pending_.expect_statement({"E5020", "settable_zs"});
  }
  requests_.ask(std::move(request));
}

void MacroRequests::finish_position() {
  vm_.stack().push(value_of(position_with_tool(state_.around, position_axis_)));
}

void MacroRequests::finish_timer(const Answer& answer) {
  timer_zero_s_ = answer.number - timer_set_ms_ / ms_per_s;
}

void MacroRequests::count_part() {
  if (!vm_.program().files[0]->source.rules().is_fanuc()) return;
  const double parts = value_or_zero(parameters_.kept_variable(parts_made));
  parameters_.set_kept_variable(parts_made, parts + 1.0);
}

}  // namespace stanok::lang

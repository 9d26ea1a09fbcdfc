#include "lang/run/value_instructions.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "lang/actions/actions.h"
#include "lang/text/number.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {
namespace {

// Programmed speed in 1/min of a spindle by its id; 0: the master spindle.
std::optional<double> spindle_speed(const BlockState& state, double id) {
  if (std::abs(id) <= 1e-9) return state.modal.spindles.speed_rev_per_min;
  const auto is_meant = [id](int spindle) { return is_integer(id) && std::lround(id) == spindle; };
  const std::vector<int>& known = state.channel.spindles;
  const auto found = std::find_if(known.begin(), known.end(), is_meant);
  if (found == known.end()) return std::nullopt;
  return state.modal.spindles.speeds_rev_per_min[static_cast<std::size_t>(found - known.begin())];
}

// Active code of modal group n of docs/reference/language.md.
std::optional<double> modal_code_of_group(const BlockState& state, double index) {
  if (!is_integer(index) || index < 1.0 || index > 17.0) return std::nullopt;
  const Group group = all_groups[whole_number(index) - 1];
  return state.modal.code(group) / 10.0;
}

std::optional<double> tool_value(const BlockState& state, std::string_view name) {
  const ModalState& modal = state.modal;
  const Tool tool = state.tables.tool_edge(modal.tool.active, modal.tool.edge).value_or(Tool{});
  if (name == "tool_length") return tool.length_mm[2];
  if (name == "tool_radius") return tool.radius_mm;
  return std::nullopt;
}

}  // namespace

std::optional<double> system_value(const BlockState& state, std::string_view name, double index,
                                   ValueFault& fault) {
  const ModalState& modal = state.modal;
  const auto axis = static_cast<std::size_t>(index);
  if (name == "channel") return state.channel.id;
  if (name == "prog_pos") return programmed_position(state.around, axis);
  if (name == "probe_ok") return truth(state.probe.found);
  if (name == "probe") return as_programmed(state.around, axis, state.probe.position[axis]);
  if (name == "feed") return modal.feed.programmed;
  if (name == "tool") return modal.tool.active;
  if (name == "tool_next") return std::max(modal.tool.prepared, 0);
  if (name == "edge") return modal.tool.edge;
  if (name == "overhang") return overhang_in_force(state.around);
  if (name == "speed") {
    fault = {"E4053", "the channel has no such spindle", "unknown spindle"};
    return spindle_speed(state, index);
  }
  if (name == "g") {
    fault = {"E3011", "there is no modal group of this number", {}};
    return modal_code_of_group(state, index);
  }
  return tool_value(state, name).value_or(0.0);
}

bool ValueInstructions::execute(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::parameter:
    case Op::named_parameter:
    case Op::named_parameter_exists:
    case Op::predefined_parameter:
    case Op::r_parameter:
      load_parameter(instruction);
      return true;
    case Op::settings:
      take_settings(vm_.file().settings[instruction.operand]);
      return true;
    case Op::system_value:
      push_system_value(instruction);
      return true;
    default:
      return false;
  }
}

void ValueInstructions::load_parameter(const Instruction& instruction) {
  ValueStack& stack = vm_.stack();
  ValueFault fault;
  std::optional<double> value;
  switch (instruction.op) {
    case Op::parameter:
      value = parameters_.numbered(stack.pop_number(), fault);
      if (value && instruction.extra == 0) value = value_or_zero(*value);
      break;
    case Op::named_parameter:
      value = parameters_.named_value(instruction.operand, fault);
      break;
    case Op::named_parameter_exists:
      return stack.push(value_of(parameters_.is_set(instruction.operand)));
    case Op::predefined_parameter:
      value = parameters_.predefined(instruction.operand, fault);
      break;
    case Op::r_parameter:
      return stack.push(value_of(parameters_.r_parameter(instruction.operand)));
    default:
      STANOK_ASSERT(false);
  }
  value ? stack.push(value_of(*value)) : vm_.fail(fault);
}

// All values stand on the stack; of two settings of one parameter the last holds.
void ValueInstructions::take_settings(const std::vector<SettingTarget>& targets) {
  std::size_t height = 0;
  for (const SettingTarget& target : targets) {
    height += target.kind == SettingTarget::Kind::numbered ? 2 : 1;
  }
  ValueStack& stack = vm_.stack();
  auto value = stack.top(height).begin();
  ValueFault fault;
  for (const SettingTarget& target : targets) {
    switch (target.kind) {
      case SettingTarget::Kind::numbered: {
        const double number = (value++)->number;
        if (!parameters_.set_numbered(number, value->number, fault)) return vm_.fail(fault);
        break;
      }
      case SettingTarget::Kind::named:
        parameters_.set_named(target.slot, value->number);
        break;
      case SettingTarget::Kind::r_parameter:
        parameters_.set_r_parameter(target.slot, value->number);
        break;
    }
    ++value;
  }
  stack.cut_to(stack.height() - height);
}

void ValueInstructions::push_system_value(const Instruction& instruction) {
  const std::string_view name = system_variables()[instruction.operand].name;
  ValueStack& stack = vm_.stack();
  if (name == "program") return stack.push(value_of(vm_.file().source.name()));
  const double index = instruction.count != 0 ? stack.pop_number() : 0.0;
  if (name == "line") return stack.push(value_of(static_cast<double>(vm_.span().line)));
  ValueFault fault;
  const auto value = system_value(state_, name, index, fault);
  value ? stack.push(value_of(*value)) : vm_.fail(fault);
}

}  // namespace stanok::lang

// RS274 parameters of a run: #n, #<name>, R.
#include <cmath>
#include <limits>
#include <utility>

#include "base/assert.h"
#include "lang/block/point_parameter.h"
#include "lang/run/program_run.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr std::size_t parameter_count = 5603;
// Below it all numbers belong to programs.
constexpr int machine_parameter_first = 5061;

constexpr double unset = std::numeric_limits<double>::quiet_NaN();

// The parameter a number stands for.
std::optional<int> parameter_index(double number, ValueFault& fault) {
  if (!is_integer(number)) {
    fault = {"E3010", "a parameter number must be a whole number", "not a whole number"};
    return std::nullopt;
  }
  const auto index = static_cast<int>(std::lround(number));
  if (index >= 1 && static_cast<std::size_t>(index) < parameter_count) return index;
  fault = {"E3015", "there is no parameter #" + std::to_string(index), "#1 to #5602 exist"};
  return std::nullopt;
}

bool is_of_channel(const std::string& name) {
  return name.starts_with('_');
}

}  // namespace

// Global named parameters stay with the channel; each program has its own slots for them.
void ProgramRun::keep_channel_parameters() {
  if (!program_) return;
  for (std::size_t slot = 0; slot < named_parameters_.size(); ++slot) {
    const std::string& name = program_->named_parameters[slot];
    if (is_of_channel(name) && !std::isnan(named_parameters_[slot])) {
      channel_parameters_[name] = named_parameters_[slot];
    }
  }
}

void ProgramRun::begin_parameters() {
  parameters_.assign(parameter_count, 0.0);
  named_parameters_.assign(program_->named_parameters.size(), unset);
  for (std::size_t slot = 0; slot < named_parameters_.size(); ++slot) {
    const auto kept = channel_parameters_.find(program_->named_parameters[slot]);
    if (kept != channel_parameters_.end()) named_parameters_[slot] = kept->second;
  }
  o_value_ = 0.0;
  o_value_returned_ = false;
}

ProgramRun::LocalParameters ProgramRun::fresh_local_parameters() const {
  LocalParameters parameters;
  parameters.named.assign(named_parameters_.size(), unset);
  return parameters;
}

// Puts `parameters` in force and returns those that were.
ProgramRun::LocalParameters ProgramRun::exchange_local_parameters(LocalParameters parameters) {
  for (std::size_t i = 0; i < local_parameter_count; ++i) {
    std::swap(parameters.numbered[i], parameters_[i + 1]);
  }
  for (std::size_t slot = 0; slot < named_parameters_.size(); ++slot) {
    if (is_of_channel(program_->named_parameters[slot])) continue;
    std::swap(parameters.named[slot], named_parameters_[slot]);
  }
  return parameters;
}

ParameterView ProgramRun::parameter_view() const {
  return {around_, origin().line, static_cast<int>(frames_.size()) - 1, o_value_,
          o_value_returned_};
}

void ProgramRun::load_parameter(const Instruction& instruction) {
  ValueFault fault;
  std::optional<double> value;
  switch (instruction.op) {
    case Op::parameter:
      value = numbered(pop_number(), fault);
      break;
    case Op::named_parameter:
      value = named_value(instruction.operand, fault);
      break;
    case Op::named_parameter_exists:
      return push(value_of(!std::isnan(named_parameters_[instruction.operand])));
    case Op::predefined_parameter:
      return push(value_of(predefined_parameters()[instruction.operand].read(parameter_view())));
    case Op::r_parameter:
      return push(value_of(r_parameters_[instruction.operand]));
    default:
      STANOK_ASSERT(false);
  }
  value ? push(value_of(*value)) : fail(fault.code, fault.message, fault.label);
}

std::optional<double> ProgramRun::numbered(double number, ValueFault& fault) {
  const auto index = parameter_index(number, fault);
  if (!index) return std::nullopt;
  if (*index >= machine_parameter_first) {
    if (const auto value = machine_parameter(*index, parameter_view())) return value;
  }
  return parameters_[static_cast<std::size_t>(*index)];
}

std::optional<double> ProgramRun::named(const std::string& name, ValueFault& fault) {
  if (is_of_channel(name)) {
    const PredefinedParameter* const row = find_predefined_parameter(name);
    if (row != nullptr) return row->read(parameter_view());
  }
  if (const auto slot = program_->named_parameters.find(name)) return named_value(*slot, fault);
  fault = {"E3014", "parameter #<" + name + "> has no value", "not set before"};
  return std::nullopt;
}

std::optional<double> ProgramRun::named_value(std::uint32_t slot, ValueFault& fault) const {
  const double value = named_parameters_[slot];
  if (!std::isnan(value)) return value;
  fault = {"E3014", "parameter #<" + program_->named_parameters[slot] + "> has no value",
           "not set before"};
  return std::nullopt;
}

std::optional<std::uint32_t> ProgramRun::slot_to_set(const std::string& name) {
  return program_->named_parameters.find(name);
}

// All values stand on the stack; of two settings of one parameter the last holds.
void ProgramRun::take_settings(const std::vector<SettingTarget>& targets) {
  std::size_t height = 0;
  for (const SettingTarget& target : targets) {
    height += target.kind == SettingTarget::Kind::numbered ? 2 : 1;
  }
  const std::size_t bottom = stack_.size() - height;
  std::size_t at = bottom;
  ValueFault fault;
  for (const SettingTarget& target : targets) {
    switch (target.kind) {
      case SettingTarget::Kind::numbered:
        if (!store_numbered_parameter(stack_[at].number, stack_[at + 1].number, fault)) {
          return fail(fault.code, fault.message, fault.label);
        }
        ++at;
        break;
      case SettingTarget::Kind::named:
        named_parameters_[target.slot] = stack_[at].number;
        break;
      case SettingTarget::Kind::r_parameter:
        r_parameters_[target.slot] = stack_[at].number;
        break;
    }
    ++at;
  }
  stack_.resize(bottom);
}

// The same for a plain line; false when the run has failed.
bool ProgramRun::take_settings(const std::vector<TextSetting>& settings) {
  ValueFault fault;
  for (const TextSetting& setting : settings) {
    if (setting.slot) {
      named_parameters_[*setting.slot] = setting.value;
    } else if (!store_numbered_parameter(setting.number, setting.value, fault)) {
      fail_text(setting.text, plain_.line - 1, fault);
      return false;
    }
  }
  return true;
}

bool ProgramRun::store_numbered_parameter(double number, double value, ValueFault& fault) {
  const auto index = parameter_index(number, fault);
  if (!index) return false;
  if (set_point_parameter(*index, value, around_)) return true;
  if (*index >= machine_parameter_first && machine_parameter(*index, parameter_view())) {
    fault = {"E3013", "parameter #" + std::to_string(*index) + " shows the state of the machine",
             "cannot be set"};
    return false;
  }
  parameters_[static_cast<std::size_t>(*index)] = value;
  return true;
}

}  // namespace stanok::lang

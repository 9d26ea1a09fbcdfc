#include "lang/run/parameter_store.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lang/block/point_parameter.h"
#include "lang/run/macro_variable.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr std::size_t parameter_count = 5603;
constexpr std::size_t r_parameter_count = 1000;
constexpr std::size_t input_result_parameter = 5399;  // of M66
// Below it all numbers belong to programs.
constexpr int machine_parameter_first = 5061;

// Of the Fanuc dialect: local ones, and common ones until and through power-off.
constexpr int local_last = static_cast<int>(local_variable_count);
constexpr int common_first = 100;
constexpr int common_last = 199;
constexpr std::size_t common_count = common_last - common_first + 1;

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

ValueFault no_variable(int number) {
  const std::string_view meaning = meaning_elsewhere(number);
  std::string label = meaning.empty() ? "docs/reference/language.md lists those that exist"
                                      : "on other controls: " + std::string(meaning);
  return {"E3015", "there is no variable #" + std::to_string(number), std::move(label)};
}

bool is_of_channel(const std::string& name) {
  return name.starts_with('_');
}

}  // namespace

ParameterStore::ParameterStore(const BlockSurroundings& around, const RunPlace& place)
    : around_(around),
      place_(place),
      r_parameters_(r_parameter_count, 0.0),
      common_(common_count, unset) {}

// Global named parameters stay with the channel; each program has its own slots for them.
void ParameterStore::keep_globals() {
  if (!program_) return;
  for (std::size_t slot = 0; slot < named_.size(); ++slot) {
    const std::string& name = program_->named_parameters[slot];
    if (is_of_channel(name) && !std::isnan(named_[slot])) globals_[name] = named_[slot];
  }
}

void ParameterStore::begin(const std::shared_ptr<const Program>& program) {
  keep_globals();
  program_ = program;
  numbered_.assign(parameter_count, 0.0);
  if (!program_->files.empty() && program_->files[0]->source.rules().is_fanuc())
    std::fill_n(numbered_.begin() + 1, local_variable_count, unset);
  named_.assign(program_->named_parameters.size(), unset);
  for (std::size_t slot = 0; slot < named_.size(); ++slot) {
    const auto kept = globals_.find(program_->named_parameters[slot]);
    if (kept != globals_.end()) named_[slot] = kept->second;
  }
  returned_.reset();
}

LocalParameters ParameterStore::fresh_locals(const TextRules& rules) const {
  LocalParameters locals;
  if (rules.is_fanuc()) {
    locals.count = local_variable_count;
    locals.numbered.fill(unset);
  }
  locals.named.assign(named_.size(), unset);
  return locals;
}

LocalParameters ParameterStore::exchange_locals(LocalParameters locals) {
  for (std::size_t i = 0; i < locals.count; ++i) {
    std::swap(locals.numbered[i], numbered_[i + 1]);
  }
  for (std::size_t slot = 0; slot < named_.size(); ++slot) {
    if (is_of_channel(program_->named_parameters[slot])) continue;
    std::swap(locals.named[slot], named_[slot]);
  }
  return locals;
}

ParameterView ParameterStore::view() const {
  const WhereItRuns where = place_.where();
  return {around_, where.origin.line, where.call_level, returned_.value_or(0.0),
          returned_.has_value()};
}

// #10000 and on are tools on Fanuc controls.
bool ParameterStore::is_common_variable(int number) const {
  const bool of_haas = number >= haas_variable_first && number <= haas_variable_last;
  return (number >= kept_variable_first && number <= kept_variable_last) ||
         (of_haas && place_.where().rules.is_haas());
}

double* ParameterStore::variable_in_memory(double number) {
  if (number > 0.5 && number < local_last + 0.5) return &numbered_[whole_number(number)];
  const bool common = number > common_first - 0.5 && number < common_last + 0.5;
  return common ? &common_[whole_number(number - common_first)] : nullptr;
}

double ParameterStore::kept_variable(int number) const {
  if (searched_) {
    const auto written = searched_->find(number);
    if (written != searched_->end()) return written->second;
  }
  return around_.tables.common_variable(number);
}

void ParameterStore::set_kept_variable(int number, double value) {
  if (searched_) {
    (*searched_)[number] = value;
  } else {
    around_.tables.set_common_variable(number, value);
  }
}

// Under the number where it is kept; false: nobody has it there.
bool ParameterStore::find_kept_place(int& number, ValueFault& fault) const {
  if (!place_.where().rules.is_haas()) return true;
  if (is_hidden_on_haas(number)) {
    fault = no_variable(number);
    return false;
  }
  number = haas_variable(number);
  return true;
}

std::optional<double> ParameterStore::macro_variable(int number, ValueFault& fault) {
  if (!find_kept_place(number, fault)) return std::nullopt;
  if (const double* const variable = variable_in_memory(number)) return *variable;
  if (number == 0) return unset;
  if (is_common_variable(number)) return kept_variable(number);
  if (const auto value = system_variable(number, view(), place_.where().rules)) return value;
  fault = no_variable(number);
  return std::nullopt;
}

bool ParameterStore::set_macro_variable(int number, double value, ValueFault& fault) {
  if (!find_kept_place(number, fault)) return false;
  if (double* const variable = variable_in_memory(number)) {
    *variable = value;
  } else if (is_common_variable(number)) {
    set_kept_variable(number, value);
  } else {
    fault = no_variable(number);
    if (system_variable(number, view(), place_.where().rules)) {
      fault = {"E3013", "#" + std::to_string(number) + " shows the state of the machine",
               "cannot be set"};
    }
    return false;
  }
  return true;
}

std::optional<double> ParameterStore::numbered(double number, ValueFault& fault) {
  if (is_integer(number) && number > 0.5 && number < local_parameter_count + 0.5)
    return numbered_[whole_number(number)];
  if (is_integer(number) && place_.where().rules.is_fanuc())
    return macro_variable(static_cast<int>(std::lround(number)), fault);
  const auto index = parameter_index(number, fault);
  if (!index) return std::nullopt;
  if (*index >= machine_parameter_first) {
    if (const auto value = machine_parameter(*index, view())) return value;
  }
  return numbered_[static_cast<std::size_t>(*index)];
}

std::optional<double> ParameterStore::named(const std::string& name, ValueFault& fault) {
  if (is_of_channel(name)) {
    const PredefinedParameter* const row = find_predefined_parameter(name);
    if (row != nullptr) return predefined_value(*row, fault);
  }
  if (const auto slot = program_->named_parameters.find(name)) return named_value(*slot, fault);
  fault = {"E3014", "parameter #<" + name + "> has no value", "not set before"};
  return std::nullopt;
}

std::optional<double> ParameterStore::named_value(std::uint32_t slot, ValueFault& fault) const {
  const double value = named_[slot];
  if (!std::isnan(value)) return value;
  fault = {"E3014", "parameter #<" + program_->named_parameters[slot] + "> has no value",
           "not set before"};
  return std::nullopt;
}

std::optional<std::uint32_t> ParameterStore::slot_to_set(const std::string& name) {
  return program_->named_parameters.find(name);
}

bool ParameterStore::is_set(std::uint32_t slot) const {
  return !std::isnan(named_[slot]);
}

std::optional<double> ParameterStore::predefined(std::uint32_t row, ValueFault& fault) const {
  return predefined_value(predefined_parameters()[row], fault);
}

std::optional<double> ParameterStore::predefined_value(const PredefinedParameter& row,
                                                       ValueFault& fault) const {
  const double value = row.read(view());
  if (!std::isnan(value)) return value;
  fault = {"E3014", "parameter #<" + std::string(row.name) + "> has no value",
           "not while TCP or a transformation is active"};
  return std::nullopt;
}

bool ParameterStore::set_numbered(double number, double value, ValueFault& fault) {
  if (is_integer(number) && place_.where().rules.is_fanuc())
    return set_macro_variable(static_cast<int>(std::lround(number)), value, fault);
  const auto index = parameter_index(number, fault);
  if (!index) return false;
  if (set_point_parameter(*index, value, around_)) return true;
  if (*index >= machine_parameter_first && machine_parameter(*index, view())) {
    fault = {"E3013", "parameter #" + std::to_string(*index) + " shows the state of the machine",
             "cannot be set"};
    return false;
  }
  numbered_[static_cast<std::size_t>(*index)] = value;
  return true;
}

void ParameterStore::set_input_result(double value) {
  numbered_[input_result_parameter] = value;
}

}  // namespace stanok::lang

// checked_parameters of protocol/contract/json_rpc.h: every value is held against its row before
// anyone reads it.
#include <algorithm>
#include <cmath>
#include <optional>

#include "protocol/contract/json_rpc.h"
#include "protocol/contract/json_text.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

Unexpected<Failure> wrong(std::string message) {
  return Unexpected<Failure>(
      Failure{FailureKind::invalid_parameters, "E9003", std::move(message), 0, {}});
}

std::string number_text(double value) {
  const bool is_whole = value == std::floor(value) && std::abs(value) < 1e15;
  return json_text(is_whole ? json(static_cast<std::int64_t>(value)) : json(value));
}

std::string choices_text(const Parameter& parameter) {
  std::string text;
  for (const std::string_view choice : parameter.choices) {
    text += (text.empty() ? "" : ", ") + std::string(choice);
  }
  return text;
}

bool is_choice(const Parameter& parameter, const json& value) {
  return value.is_string() &&
         std::find(parameter.choices.begin(), parameter.choices.end(),
                   value.get_ref<const std::string&>()) != parameter.choices.end();
}

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

// What is wrong with a number, without the name of its parameter.
std::optional<std::string> number_fault(const Parameter& parameter, const json& value) {
  if (!value.is_number()) return "must be a number";
  const double number = value.get<double>();
  if (parameter.type == ParameterType::integer && number != std::floor(number))
    return "must be an integer";
  if (number >= parameter.minimum && number <= parameter.maximum) return std::nullopt;
  return "must lie from " + number_text(parameter.minimum) + " to " +
         number_text(parameter.maximum) +
         (parameter.unit.empty() ? "" : " " + std::string(parameter.unit));
}

std::optional<std::string> text_fault(const Parameter& parameter, const json& value) {
  if (!value.is_string()) return "must be a string";
  const auto& text = value.get_ref<const std::string&>();
  const auto length = static_cast<double>(text.size());
  if (length < parameter.minimum) return "must not be empty";
  if (length > parameter.maximum)
    return "must not be longer than " + number_text(parameter.maximum) + " bytes";
  const bool has_lines = parameter.spelling == Spelling::file;
  if (!has_lines && has_control_character(text)) return "must not contain control characters";
  return std::nullopt;
}

std::optional<std::string> list_fault(const Parameter& parameter, const json& value) {
  if (!value.is_array()) return "must be a list";
  if (static_cast<double>(value.size()) > parameter.maximum) return "has too many members";
  const bool all_known = std::all_of(
      value.begin(), value.end(), [&](const json& member) { return is_choice(parameter, member); });
  if (all_known) return std::nullopt;
  return "may contain: " + choices_text(parameter);
}

std::optional<std::string> fault(const Parameter& parameter, const json& value) {
  switch (parameter.type) {
    case ParameterType::integer:
    case ParameterType::number:
      return number_fault(parameter, value);
    case ParameterType::text:
      return text_fault(parameter, value);
    case ParameterType::choice:
      if (is_choice(parameter, value)) return std::nullopt;
      return "must be one of: " + choices_text(parameter);
    case ParameterType::text_list:
      return list_fault(parameter, value);
  }
  return std::nullopt;
}

Expected<json, Failure> by_name(const Method& method, const json& parameters) {
  if (parameters.is_object()) return parameters;
  if (parameters.size() > method.parameters.size()) {
    return wrong("too many parameters: " + std::string(method.name) + " takes " +
                 std::to_string(method.parameters.size()));
  }
  json named = json::object();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    named[std::string(method.parameters[i].name)] = parameters[i];
  }
  return named;
}

const Parameter* find_parameter(const Method& method, std::string_view name) {
  const auto found = std::find_if(method.parameters.begin(), method.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  return found == method.parameters.end() ? nullptr : &*found;
}

// 0 or 1; what many libraries write as false or true.
bool is_claim(const Parameter& parameter) {
  return parameter.type == ParameterType::integer && parameter.minimum == 0.0 &&
         parameter.maximum == 1.0;
}

std::string known_names(const Method& method) {
  if (method.parameters.empty()) return std::string(method.name) + " takes no parameters";
  std::string text = "known are: ";
  for (const Parameter& parameter : method.parameters) {
    text += (&parameter == method.parameters.data() ? "" : ", ") + std::string(parameter.name);
  }
  return text;
}

}  // namespace

Expected<json, Failure> checked_parameters(const Method& method, const json& parameters) {
  auto named = by_name(method, parameters);
  if (!named) return named;
  for (auto& [name, value] : named->items()) {
    const Parameter* parameter = find_parameter(method, name);
    if (parameter == nullptr)
      return wrong("unknown parameter \"" + name + "\"; " + known_names(method));
    if (is_claim(*parameter) && value.is_boolean()) value = value.get<bool>() ? 1 : 0;
    if (const auto reason = fault(*parameter, value)) return wrong(name + " " + *reason);
  }
  for (const Parameter& parameter : method.parameters) {
    if (parameter.presence == Presence::required && !named->contains(std::string(parameter.name))) {
      return wrong("parameter \"" + std::string(parameter.name) +
                   "\" is missing: " + std::string(parameter.help));
    }
  }
  return named;
}

}  // namespace stanok::protocol

// Parameters that a method of the protocol accepts, made from its row.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "protocol/contract/method_table.h"

namespace stanok::daemon {

// Something that the method accepts, for each of its parameters.
inline nlohmann::json accepted_value(const protocol::Parameter& parameter) {
  if (parameter.spelling == protocol::Spelling::file) return "[offset.G54]\n";
  switch (parameter.type) {
    case protocol::ParameterType::text:
      return "a.nc";
    case protocol::ParameterType::choice:
      return parameter.choices.front();
    case protocol::ParameterType::text_list:
      return nlohmann::json::array({parameter.choices.front()});
    default:
      return parameter.maximum;
  }
}

// It takes files that a test has to give, or long.
inline bool calculates(const protocol::Method& method) {
  const bool is_of_process =
      protocol::noun(method) == "process" && method.course == protocol::Course::reads_program;
  return is_of_process || method.name == "program.picture";
}

inline nlohmann::json accepted_parameters(const protocol::Method& method) {
  nlohmann::json parameters = nlohmann::json::object();
  for (const protocol::Parameter& parameter : method.parameters) {
    if (parameter.presence != protocol::Presence::optional)
      parameters[std::string(parameter.name)] = accepted_value(parameter);
  }
  const bool is_entry = protocol::noun(method) == "tool" || protocol::noun(method) == "offset";
  if (is_entry && parameters.contains("value")) parameters["value"] = 1;  // that is likely
  if (method.name == "program.remove") parameters["version"] = "any";
  if (method.name == "program.path") parameters.clear();
  if (method.name == "scope.start") parameters["signals"] = "cycle.time";
  return parameters;
}

}  // namespace stanok::daemon

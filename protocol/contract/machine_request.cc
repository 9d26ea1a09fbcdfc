#include "protocol/contract/machine_request.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/assert.h"

namespace stanok::protocol {
namespace {

int place_of_choice(const Parameter& parameter, std::string_view choice) {
  const auto found = std::ranges::find(parameter.choices, choice);
  return static_cast<int>(found - parameter.choices.begin());
}

}  // namespace

MachineRequest machine_request(const Method& method, const nlohmann::json& parameters) {
  STANOK_ASSERT(!method.action.empty());
  MachineRequest request;
  request.action = method.action;
  for (const Parameter& parameter : method.parameters) {
    const auto value = parameters.find(std::string(parameter.name));
    if (value == parameters.end()) continue;
    switch (parameter.carries) {
      case Carries::nothing:
        break;
      case Carries::channel:
        request.channel = value->get<int>();
        break;
      case Carries::number:
        request.number = parameter.type == ParameterType::choice
                             ? place_of_choice(parameter, value->get<std::string>())
                             : value->get<int>();
        break;
      case Carries::fraction_of_percent:
        request.value = value->get<double>() / 100.0;
        break;
      case Carries::value:
        request.value = value->get<double>();
        break;
      case Carries::value_2:
        request.value_2 = value->get<double>();
        break;
      case Carries::text:
        request.text = value->get<std::string>();
        break;
      case Carries::more_text:
        request.text += " " + value->get<std::string>();
        break;
    }
  }
  return request;
}

}  // namespace stanok::protocol

#include "protocol/machine_request.h"

#include <nlohmann/json.hpp>

#include "base/assert.h"

namespace stanok::protocol {

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
        request.number = value->get<int>();
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
    }
  }
  return request;
}

}  // namespace stanok::protocol

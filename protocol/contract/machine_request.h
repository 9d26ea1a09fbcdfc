// MachineRequest: a checked request in the form in which it enters the real-time cycle, still in
// words.
//
// Made from the table alone, so that the operator's socket, event files of `stanok simulate` and
// input records read the same JSON in the same way. `action` is the name of a
// channels::OperatorAction.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "protocol/contract/method_table.h"

namespace stanok::protocol {

struct MachineRequest {
  std::string_view action;
  int channel = 0;  // 0: not named
  int number = 0;
  double value = 0.0;  // overrides: 1 = 100 %
  double value_2 = 0.0;
  std::string text;
};

// `parameters` are as checked_parameters returned them; the method has an action.
[[nodiscard]] MachineRequest machine_request(const Method& method,
                                             const nlohmann::json& parameters);

}  // namespace stanok::protocol

// A grinding cycle as text for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/terminal/terminal.h"
#include "process/grinding/cycle_design.h"
#include "process/grinding/robust_design.h"

namespace stanok::client {

// What is reported: a cycle of a process.
struct GrindReport {
  const process::DesignRequest& request;
  const process::CycleDesign& design;
  const std::vector<process::Corner>& corners = no_corners;  // of a robust design

  static const std::vector<process::Corner> no_corners;
};

[[nodiscard]] nlohmann::ordered_json to_json(const GrindReport& report);
[[nodiscard]] std::string to_text(const GrindReport& report, const Terminal& terminal);

// "error[E9103]: the part burns: ..."
[[nodiscard]] std::string to_text(const process::Finding& finding);
// {"ok": false, "findings": [...]}: of a request that was refused.
[[nodiscard]] nlohmann::ordered_json refusal_json(const process::Findings& findings);

}  // namespace stanok::client

// A grinding cycle as text for people.
#pragma once

#include <string>

#include "client/terminal/terminal.h"
#include "jobs/grinding/grind_cycle.h"

namespace stanok::client {

[[nodiscard]] std::string to_text(const jobs::GrindCycle& cycle, const Terminal& terminal);

// "error[E9103]: the part burns: ..."
[[nodiscard]] std::string to_text(const process::Finding& finding);

}  // namespace stanok::client

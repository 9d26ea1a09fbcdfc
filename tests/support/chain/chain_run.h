// One program through the whole chain: `check` as a user calls it, then the run with an operator
// who changes overrides, holds and resumes; every cycle is looked at.
#pragma once

#include <string>

#include "channels/contract/machine_config.h"
#include "tests/support/chain/random_program.h"

namespace stanok::testing {

[[nodiscard]] channels::MachineConfig machine_of(MachineKind kind);

// What is wrong, in words; empty: what `check` takes runs to its end or ends with a documented
// code, nothing else than what is documented stops it, and no axis passes a limit on the way.
[[nodiscard]] std::string chain_fault(MachineKind machine, const std::string& program,
                                      Choices& choices);

}  // namespace stanok::testing

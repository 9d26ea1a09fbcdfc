// Carries out one operator command: connects, asks, shows the answer; the exit code says how it
// ended.
#pragma once

#include "client/operator/operator_commands.h"

namespace stanok::client {

// Throws ConnectionError and Interrupted (client/operator/operator_client.h).
[[nodiscard]] int run_operator_call(const OperatorCall& call);

}  // namespace stanok::client

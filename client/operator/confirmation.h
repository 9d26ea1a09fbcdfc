// Confirmation: a value that the daemon thinks unlikely is asked about on the terminal.
#pragma once

#include "client/operator/operator_commands.h"
#include "protocol/contract/failure.h"

namespace stanok::client {

// The daemon would take the same call with `confirmed`.
[[nodiscard]] bool wants_confirmation(const OperatorCall& call, const protocol::Failure& failure);

// Asks whoever sits at the terminal, and waits for the answer. False too where nobody does, or
// where JSON is wanted.
[[nodiscard]] bool is_confirmed(const OperatorCall& call, const protocol::Failure& failure);

}  // namespace stanok::client

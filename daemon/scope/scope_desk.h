// The scope as clients ask for it: what it can record, how it is started, and its samples.
//
// Samples travel as Float32, little endian, in base64: a value of each signal, cycle by cycle.
#pragma once

#include <nlohmann/json.hpp>

#include "base/expected.h"
#include "daemon/scope/scope.h"
#include "protocol/contract/failure.h"

namespace stanok::daemon {

[[nodiscard]] nlohmann::json scope_signal_list(const channels::MachineConfig& machine);
// Parameters are as checked_parameters returned them.
[[nodiscard]] Expected<nlohmann::json, protocol::Failure> start_scope(
    Scope& scope, const channels::MachineConfig& machine, const nlohmann::json& parameters);
[[nodiscard]] nlohmann::json scope_reading(const Scope& scope,
                                           const channels::MachineConfig& machine,
                                           const nlohmann::json& parameters);

}  // namespace stanok::daemon

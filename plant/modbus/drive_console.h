// What a person types into stanok-drives while it serves: faults and the load of the process.
//
//   fault X stuck            every fault of docs/integrator/drives.md#faults; none: it works again
//   load S1 1500 12.5 85     power of the process in W, vibration in um and Hz
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plant/mechanics/plant_config.h"
#include "plant/modbus/modbus_server.h"

namespace stanok::plant {

// A fault for one of the drives of the server.
struct Injection {
  std::size_t drive = 0;
  FaultKind kind = FaultKind::none;
};

// No value when the axis or the fault is unknown.
[[nodiscard]] std::optional<Injection> injection(std::string_view axis, std::string_view fault,
                                                 const std::vector<SimulatedDriveConfig>& drives);

// Carries one line out. Empty when it is done, else what is wrong with it.
[[nodiscard]] std::string carry_out(const std::string& line,
                                    const std::vector<SimulatedDriveConfig>& drives,
                                    ModbusServer& server);

}  // namespace stanok::plant

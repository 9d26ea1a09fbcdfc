// What may be wrong with a machine file that has no faults, for `stanok machine check`.
#pragma once

#include <string>
#include <vector>

#include "config/files/machine_file.h"

namespace stanok::config {

// One sentence each, as "axis X: ..."; empty: nothing.
[[nodiscard]] std::vector<std::string> remarks_on(const MachineFile& machine);

}  // namespace stanok::config

// A machine file that was read, as Python holds it; and what programs are given to functions of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "config/files/machine_file.h"

namespace stanok::python {

// Shared and never changed: several threads may simulate one machine at a time.
using MachineHandle = std::shared_ptr<const config::MachineFile>;

// Where programs are looked for, in this order: their folders, what the caller names, the cycles
// that come with stanok.
using Roots = std::vector<std::filesystem::path>;

// Throws std::invalid_argument "machine NAME has no channel N; it has 1, 2".
[[nodiscard]] const channels::ChannelConfig& channel_of(const config::MachineFile& machine,
                                                        int channel);

}  // namespace stanok::python

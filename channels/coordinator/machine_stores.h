// MachineStores: what belongs to the machine and not to one channel; owned by it.
#pragma once

#include "channels/contract/output.h"
#include "channels/stores/live_tables.h"
#include "channels/stores/shared_variables.h"

namespace stanok::channels {

struct MachineStores {
  SharedVariables* shared = nullptr;
  LiveTables* tables = nullptr;
  const Signals* inputs = nullptr;
};

}  // namespace stanok::channels

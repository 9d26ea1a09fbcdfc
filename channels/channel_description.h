// What the interpreter of one channel needs of the machine file.
#pragma once

#include "channels/machine_config.h"
#include "lang/environment.h"

namespace stanok::channels {

[[nodiscard]] lang::ChannelDescription channel_description(const MachineConfig& machine,
                                                           const ChannelConfig& channel);

}  // namespace stanok::channels

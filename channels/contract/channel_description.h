// What the interpreter of one channel needs of the machine file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "channels/contract/machine_config.h"
#include "lang/contract/environment.h"

namespace stanok::channels {

[[nodiscard]] lang::ChannelDescription channel_description(const MachineConfig& machine,
                                                           const ChannelConfig& channel);

// What is wrong with an entry of ChannelConfig::codes, if anything is.
[[nodiscard]] std::optional<std::string> fault_of_code(std::string_view code,
                                                       std::string_view meaning);
// What is wrong with an entry of ChannelConfig::address_alias of this channel, if anything is.
[[nodiscard]] std::optional<std::string> fault_of_alias(std::string_view letter,
                                                        std::string_view address,
                                                        const ChannelConfig& channel);

}  // namespace stanok::channels

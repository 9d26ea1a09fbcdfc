// Commands that become an item of the program just as they are, without path or transform.
#pragma once

#include <optional>

#include "channels/messages/item.h"
#include "lang/contract/command.h"

namespace stanok::channels {

// Nothing: the command is no such one.
[[nodiscard]] std::optional<ItemContent> plain_content(const lang::Payload& payload);

}  // namespace stanok::channels

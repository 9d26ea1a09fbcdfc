// Commands that become an item of the program just as they are, without path or transform.
#pragma once

#include <optional>

#include "channels/messages/item.h"
#include "lang/contract/command.h"

namespace stanok::channels {

// The item, its tag open; nothing: the command is no such one.
[[nodiscard]] std::optional<Item> plain_item(const lang::Payload& payload);

}  // namespace stanok::channels

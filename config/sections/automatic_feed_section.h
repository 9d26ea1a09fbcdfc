// Reader of [[channel.automatic_feed]]: laws that the cycle forms from a sensor of the spindle.
#pragma once

#include <vector>

#include "channels/contract/machine_config.h"
#include "config/text/key_table.h"

namespace stanok::config {

// At most one law of each kind.
[[nodiscard]] std::vector<motion::AutomaticFeedConfig> read_automatic_feeds(
    Subtables laws, const channels::ChannelConfig& channel, const Scope& scope);

[[nodiscard]] std::vector<KeyRow> automatic_feed_key_rows();

}  // namespace stanok::config

// What `process.status` tells of a channel: the current feed law, what operators and sensors make
// of the feed, and S, S_0, n and v (docs/programmer/feed-laws.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "channels/contract/output.h"

namespace stanok::daemon {

[[nodiscard]] nlohmann::json process_status(const channels::ChannelOutput& output);

}  // namespace stanok::daemon

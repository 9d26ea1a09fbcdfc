// Force control in the words of programs and of people: what a program says, as a command to the
// modifier of the feed; what the modifier found, as events and alarms.
#pragma once

#include "base/rt_safe.h"
#include "channels/cycle/channel_log.h"
#include "lang/contract/command.h"
#include "motion/segments/feed_modifier.h"

namespace stanok::channels {

// What the loss of a sensor asks of the channel.
enum class SensorLoss : std::uint8_t { none, holds_feed };

[[nodiscard]] motion::ForceCommand command_of(const lang::ForceControl& program) RT_SAFE;
// Tells the event, if there is one. `tag`: of the block on the path.
[[nodiscard]] SensorLoss tell(motion::ForceEvent event, const motion::BlockTag& tag,
                              ChannelLog& log) RT_SAFE;

}  // namespace stanok::channels

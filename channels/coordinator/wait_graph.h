// The graph "channel -> channels it waits for", and the circle of channels that wait for each other
// for ever.
//
// A wait ends only when all channels it is for have come; so a circle never opens again. Channels
// are numbers from 0. Pure functions, called in the real-time cycle.
#pragma once

#include <cstdint>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/contract/output.h"

namespace stanok::channels {

// Bit k stands for channel k.
using ChannelSet = std::uint32_t;

[[nodiscard]] constexpr ChannelSet channel_bit(int channel) RT_SAFE {
  return ChannelSet{1} << static_cast<unsigned>(channel);
}

// Each channel waits for the next one, the last one for the first.
struct Circle {
  int length = 0;  // 0: there is none
  NumberedArray<int, channels_max> channels{};
};

// A shortest circle through channel `start`. `awaited[k]`: the channels for which channel k waits.
[[nodiscard]] Circle find_circle(NumberedSpan<const ChannelSet> awaited, int start) RT_SAFE;

}  // namespace stanok::channels

#include "channels/coordinator/wait_graph.h"

#include <algorithm>

namespace stanok::channels {

// Breadth first from `start`: reached_from[k] is the channel through which k was reached.
Circle find_circle(std::span<const ChannelSet> awaited, int start) RT_SAFE {
  const int count = static_cast<int>(std::min<std::size_t>(awaited.size(), channels_max));
  std::array<int, channels_max> reached_from{};
  std::array<int, channels_max> queue{};
  ChannelSet reached = channel_bit(start);
  queue[0] = start;
  int queued = 1;
  for (int at = 0; at < queued; ++at) {
    const int here = queue[static_cast<std::size_t>(at)];
    const ChannelSet next = awaited[static_cast<std::size_t>(here)];
    if ((next & channel_bit(start)) != 0) {
      Circle circle;
      for (int back = here; back != start; back = reached_from[static_cast<std::size_t>(back)])
        circle.channels[static_cast<std::size_t>(circle.length++)] = back;
      circle.channels[static_cast<std::size_t>(circle.length++)] = start;
      std::reverse(circle.channels.begin(), circle.channels.begin() + circle.length);
      return circle;
    }
    for (int k = 0; k < count; ++k) {
      if ((next & ~reached & channel_bit(k)) == 0) continue;
      reached |= channel_bit(k);
      reached_from[static_cast<std::size_t>(k)] = here;
      queue[static_cast<std::size_t>(queued++)] = k;
    }
  }
  return {};
}

}  // namespace stanok::channels

#include "channels/coordinator/wait_graph.h"

#include <algorithm>

namespace stanok::channels {

// Breadth first from `start`: reached_from[k] is the channel through which k was reached.
Circle find_circle(NumberedSpan<const ChannelSet> awaited, int start) RT_SAFE {
  const int count = static_cast<int>(std::min<std::size_t>(awaited.size(), channels_max));
  NumberedArray<int, channels_max> reached_from{};
  NumberedArray<int, channels_max> queue{};
  ChannelSet reached = channel_bit(start);
  queue[0] = start;
  int queued = 1;
  for (int at = 0; at < queued; ++at) {
    const int here = queue[at];
    const ChannelSet next = awaited[here];
    if ((next & channel_bit(start)) != 0) {
      Circle circle;
      for (int back = here; back != start; back = reached_from[back])
        circle.channels[circle.length++] = back;
      circle.channels[circle.length++] = start;
      std::reverse(circle.channels.begin(), circle.channels.begin() + circle.length);
      return circle;
    }
    for (int k = 0; k < count; ++k) {
      if ((next & ~reached & channel_bit(k)) == 0) continue;
      reached |= channel_bit(k);
      reached_from[k] = here;
      queue[queued++] = k;
    }
  }
  return {};
}

}  // namespace stanok::channels

#include "channels/cycle/refill.h"

#include "channels/messages/channel_link.h"

namespace stanok::channels {
namespace {

// So much motion, the end of the chain, or half of what the queue holds: very short blocks.
bool is_enough(const motion::PathQueue& queue) RT_SAFE {
  if (2 * queue.segments.size() >= queue.segments.capacity()) return true;
  double time = 0.0;
  for (std::size_t k = 0; k < queue.chunks.size(); ++k) {
    const motion::Chunk& chunk = queue.chunks[k];
    time += chunk.time_s;
    if (chunk.last || time >= enough_path_s) return true;
  }
  return false;
}

}  // namespace

bool Refill::look(motion::PathState state, const motion::PathQueue& queue) RT_SAFE {
  if (is_on_) {
    is_on_ = !is_enough(queue);
    return false;
  }
  is_on_ = state == motion::PathState::starved;
  return is_on_;
}

}  // namespace stanok::channels

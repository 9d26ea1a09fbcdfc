#include "recording/stream/message_sender.h"

#include "base/place.h"
#include "channels/contract/output.h"

namespace stanok::recording {

MessageSender::MessageSender(const LogDescription& description, std::vector<MessageSink*> sinks,
                             int bytes_max)
    : utime_start_(description.utime_start),
      cycle_us_(description.cycle_us),
      names_(description.machine),
      sinks_(std::move(sinks)),
      buffer_(checked_size(bytes_max)) {}

Stamp MessageSender::next_stamp(std::int64_t cycle, int channel, Topic topic) {
  STANOK_ASSERT(channel >= 0 && channel <= channels::channels_max);
  return {.utime = utime_start_ + cycle * cycle_us_,
          .cycle = cycle,
          .seq = next_seq_[channel][topic]++};
}

}  // namespace stanok::recording

// Rendezvous: which channels stand at which mark, and when all that belong together are there.
//
// A mark is met when every channel of its set has come to the same mark with the same set. Owner:
// the coordinator; real-time. Channels are numbers from 0.
#pragma once

#include "base/numbered.h"
#include "channels/coordinator/wait_graph.h"
#include "motion/path/path.h"

namespace stanok::channels {

class Rendezvous {
 public:
  struct Arrival {
    bool present = false;
    bool met = false;  // all are there: the channel may go on
    int mark = 0;
    ChannelSet members = 0;  // the own channel included
    motion::BlockTag tag;    // of the call
  };

  void arrive(int channel, int mark, ChannelSet members, const motion::BlockTag& tag) RT_SAFE;
  void leave(int channel) RT_SAFE;
  // Notes for all channels at once which marks are met.
  void meet() RT_SAFE;

  [[nodiscard]] const Arrival& at(int channel) const RT_SAFE { return arrivals_[channel]; }
  // The members for which channel `channel` still waits at `mark`.
  [[nodiscard]] ChannelSet missing(int channel, int mark, ChannelSet members) const RT_SAFE;
  // A channel that waits at the same mark for `channel` or is awaited by it, with another set; -1:
  // none.
  [[nodiscard]] int mismatch(int channel) const RT_SAFE;

 private:
  NumberedArray<Arrival, channels_max> arrivals_{};
};

}  // namespace stanok::channels

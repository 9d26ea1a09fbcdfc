// ChannelTable: the channels of a machine, by index and by id; a set of them is a bit mask of
// indices.
#pragma once

#include <algorithm>
#include <span>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/coordinator/wait_graph.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {

class ChannelTable {
 public:
  // The channels outlive the table.
  explicit ChannelTable(std::span<Channel* const> channels)
      : count_(static_cast<int>(channels.size())) {
    std::copy(channels.begin(), channels.end(), channels_.begin());
  }

  [[nodiscard]] int count() const RT_SAFE { return count_; }
  [[nodiscard]] Channel& operator[](int index) const RT_SAFE { return *channels_[index]; }
  [[nodiscard]] std::span<Channel* const> all() const RT_SAFE {
    return {channels_.begin(), channels_.begin() + count_};
  }
  // -1: there is none.
  [[nodiscard]] int index_of(int id) const RT_SAFE {
    for (int k = 0; k < count_; ++k) {
      if ((*this)[k].id() == id) return k;
    }
    return -1;
  }
  // Bit k of `ids` stands for the channel with the id k.
  [[nodiscard]] ChannelSet with_ids(std::uint32_t ids) const RT_SAFE {
    ChannelSet set = 0;
    for (int k = 0; k < count_; ++k) {
      if ((ids >> (*this)[k].id() & 1U) != 0) set |= channel_bit(k);
    }
    return set;
  }

 private:
  NumberedArray<Channel*, channels_max> channels_{};
  int count_;
};

}  // namespace stanok::channels

#include "channels/coordinator/rendezvous.h"

namespace stanok::channels {

void Rendezvous::arrive(int channel, int mark, ChannelSet members, const motion::BlockTag& tag)
    RT_SAFE {
  arrivals_[channel] = {true, false, mark, members, tag};
}

void Rendezvous::leave(int channel) RT_SAFE {
  arrivals_[channel] = {};
}

void Rendezvous::meet() RT_SAFE {
  for (int k = 0; k < channels_max; ++k) {
    Arrival& arrival = arrivals_[k];
    if (arrival.present && missing(k, arrival.mark, arrival.members) == 0) arrival.met = true;
  }
}

ChannelSet Rendezvous::missing(int channel, int mark, ChannelSet members) const RT_SAFE {
  ChannelSet absent = 0;
  for (int k = 0; k < channels_max; ++k) {
    if (k == channel || (members & channel_bit(k)) == 0) continue;
    const Arrival& other = at(k);
    const bool there = other.present && other.mark == mark && other.members == members;
    if (!there) absent |= channel_bit(k);
  }
  return absent;
}

int Rendezvous::mismatch(int channel) const RT_SAFE {
  const Arrival& own = at(channel);
  for (int k = 0; k < channels_max; ++k) {
    const Arrival& other = at(k);
    if (k == channel || !other.present || other.mark != own.mark) continue;
    const bool concerned =
        (own.members & channel_bit(k)) != 0 || (other.members & channel_bit(channel)) != 0;
    if (concerned && other.members != own.members) return k;
  }
  return -1;
}

}  // namespace stanok::channels

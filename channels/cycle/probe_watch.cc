#include "channels/cycle/probe_watch.h"

#include <algorithm>

namespace stanok::channels {

bool ProbeWatch::begin(const ProbeBegin& probe) RT_SAFE {
  move_ = {};
  move_.is_on = true;
  move_.input = probe.input;
  move_.until_contact = probe.until_contact;
  move_.ends_path = inputs_.is_on(move_.input) == move_.until_contact;
  return !move_.ends_path;
}

void ProbeWatch::see_tool(AtWork tool) RT_SAFE {
  constexpr double bounce_s = 0.05;
  const int input = constants_.probe_input;
  if (tool != AtWork::probe || input < 0) {
    contact_ = {};
    return;
  }
  const bool touches = inputs_.is_on(input);
  contact_.has_closed = touches && contact_.open_s >= bounce_s;
  contact_.open_s = touches ? 0.0 : std::min(contact_.open_s + constants_.cycle_s, bounce_s);
}

bool ProbeWatch::meets_something() const RT_SAFE {
  return contact_.has_closed && !move_.is_on && !motion_.is_standing();
}

void ProbeWatch::advance(ChannelLink& link) RT_SAFE {
  if (!move_.is_on) return;
  if (!move_.ends_path && inputs_.is_on(move_.input) == move_.until_contact) {
    move_.has_changed = true;
    move_.ends_path = true;
    for (std::size_t k = 0; k < motion::axes_max; ++k) {
      move_.axes_M[k] = drives_.is_ideal() ? motion_.path().axes[k].value
                                           : drives_.feedback(static_cast<int>(k)).position;
    }
  }
  // Behind the whole move is its request, which the answer is for.
  if (!move_.ends_path || !motion_.path_is_at_rest() || link.items.empty()) return;
  if (motion_.path().chunks_done >= link.items.front().after_chunk) return;
  motion_.drop_path(link.path);
}

ChannelAnswer ProbeWatch::take_answer() RT_SAFE {
  ChannelAnswer answer;
  answer.ok = move_.has_changed;
  answer.probe_M = move_.axes_M;
  answer.left_path = move_.ends_path;
  end();
  return answer;
}

}  // namespace stanok::channels

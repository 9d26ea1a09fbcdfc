// Probing moves: the path ends where the probe changes.
//
// Where that is comes from the drives, in the cycle that sees the change: the place is known to
// the way of one poll of the bus at the feed of the move (docs/developer/motion.md#probing).
#include "channels/cycle/channel.h"

namespace stanok::channels {

// A probe that stands as it should come to stand tells nothing about the way to go: no motion.
void Channel::begin_probing(const Item& item) RT_SAFE {
  probe_ = {};
  probe_.is_on = true;
  probe_.until_contact = item.flag;
  if (books_.inputs->is_on(figures_.probe_input) != probe_.until_contact) return;
  probe_.ends_path = true;
  const bool alarms = item.number != 0;
  if (alarms) {
    fail_run("E4322",
             probe_.until_contact ? "the probe touches before the move"
                                  : "the probe is free before the move",
             item.tag);
  }
}

void Channel::watch_probe() RT_SAFE {
  if (!probe_.is_on || resetting_) return;
  const bool touches = books_.inputs->is_on(figures_.probe_input);
  if (!probe_.ends_path && touches == probe_.until_contact) {
    probe_.has_changed = true;
    probe_.ends_path = true;
    for (std::size_t k = 0; k < motion::axes_max; ++k)
      probe_.axes_M[k] = drives_are_ideal_ ? path_.axes[k].value : feedback_[k].position;
  }
  // Behind the whole move is its request, which the answer is for.
  if (!probe_.ends_path || !interpolator_.at_rest() || link_.items.empty()) return;
  if (path_.chunks_done >= link_.items.front().after_chunk) return;
  interpolator_.drop_path(link_.path);
  interpolator_.stand_at(axes_M(), transform_);
}

void Channel::answer_probing() RT_SAFE {
  ChannelAnswer result;
  result.ok = probe_.has_changed;
  result.probe_M = probe_.axes_M;
  result.left_path = probe_.ends_path;
  answer(result);
  probe_ = {};
}

}  // namespace stanok::channels

#include "channels/stores/change_book.h"

namespace stanok::channels {

void ChangeBook::note(const InputChange& change) RT_SAFE {
  if (!is_wanted_) return;
  if (is_losing_ && changes_.space() > changes_.capacity() / 2) is_losing_ = false;
  if (!is_losing_ && changes_.push(change)) return;
  if (!is_losing_) inputs_.note_loss(change.cycle);
  is_losing_ = true;
}

void ChangeBook::note(const CycleOutput& output) RT_SAFE {
  if (!is_wanted_) return;
  for (int k = 0; k < output.channel_count; ++k) note(output.cycle, output.channels[k]);
}

void ChangeBook::note(std::int64_t cycle, const ChannelOutput& output) RT_SAFE {
  Known& known = known_[output.id];
  if (output.arrivals != known.arrivals) {
    known.arrivals = output.arrivals;
    note({.cycle = cycle, .channel = output.id, .content = output.arrivals});
  }
  if (!output.has_feedback) return;
  for (int k = 0; k < output.axis_count; ++k) {
    const AxisFeedback& told = output.feedback[k];
    if (known.has_feedback && told == known.feedback[k]) continue;
    known.feedback[k] = told;
    note({.cycle = cycle, .channel = output.id, .content = FeedbackInput{k, told}});
  }
  known.has_feedback = true;
}

}  // namespace stanok::channels

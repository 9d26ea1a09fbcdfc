#include "daemon/cycle/newest_output.h"

namespace stanok::daemon {

NewestOutput::NewestOutput(const channels::CycleOutput& first)
    : slots_(std::make_unique<std::array<channels::CycleOutput, 3>>()) {
  slots_->at(read_) = first;
}

// Channels that the machine does not have are left as they are: they are the largest part.
void NewestOutput::put(const channels::CycleOutput& output) RT_SAFE {
  channels::CycleOutput& slot = (*slots_)[written_];
  slot.cycle = output.cycle;
  slot.channel_count = output.channel_count;
  slot.signals = output.signals;
  for (int k = 0; k < output.channel_count; ++k) slot.channels[k] = output.channels[k];
  put_at_.store(clock_.now(), std::memory_order_relaxed);
  written_ = between_.exchange(written_ | is_new, std::memory_order_acq_rel) & index_mask;
}

channels::CycleOutput NewestOutput::get() {
  const std::lock_guard lock(readers_);
  if ((between_.load(std::memory_order_relaxed) & is_new) != 0)
    read_ = between_.exchange(read_, std::memory_order_acq_rel) & index_mask;
  return slots_->at(read_);
}

}  // namespace stanok::daemon

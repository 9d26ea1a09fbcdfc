#include "channels/cycle/mark_worker.h"

#include <algorithm>

#include "base/visit_in_cycle.h"
#include "motion/profile/feed_control.h"

namespace stanok::channels {
namespace {

constexpr int riders_per_cycle = 256;  // bound of work

bool has_passed(const MarkWorker::Progress& progress, const Rider& rider) RT_SAFE {
  return progress.path.run == rider.tag.run && progress.path.block >= rider.before_block &&
         !progress.stands_at_gate;
}

}  // namespace

struct MarkWorker::Execution {
  MarkWorker& worker;

  void operator()(const riders::MarkChange& change) const RT_SAFE {
    worker.is_set_[change.mark] = change.is_set;
  }
  void operator()(const riders::SoftMark& /*passed*/) const RT_SAFE {}
  void operator()(const riders::DigitalOutput& output) const RT_SAFE {
    worker.outputs_.set(output.number, output.is_on);
  }
  void operator()(const riders::AnalogOutput& output) const RT_SAFE {
    worker.outputs_.analog[output.number] = output.value;
  }
};

std::optional<motion::BlockTag> MarkWorker::advance(const Progress& progress) RT_SAFE {
  for (int n = 0; n < riders_per_cycle && !riders_.empty(); ++n) {
    const Rider rider = riders_.front();
    const bool passed = has_passed(progress, rider);
    if (!passed && !front_is_due(progress)) return std::nullopt;
    if (std::holds_alternative<riders::SoftMark>(rider.content)) {
      if (!is_open_ && passed) return rider.tag;
      is_waiting_ = !is_open_;
      if (is_waiting_) return std::nullopt;
      pass(rider);
    }
    visit_in_cycle(Execution{*this}, rider.content);
    riders_.pop_front();
  }
  return std::nullopt;
}

Wait MarkWorker::waits_for() const RT_SAFE {
  const Rider* rider = is_waiting_ && !riders_.empty() ? &riders_.front() : nullptr;
  const auto* mark = rider == nullptr ? nullptr : std::get_if<riders::SoftMark>(&rider->content);
  if (mark == nullptr) return {};
  return {.cause = WaitCause::mark, .number = mark->mark, .channels = mark->channels};
}

// The front rider is all that the channel waits for: at its gate, or before an item.
bool MarkWorker::front_is_due(const Progress& progress) const RT_SAFE {
  const std::uint64_t number = riders_.popped();
  return (is_at_gate(progress) && number <= gate_) || number < progress.riders_before_item;
}

bool MarkWorker::is_at_gate(const Progress& progress) const RT_SAFE {
  const Rider* const mark = soft_mark();
  return progress.stands_at_gate && mark != nullptr && mark->before_block <= progress.closed_block;
}

void MarkWorker::pass(const Rider& mark) RT_SAFE {
  passed_mark_ = mark;
  has_passed_mark_ = true;
  is_open_ = false;
}

void MarkWorker::find_gates() RT_SAFE {
  gate_ = std::max<std::uint64_t>(gate_, riders_.popped());
  while (gate_ < riders_.shown() && soft_mark_at(gate_) == nullptr) ++gate_;
  gate_behind_ = std::max(gate_behind_, gate_ + 1);
  while (gate_behind_ < riders_.shown() && soft_mark_at(gate_behind_) == nullptr) ++gate_behind_;
}

// The rider of this number if it is a soft mark.
const Rider* MarkWorker::soft_mark_at(std::uint64_t number) const RT_SAFE {
  if (number < riders_.popped() || number >= riders_.shown()) return nullptr;
  const Rider& rider = riders_[number - riders_.popped()];
  return std::holds_alternative<riders::SoftMark>(rider.content) ? &rider : nullptr;
}

std::uint64_t MarkWorker::closed_from_block() const RT_SAFE {
  const Rider* const mark = soft_mark_at(is_open_ ? gate_behind_ : gate_);
  return mark == nullptr ? motion::FeedControl::no_gate : mark->before_block;
}

void MarkWorker::forget_riders() RT_SAFE {
  riders_.pop_front(riders_.size());
  is_waiting_ = false;
  is_open_ = false;
}

}  // namespace stanok::channels

// The switch of kinematics on its way: axes park, brakes close, axes join, the transformation is
// exchanged.
#include <string>

#include "channels/preparation/preparation.h"
#include "channels/preparation/scheme_switch.h"

namespace stanok::channels {

bool Preparation::move_axis(int axis, double position, double velocity) {
  motion::PathBlock block;
  block.ending = motion::BlockEnding::exact_stop;
  block.end = builder_.end();
  block.end[static_cast<std::size_t>(axis)] = position;
  block.rapid = velocity <= 0.0;
  block.feed_per_s = velocity;
  block.transform = &machine_axes_transform();
  chain_open_ = true;
  if (builder_.add(block)) return false;
  collect_pieces();
  return true;
}

void Preparation::switch_scheme(const Notice& notice) {
  const SwitchPlan plan =
      plan_switch(config_, *schemes_.at(notice.number), notice.axes_M, notice.enabled);
  builder_.restart(notice.axes_M);
  Item frame = item_of(ItemKind::transform, {});
  frame.transform = &machine_axes_transform();
  push(frame);
  bool reached = true;
  for (const SwitchStep& step : plan) {
    if (step.kind == SwitchStepKind::move) {
      reached = reached && move_axis(step.axis, step.position, step.velocity);
      end_chain();
    } else {
      Item item = item_of(
          step.kind == SwitchStepKind::park ? ItemKind::park_axes : ItemKind::join_axes, {});
      item.axes = step.axes;
      push(item);
    }
    if (!reached) {
      Item failed = item_of(ItemKind::switch_failed, {});
      failed.code = FixedText<8>("E5204");
      failed.text = ShortText("the parked position of axis " + axis_word(config_, step.axis) +
                              " is beyond its limits");
      return push(failed);
    }
  }
  scheme_ = schemes_.at(notice.number).get();
  scheme_switched_ = true;
  Item set = item_of(ItemKind::scheme_set, {});
  set.number = notice.number;
  push(set);
  push(item_of(ItemKind::switch_done, {}));
}

}  // namespace stanok::channels

// The switch of kinematics on its way: axes park, brakes close, axes join, the transformation is
// exchanged.
#include <string>

#include "channels/preparation/preparation.h"
#include "channels/preparation/scheme_switch.h"

namespace stanok::channels {

void Preparation::obey(const SchemeSwitch& change) {
  const SwitchPlan plan =
      plan_switch(parts_.config, *parts_.schemes.at(change.scheme), change.axes_M, change.enabled);
  parts_.feed.begin_machine_path(change.axes_M);
  bool reached = true;
  for (const SwitchStep& step : plan) {
    if (step.kind == SwitchStepKind::move) {
      reached = reached && parts_.feed.move_axis(step.axis, step.position, step.velocity);
      parts_.feed.end_chain();
    } else {
      Item item = item_of(
          step.kind == SwitchStepKind::park ? ItemKind::park_axes : ItemKind::join_axes, {});
      item.axes = step.axes;
      parts_.feed.give(item);
    }
    if (!reached) {
      Item failed = item_of(ItemKind::switch_failed, {});
      failed.code = FixedText<8>("E5204");
      failed.text = ShortText("the parked position of axis " + axis_word(parts_.config, step.axis) +
                              " is beyond its limits");
      return parts_.feed.give(failed);
    }
  }
  parts_.scheme = parts_.schemes.at(change.scheme).get();
  scheme_switched_ = true;
  Item set = item_of(ItemKind::scheme_set, {});
  set.number = change.scheme;
  parts_.feed.give(set);
  parts_.feed.give(item_of(ItemKind::switch_done, {}));
}

}  // namespace stanok::channels

// The switch of kinematics on its way: axes park, brakes close, axes join, the transformation is
// exchanged.
#include <string>

#include "channels/preparation/preparation.h"
#include "channels/preparation/scheme_switch.h"

namespace stanok::channels {

void Preparation::switch_scheme(const Notice& notice) {
  const SwitchPlan plan =
      plan_switch(config_, *schemes_.at(notice.number), notice.axes_M, notice.enabled);
  feed_.begin_machine_path(notice.axes_M);
  bool reached = true;
  for (const SwitchStep& step : plan) {
    if (step.kind == SwitchStepKind::move) {
      reached = reached && feed_.move_axis(step.axis, step.position, step.velocity);
      feed_.end_chain();
    } else {
      Item item = item_of(
          step.kind == SwitchStepKind::park ? ItemKind::park_axes : ItemKind::join_axes, {});
      item.axes = step.axes;
      feed_.give(item);
    }
    if (!reached) {
      Item failed = item_of(ItemKind::switch_failed, {});
      failed.code = FixedText<8>("E5204");
      failed.text = ShortText("the parked position of axis " + axis_word(config_, step.axis) +
                              " is beyond its limits");
      return feed_.give(failed);
    }
  }
  scheme_ = schemes_.at(notice.number).get();
  scheme_switched_ = true;
  Item set = item_of(ItemKind::scheme_set, {});
  set.number = notice.number;
  feed_.give(set);
  feed_.give(item_of(ItemKind::switch_done, {}));
}

}  // namespace stanok::channels

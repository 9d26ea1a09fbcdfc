// What the cycle asks for while a request of the program is open: the switch of kinematics (axes
// park, brakes close, axes join, the transformation is exchanged), the way of a tap out of its
// hole.
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
      const bool parks = step.kind == SwitchStepKind::park;
      parts_.feed.give(
          {.content = AxesStep{.kind = parks ? AxesStep::Kind::park : AxesStep::Kind::join,
                               .axes = step.axes}});
    }
    if (!reached) {
      const ShortText text("the parked position of axis " + axis_word(parts_.config, step.axis) +
                           " is beyond its limits");
      return parts_.feed.give({.content = SwitchFailed{FixedText<8>("E5204"), text}});
    }
  }
  parts_.scheme = parts_.schemes.at(change.scheme).get();
  scheme_switched_ = true;
  parts_.feed.give({.content = SchemeChosen{change.scheme}});
  parts_.feed.give({.content = SwitchDone{}});
}

void Preparation::obey(const TapOut& order) {
  TapOutEnd end;
  if (const auto refusal = parts_.feed.take_tap_out(order.tap, order.axes_M)) {
    end.code = std::string_view(refusal->code);
    end.text = std::string_view(refusal->message);
  }
  parts_.feed.give({.content = end});
}

}  // namespace stanok::channels

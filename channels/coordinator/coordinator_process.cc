// What operators ask of the cutting process: overrides, interrupted feed, laws of the cycle, force.
#include <algorithm>

#include "channels/coordinator/coordinator.h"

namespace stanok::channels {
namespace {

constexpr double interruption_mm_min = 0.001;  // L_B

}  // namespace

// For the program at hand, or the next one: an operator interrupts what he sees.
Coordinator::Verdict Coordinator::interrupt_feed(const OperatorEvent& event, Channel* channel)
    RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  if (channel->axes.count() == 0) return refusal("E6029", "the channel has no axes");
  if (!(event.value >= 0.0) || (event.value > 0.0 && !(event.value_2 >= interruption_mm_min)))
    return refusal("E6029",
                   "an interruption of the feed needs L_A > 0 and L_B of 0.001 mm or more");
  channel->motion.interrupt_feed({.stand_mm = event.value, .cut_mm = event.value_2});
  return success();
}

Coordinator::Verdict Coordinator::switch_automatic_feed(const OperatorEvent& event,
                                                        Channel* channel) RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  const auto law =
      event.text.view() == "linear" ? motion::LawKind::linear : motion::LawKind::modulated;
  if (channel->process.switch_law(law, event.number != 0 ? Switch::on : Switch::off))
    return success();
  return refusal("E6030", "the machine file gives the channel no such automatic feed law");
}

Coordinator::Verdict Coordinator::control_force(const OperatorEvent& event, Channel* channel)
    RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  if (!channel->process.has_force_control())
    return refusal("E6060", "the machine file gives the channel no force control");
  const std::string_view quantity = event.text.view();
  const bool is_force = quantity.empty() || quantity == "force";
  motion::ForceOrder order;
  switch (static_cast<ForceAction>(event.number)) {
    case ForceAction::off:
      break;
    case ForceAction::on:
      if (!is_force) return refusal("E6061", "force control is switched on with a force");
      order.kind = motion::ForceOrder::Kind::force;
      order.force_n = event.value;
      break;
    case ForceAction::set:
      if (quantity.empty() || !(event.value > 0.0))
        return refusal("E6061", "a quantity is set to a value above 0");
      order.kind = motion::ForceOrder::Kind::adjust;
      if (is_force) order.force_n = event.value;
      if (quantity == "level") order.level_um = event.value;
      if (quantity == "mass") order.reduced_mass_kg = event.value;
      if (quantity == "frequency") order.oscillation_hz = event.value;
      break;
  }
  if (channel->process.order(order)) return success();
  return refusal("E6062", "no force was ordered yet: process adaptive on force N");
}

void Coordinator::set_overrides(const OperatorEvent& event, Channel& channel) RT_SAFE {
  if (event.action == OperatorAction::override_feed)
    channel.switches.set_feed_override(std::clamp(event.value, 0.0, 2.0));
  if (event.action == OperatorAction::override_rapid)
    channel.switches.set_rapid_override(std::clamp(event.value, 0.0, 1.0));
  if (event.action == OperatorAction::override_spindle)
    channel.switches.set_spindle_override(std::clamp(event.value, 0.5, 1.5));
}

}  // namespace stanok::channels

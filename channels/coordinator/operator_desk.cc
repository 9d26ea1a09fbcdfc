#include "channels/coordinator/operator_desk.h"

#include <algorithm>
#include <cmath>

namespace stanok::channels {
namespace {

std::string_view jog_refusal(std::string_view code) RT_SAFE {
  if (code == "E6006") return "the machine or the drive of the axis is off";
  if (code == "E6008") return "the drive of the axis does not hold it";
  if (code == "E6058")
    return "the scheme of the channel parks the axis: its brake is closed, its drive off; select a "
           "scheme with it";
  if (code == "E6056") return "axes of the channel are being moved by hand";
  if (code == "E6057") return "the axis stands on the limit switch at this end; jog it back";
  if (code == "E6053") return "the axis would leave its travel";
  return "the axis belongs to another channel, or is a spindle now";
}

Verdict jog(const OperatorEvent& event, Channel& channel) RT_SAFE {
  const int axis = channel.axes.named(event.text.view());
  if (axis < 0) return refusal("E6052", "the channel has no axis of that name");
  if (!std::isfinite(event.value) || event.value == 0.0 || !(event.value_2 >= 0.0) ||
      !std::isfinite(event.value_2))
    return refusal("E6054", "a jog needs a velocity that is not 0, and an increment of 0 or more");
  const std::string_view code =
      channel.jog({.axis = axis, .velocity = event.value, .increment = event.value_2});
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

// For the present program, or the next one: operators interrupt what they see.
Verdict interrupt_feed(const OperatorEvent& event, Channel& channel) RT_SAFE {
  constexpr double interruption_mm_min = 0.001;  // L_B
  if (channel.axes.count() == 0) return refusal("E6029", "the channel has no axes");
  if (!(event.value >= 0.0) || (event.value > 0.0 && !(event.value_2 >= interruption_mm_min)))
    return refusal("E6029",
                   "an interruption of the feed needs L_A > 0 and L_B of 0.001 mm or more");
  channel.motion.interrupt_feed({.stand_mm = event.value, .cut_mm = event.value_2});
  return success();
}

Verdict switch_automatic_feed(const OperatorEvent& event, Channel& channel) RT_SAFE {
  const auto law =
      event.text.view() == "linear" ? motion::LawKind::linear : motion::LawKind::modulated;
  if (channel.process.switch_law(law, event.number != 0 ? Switch::on : Switch::off))
    return success();
  return refusal("E6030", "the machine file gives the channel no such automatic feed law");
}

Verdict control_force(const OperatorEvent& event, Channel& channel) RT_SAFE {
  if (!channel.process.has_force_control())
    return refusal("E6060", "the machine file gives the channel no force control");
  const std::string_view quantity = event.text.view();
  const bool is_force = quantity.empty() || quantity == "force";
  motion::ForceCommand order;
  switch (static_cast<ForceAction>(event.number)) {
    case ForceAction::off:
      break;
    case ForceAction::on:
      if (!is_force)
        return refusal("E6061", "give the force with which force control is to be switched on");
      order.kind = motion::ForceCommand::Kind::force;
      order.force_n = event.value;
      break;
    case ForceAction::set:
      if (quantity.empty() || !(event.value > 0.0))
        return refusal("E6061", "the value of the quantity must be above 0");
      order.kind = motion::ForceCommand::Kind::adjust;
      if (is_force) order.force_n = event.value;
      if (quantity == "level") order.level_um = event.value;
      if (quantity == "mass") order.reduced_mass_kg = event.value;
      if (quantity == "frequency") order.oscillation_hz = event.value;
      break;
  }
  if (channel.process.command(order)) return success();
  return refusal("E6062", "no force was commanded yet: give one with process adaptive on force N");
}

void set_overrides(const OperatorEvent& event, Channel& channel) RT_SAFE {
  if (event.action == OperatorAction::override_feed)
    channel.switches.set_feed_override(std::clamp(event.value, 0.0, 2.0));
  if (event.action == OperatorAction::override_rapid)
    channel.switches.set_rapid_override(std::clamp(event.value, 0.0, 1.0));
  if (event.action == OperatorAction::override_spindle)
    channel.switches.set_spindle_override(std::clamp(event.value, 0.5, 1.5));
}

}  // namespace

template <class Effect>
Verdict OperatorDesk::each(Channel* named, Effect&& effect) RT_SAFE {
  for (Channel* const channel : channels_.all()) {
    if (named == nullptr || named == channel) effect(*channel);
  }
  return success();
}

std::optional<Verdict> OperatorDesk::apply(const OperatorEvent& event, Channel* channel) RT_SAFE {
  switch (event.action) {
    case OperatorAction::machine_on:
      return switch_on(channel);
    case OperatorAction::machine_off:
      return each(channel, [](Channel& c) RT_SAFE {
        c.run.begin_stop();
        c.run.power_off_at_rest();
      });
    case OperatorAction::machine_estop:
      return each(channel, [](Channel& c) RT_SAFE { c.run.stop_in_emergency(); });
    case OperatorAction::program_hold:
      return each(channel, [](Channel& c) RT_SAFE { c.switches.hold(); });
    case OperatorAction::program_resume:
      return each(channel, [](Channel& c) RT_SAFE { c.run.resume(); });
    case OperatorAction::override_feed:
    case OperatorAction::override_rapid:
    case OperatorAction::override_spindle:
      return each(channel, [&](Channel& c) RT_SAFE { set_overrides(event, c); });
    case OperatorAction::optional_stop:
      return each(channel,
                  [&](Channel& c) RT_SAFE { c.switches.set_optional_stop(event.number != 0); });
    case OperatorAction::single_block:
      return each(channel, [&](Channel& c) RT_SAFE {
        c.set_single_block(event.number != 0 ? Switch::on : Switch::off);
      });
    case OperatorAction::block_skip:
    case OperatorAction::block_skip_off:
      return skip_blocks(event, channel);
    case OperatorAction::alarm_acknowledge:
      return success();
    case OperatorAction::channel_control:
      return control_.set(event);
    case OperatorAction::tool_set:
      return set_tool(event);
    case OperatorAction::offset_set:
      return set_offset(event);
    case OperatorAction::jog:
    case OperatorAction::process_interrupt:
    case OperatorAction::process_automatic:
    case OperatorAction::process_adaptive:
      if (channel == nullptr) return refusal("E6001", "a channel must be named");
      return apply_to_one(event, *channel);
    default:
      return std::nullopt;
  }
}

std::optional<Verdict> OperatorDesk::apply_to_one(const OperatorEvent& event, Channel& channel)
    RT_SAFE {
  switch (event.action) {
    case OperatorAction::jog:
      return jog(event, channel);
    case OperatorAction::process_interrupt:
      return interrupt_feed(event, channel);
    case OperatorAction::process_automatic:
      return switch_automatic_feed(event, channel);
    case OperatorAction::process_adaptive:
      return control_force(event, channel);
    default:
      return std::nullopt;
  }
}

Verdict OperatorDesk::skip_blocks(const OperatorEvent& event, Channel* named) RT_SAFE {
  constexpr int level_max = 9;
  if (event.number < 1 || event.number > level_max)
    return refusal("E6027", "levels of block skip are 1 to 9");
  const bool on = event.action == OperatorAction::block_skip;
  return each(named, [&](Channel& c) RT_SAFE { c.switches.set_block_skip(event.number, on); });
}

Verdict OperatorDesk::switch_on(const Channel* named) RT_SAFE {
  for (int k = 0; k < channels_.count(); ++k) {
    if (named != nullptr && named != &channels_[k]) continue;
    if (!channels_[k].drives.all_answer()) return refusal("A3001", "a drive does not answer");
  }
  for (int k = 0; k < channels_.count(); ++k) {
    Channel& candidate = channels_[k];
    if (named != nullptr && named != &candidate) continue;
    // What is under way has given drives and brakes their state.
    if (!candidate.state().is_powered() || candidate.is_quiet()) candidate.power(Power::on);
  }
  return success();
}

// number = tool, value_2 = edge (0: 1), text = the name of the value.
Verdict OperatorDesk::set_tool(const OperatorEvent& event) RT_SAFE {
  const int edge = event.value_2 < 1.0 ? 1 : static_cast<int>(event.value_2);
  const int value = tool_value_named(event.text.view());
  if (value == 0 || !stores_.tables->has_place(event.number, edge))
    return refusal("E5021", "there is no such tool, edge or value");
  if (!stores_.tables->set_tool_value(event.number, edge, value, event.value, Writer::person))
    return refusal("E5020", "the value is out of range");
  return success();
}

// text = work offset and axis of the machine, "G54.1 P2 X"; R is the rotation.
Verdict OperatorDesk::set_offset(const OperatorEvent& event) RT_SAFE {
  const std::string_view text = event.text.view();
  const std::size_t blank = text.rfind(' ');
  if (blank == std::string_view::npos) return refusal("E5021", "the name of an axis is missing");
  std::string_view offset = text;
  offset.remove_suffix(text.size() - blank);
  std::string_view axis_name = text;
  axis_name.remove_prefix(blank + 1);
  const int number = work_offset_number(offset);
  const int axis = stores_.tables->column(axis_name);
  if (number == 0 || axis < 0) return refusal("E5021", "there is no such work offset or axis");
  if (!stores_.tables->set_offset(number, axis, event.value, Writer::person))
    return refusal("E5020", "the offset could not be written");
  return success();
}

}  // namespace stanok::channels

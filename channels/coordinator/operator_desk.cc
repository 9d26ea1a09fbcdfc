#include "channels/coordinator/operator_desk.h"

#include <algorithm>
#include <cmath>
#include <concepts>

#include "base/visit_in_cycle.h"
#include "channels/cycle/jogging.h"

namespace stanok::channels {
namespace {

std::string_view jog_refusal(std::string_view code) RT_SAFE {
  if (code == "E6006") return "the machine or the drive of the axis is off";
  if (code == "E6008") return "the drive of the axis does not hold its position";
  if (code == "E6058")
    return "the scheme of the channel parks the axis: its brake is closed and its drive is off; "
           "select a scheme that uses the axis";
  if (code == "E6056") return "axes of the channel are being jogged or homed";
  if (code == "E6057") return "the axis is on the limit switch at this end; jog it back";
  if (code == "E6053") return "the axis would leave its travel";
  if (code == "E6003") return "a program is running or held";
  if (code == "E6070") return "the program has not come to rest yet";
  if (code == "E6099")
    return "the held program is in a thread, measures, or changes kinematics or axes";
  if (code == "E6100") return "the way back to the path has 63 parts: return first";
  if (code == "E6096") return "its program is not held";
  if (code == "E6097") return "its axes were moved away from the path; return to it first";
  if (code == "E6102") return "nothing of the path that can be undone is left in this direction";
  if (code == "E6055")
    return "the active scheme has no straight line in this direction; jog the axes of the machine";
  if (code == "E6059")
    return "an axis of the scheme is not homed: the direction of the tool is unknown";
  return "the axis belongs to another channel, or is a spindle now";
}

Verdict jog_straight(Channel& channel, const commands::Jog& command) RT_SAFE {
  constexpr std::string_view names = "XYZ";
  const std::string_view name = command.axis.view();
  const std::size_t coordinate = name.size() == 1 ? names.find(name[0]) : names.npos;
  if (coordinate == names.npos)
    return refusal("E6052", "the directions of the tool and of the plane are X, Y and Z");
  const std::string_view code = jog(channel, command.frame, static_cast<int>(coordinate),
                                    {.velocity = command.velocity, .increment = command.increment});
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

Verdict apply_to(Channel& channel, const commands::Jog& command) RT_SAFE {
  if (!std::isfinite(command.velocity) || command.velocity == 0.0 || !(command.increment >= 0.0) ||
      !std::isfinite(command.increment))
    return refusal("E6054", "a jog needs a velocity that is not 0, and an increment of 0 or more");
  if (command.frame != JogFrame::machine) return jog_straight(channel, command);
  const int axis = channel.axes.named(command.axis.view());
  if (axis < 0) return refusal("E6052", "the channel has no axis of that name");
  const std::string_view code =
      jog(channel, {.axis = axis, .velocity = command.velocity, .increment = command.increment});
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

// The path of a held program, instead of an axis.
constexpr std::string_view along_path = "path";

Verdict turn_along_path(Channel& channel, double way) RT_SAFE {
  const std::string_view code =
      retrace(channel, {.direction = way < 0.0 ? RetraceDirection::back : RetraceDirection::forward,
                        .length = std::abs(way),
                        .surplus = RetraceOrder::Surplus::dropped});
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

Verdict apply_to(Channel& channel, const commands::Handwheel& command) RT_SAFE {
  if (!std::isfinite(command.way) || command.way == 0.0)
    return refusal("E6054", "a handwheel is turned by a way that is not 0");
  if (command.axis.view() == along_path) return turn_along_path(channel, command.way);
  const int axis = channel.axes.named(command.axis.view());
  if (axis < 0) return refusal("E6052", "the channel has no axis of that name");
  const std::string_view code = turn(channel, axis, command.way);
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

Verdict apply_to(Channel& channel, const commands::ProgramRetrace& command) RT_SAFE {
  if (!std::isfinite(command.length) || !(command.length >= 0.0))
    return refusal("E6054", "the way along the path is 0 or more");
  const std::string_view code =
      retrace(channel, {.direction = command.direction, .length = command.length});
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

// For the present program, or the next one: operators interrupt what they see.
Verdict apply_to(Channel& channel, const commands::ProcessInterrupt& command) RT_SAFE {
  constexpr double interruption_mm_min = 0.001;  // L_B
  if (channel.axes.count() == 0) return refusal("E6029", "the channel has no axes");
  if (!(command.stand_mm >= 0.0) ||
      (command.stand_mm > 0.0 && !(command.cut_mm >= interruption_mm_min)))
    return refusal("E6029",
                   "an interruption of the feed needs L_A > 0 and L_B of 0.001 mm or more");
  channel.motion.interrupt_feed({.stand_mm = command.stand_mm, .cut_mm = command.cut_mm});
  return success();
}

Verdict apply_to(Channel& channel, const commands::ProcessAutomatic& command) RT_SAFE {
  const auto law =
      command.law == AutomaticLaw::linear ? motion::LawKind::linear : motion::LawKind::modulated;
  if (channel.process.switch_law(law, command.to)) return success();
  return refusal("E6030", "the machine file has no such automatic feed law for the channel");
}

// One quantity of the force control gets another value.
motion::ForceCommand adjustment(ForceQuantity quantity, double value) RT_SAFE {
  motion::ForceCommand order;
  order.kind = motion::ForceCommand::Kind::adjust;
  if (quantity == ForceQuantity::force) order.force_n = value;
  if (quantity == ForceQuantity::level) order.level_um = value;
  if (quantity == ForceQuantity::mass) order.reduced_mass_kg = value;
  if (quantity == ForceQuantity::frequency) order.oscillation_hz = value;
  return order;
}

Verdict apply_to(Channel& channel, const commands::ProcessAdaptive& command) RT_SAFE {
  if (!channel.process.has_force_control())
    return refusal("E6060", "the machine file has no force control for the channel");
  const ForceQuantity quantity = command.quantity;
  motion::ForceCommand order;
  switch (command.action) {
    case ForceAction::off:
      break;
    case ForceAction::on:
      if (quantity != ForceQuantity::not_named && quantity != ForceQuantity::force)
        return refusal("E6061", "give the force when you switch force control on");
      order.kind = motion::ForceCommand::Kind::force;
      order.force_n = command.value;
      break;
    case ForceAction::set:
      if (quantity == ForceQuantity::not_named || !(command.value > 0.0))
        return refusal("E6061", "the value of the quantity must be above 0");
      order = adjustment(quantity, command.value);
      break;
  }
  if (channel.process.command(order)) return success();
  return refusal("E6062",
                 "no force has been commanded yet: give one with process adaptive on force N");
}

// Axes on their way back to the path stay where they are without their spindle.
Verdict apply_to(Channel& channel, const commands::SpindleSwitch& command) RT_SAFE {
  if (command.to == Switch::off) channel.run.stop_by_hand();
  channel.switches.set_spindles(command.to);
  return success();
}

Verdict apply_to(Channel& channel, const commands::CoolantSwitch& command) RT_SAFE {
  channel.switches.set_coolant(command.to);
  return success();
}

template <class Command, class... Commands>
concept OneOf = (std::same_as<Command, Commands> || ...);

template <class Command>
concept OfOneChannel =
    OneOf<Command, commands::Jog, commands::Handwheel, commands::ProgramRetrace,
          commands::ProcessInterrupt, commands::ProcessAutomatic, commands::ProcessAdaptive,
          commands::SpindleSwitch, commands::CoolantSwitch>;
template <class Command>
concept TakesTime =
    OneOf<Command, commands::ProgramLoad, commands::ProgramRun, commands::ProgramStart,
          commands::ProgramStop, commands::ProgramReset, commands::KinematicsSelect, commands::Mdi,
          commands::Home, commands::ProgramSearch, commands::ProgramReturn>;

}  // namespace

struct OperatorDesk::Application {
  using Result = std::optional<Verdict>;

  OperatorDesk& desk;
  std::int32_t channel_id;
  Channel* named;  // nullptr: all channels

  template <class Effect>
  Result each(Effect&& effect) const RT_SAFE {
    for (Channel* const channel : desk.channels_.all()) {
      if (named == nullptr || named == channel) effect(*channel);
    }
    return success();
  }
  Result skip_blocks(int level, Switch to) const RT_SAFE {
    constexpr int level_max = 9;
    if (level < 1 || level > level_max) return refusal("E6027", "levels of block skip are 1 to 9");
    return each([&](Channel& c) RT_SAFE { c.switches.set_block_skip(level, to == Switch::on); });
  }

  Result operator()(const TakesTime auto& /*command*/) const RT_SAFE { return std::nullopt; }
  Result operator()(const OfOneChannel auto& command) const RT_SAFE {
    if (named == nullptr) return refusal("E6001", "a channel must be named");
    return apply_to(*named, command);
  }
  Result operator()(const commands::MachineOn& /*command*/) const RT_SAFE {
    return desk.switch_on(named);
  }
  Result operator()(const commands::MachineOff& /*command*/) const RT_SAFE {
    return each([](Channel& c) RT_SAFE {
      c.run.begin_stop();
      c.run.power_off_at_rest();
    });
  }
  Result operator()(const commands::MachineEstop& /*command*/) const RT_SAFE {
    return each([](Channel& c) RT_SAFE { c.run.stop_in_emergency(); });
  }
  Result operator()(const commands::ProgramHold& /*command*/) const RT_SAFE {
    return each([](Channel& c) RT_SAFE { c.switches.hold(); });
  }
  Result operator()(const commands::ProgramResume& /*command*/) const RT_SAFE {
    return each([](Channel& c) RT_SAFE { c.switches.resume(); });
  }
  Result operator()(const commands::OverrideFeed& command) const RT_SAFE {
    return each([&](Channel& c) RT_SAFE {
      c.switches.set_feed_override(std::clamp(command.factor, 0.0, 2.0));
    });
  }
  Result operator()(const commands::OverrideRapid& command) const RT_SAFE {
    return each([&](Channel& c) RT_SAFE {
      c.switches.set_rapid_override(std::clamp(command.factor, 0.0, 1.0));
    });
  }
  Result operator()(const commands::OverrideSpindle& command) const RT_SAFE {
    return each([&](Channel& c) RT_SAFE {
      c.switches.set_spindle_override(std::clamp(command.factor, 0.5, 1.5));
    });
  }
  Result operator()(const commands::OptionalStop& command) const RT_SAFE {
    return each([&](Channel& c)
                    RT_SAFE { c.switches.set_optional_stop(command.to == Switch::on); });
  }
  Result operator()(const commands::FirstPart& command) const RT_SAFE {
    return each([&](Channel& c) RT_SAFE { c.switches.set_first_part(command.to); });
  }
  Result operator()(const commands::SingleBlock& command) const RT_SAFE {
    return each([&](Channel& c) RT_SAFE { c.set_single_block(command.to); });
  }
  Result operator()(const commands::BlockSkip& command) const RT_SAFE {
    return skip_blocks(command.level, Switch::on);
  }
  Result operator()(const commands::BlockSkipOff& command) const RT_SAFE {
    return skip_blocks(command.level, Switch::off);
  }
  Result operator()(const commands::AlarmAcknowledge& /*command*/) const RT_SAFE {
    return success();
  }
  Result operator()(const commands::ChannelControl& command) const RT_SAFE {
    return desk.control_.set(channel_id, command.session);
  }
  Result operator()(const commands::ToolSet& command) const RT_SAFE {
    return desk.set_tool(command);
  }
  Result touch(const auto& command) const RT_SAFE {
    if (named == nullptr) return refusal("E6001", "a channel must be named");
    if (!named->is_quiet() && !named->state().is_held())
      return refusal("E6090", "the channel is not at rest: check again when it is");
    return desk.touch(*named, command);
  }
  Result operator()(const commands::OffsetTouch& command) const RT_SAFE { return touch(command); }
  Result operator()(const commands::ToolTouch& command) const RT_SAFE { return touch(command); }
  Result operator()(const commands::OffsetSet& command) const RT_SAFE {
    return desk.set_offset(command);
  }
};

std::optional<Verdict> OperatorDesk::apply(const OperatorEvent& event, Channel* channel) RT_SAFE {
  return visit_in_cycle(Application{*this, event.channel, channel}, event.command);
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

namespace {

bool is_wear(ToolValue value) RT_SAFE {
  return value == ToolValue::wear_length || value == ToolValue::wear_length_x ||
         value == ToolValue::wear_radius;
}

}  // namespace

// Blocks to come are read with the new value, those that are prepared are not: a jump between them
// is small. `now`: a value that may change in a run.
std::optional<Verdict> OperatorDesk::refusal_in_run(std::optional<double> now, double to,
                                                    std::string_view unit) const RT_SAFE {
  bool runs = false;
  for (int k = 0; k < channels_.count(); ++k) runs = runs || channels_[k].state().is_running();
  if (!runs) return std::nullopt;
  if (!now)
    return refusal("E6101",
                   "while a program runs, only wear and work offsets can be changed, and in a hold "
                   "lengths");
  const EntryBound bound = stores_.tables->bounds().of_change_in_run(unit);
  if (bound.holds(to - *now)) return std::nullopt;
  Verdict verdict = refusal("E6101", "a program runs, and the change of ");
  verdict.text.append(reason_against(bound, to - *now).view());
  return verdict;
}

// A length counts at once in held channels; where others run as well it is bounded as in a run.
std::optional<Verdict> OperatorDesk::refusal_of_tool(const commands::ToolSet& command,
                                                     ToolValue value, double by) const RT_SAFE {
  const int along = axis_of_length(value);
  bool all_are_held = along >= 0;
  for (int k = 0; k < channels_.count(); ++k) {
    const RunState& state = channels_[k].state();
    all_are_held = all_are_held && (!state.is_running() || state.is_held());
  }
  if (!all_are_held) {
    const auto now =
        stores_.tables->tool_value(command.tool, command.edge, static_cast<int>(value));
    if (auto refused = refusal_in_run(is_wear(value) ? now : std::nullopt, command.value, "mm"))
      return refused;
  }
  if (along < 0) return std::nullopt;
  return lengths_.refusal_in_hold(lengths_.next(command.tool, command.edge, along, by));
}

Verdict OperatorDesk::set_tool(const commands::ToolSet& command) RT_SAFE {
  commands::ToolSet wanted = command;
  wanted.edge = std::max(1, command.edge);
  const int number = tool_value_named(command.key.view());
  const auto value = static_cast<ToolValue>(number);
  LiveTables& tables = *stores_.tables;
  if (number == 0 || !tables.has_place(wanted.tool, wanted.edge))
    return refusal("E5021", "there is no such tool, edge or value");
  if (wanted.tool == 0 || !can_be(value, wanted.value))
    return refusal("E5020", "the value is out of range");
  const double by =
      wanted.value - tables.tool_value(wanted.tool, wanted.edge, number).value_or(0.0);
  if (const auto refused = refusal_of_tool(wanted, value, by)) return *refused;
  if (const int along = axis_of_length(value); along >= 0)
    lengths_.apply(lengths_.next(wanted.tool, wanted.edge, along, by));
  if (!tables.set_tool_value(wanted.tool, wanted.edge, number, wanted.value, Writer::person))
    return refusal("E5020", "the value is out of range");
  settle({.tool = wanted.tool, .edge = wanted.edge});
  return success();
}

namespace {

// "G54.1 P2 X": the work offset, and the column of the axis in the table.
struct OffsetPlace {
  int number = 0;
  int column = -1;
  std::string_view axis;

  [[nodiscard]] bool exists() const RT_SAFE { return number != 0 && column >= 0; }
};

OffsetPlace offset_place(const LiveTables& tables, std::string_view text) RT_SAFE {
  const std::size_t blank = text.rfind(' ');
  if (blank == std::string_view::npos) return {};
  std::string_view offset = text;
  offset.remove_suffix(text.size() - blank);
  std::string_view axis = text;
  axis.remove_prefix(blank + 1);
  return {work_offset_number(offset), tables.layout().column(axis), axis};
}

}  // namespace

Verdict OperatorDesk::set_offset(const commands::OffsetSet& command) RT_SAFE {
  const OffsetPlace place = offset_place(*stores_.tables, command.place.view());
  if (!place.exists()) return refusal("E5021", "there is no such work offset or axis");
  const auto now = stores_.tables->offset(place.number, place.column);
  const std::string_view unit = stores_.tables->bounds().of_offset(place.column).unit;
  if (const auto refused = refusal_in_run(now, command.value, unit)) return *refused;
  if (!stores_.tables->set_offset(place.number, place.column, command.value, Writer::person))
    return refusal("E5020", "the offset could not be written");
  settle({.work_offset = place.number});
  return success();
}

namespace {

// Where an axis stands is known only when it is homed and the channel has it.
std::optional<Verdict> refusal_to_touch(const Channel& channel, int axis) RT_SAFE {
  if (!channel.axes.owns(axis) || channel.axes.is_spindle(axis))
    return refusal("E6092", "the axis belongs to another channel, or is a spindle now");
  if (channel.drives.is_homed(axis)) return std::nullopt;
  Verdict verdict = refusal("E5208", "axis ");
  verdict.text.append(channel.axes.name(axis).view()).append(" is not homed");
  return verdict;
}

}  // namespace

// p_B = offset + p_W along an axis whose frame is not rotated: the asker has seen to it, in this
// situation.
Verdict OperatorDesk::touch(const Channel& channel, const commands::OffsetTouch& command) RT_SAFE {
  const OffsetPlace place = offset_place(*stores_.tables, command.place.view());
  const int axis = place.exists() ? channel.axes.named(place.axis) : -1;
  const auto active = stores_.tables->offset(command.active, place.column);
  if (axis < 0 || !active) return refusal("E5021", "there is no such work offset or axis");
  if (const auto refused = refusal_to_touch(channel, axis)) return *refused;
  const double stands_at = channel.motion.path().point[axis].value;
  return set_offset({.place = command.place, .value = *active + stands_at - command.point_W});
}

// In a straight frame the point of the tool stands at p_W = what it is without a length - length.
Verdict OperatorDesk::touch(Channel& channel, const commands::ToolTouch& command) RT_SAFE {
  constexpr std::array<std::string_view, 3> lengths{"length_x", "length_y", "length"};
  constexpr std::array<std::string_view, 3> wears{"wear_length_x", "", "wear_length"};
  const auto found = std::find(lengths.begin(), lengths.end(), command.key.view());
  if (found == lengths.end()) return refusal("E5021", "there is no such length of a tool");
  const auto place = static_cast<std::size_t>(found - lengths.begin());
  const kinematics::Transform frame =
      kinematics::with_changes(channel.motion.frame(), channel.motion.lengths());
  const int axis = frame.frame.geometry[place];
  if (axis < 0) return refusal("E5021", "the channel has no axis for this length");
  if (const auto refused = refusal_to_touch(channel, axis)) return *refused;
  const double in_force = -frame.tool.nose_to_tip_mm[static_cast<Eigen::Index>(place)];
  const double stands_at = channel.motion.path().point[axis].value;
  const int wear = tool_value_named(wears[place]);
  const double worn =
      wear == 0 ? 0.0 : stores_.tables->tool_value(command.tool, command.edge, wear).value_or(0.0);
  return set_tool({.key = command.key,
                   .value = in_force + stands_at - command.point_W - worn,
                   .tool = command.tool,
                   .edge = command.edge});
}

// What is active of a changed row counts at once where the channel is at rest.
void OperatorDesk::settle(const lang::ChangedRows& rows) RT_SAFE {
  for (Channel* const channel : channels_.all()) channel->items().settling().want(rows);
}

}  // namespace stanok::channels

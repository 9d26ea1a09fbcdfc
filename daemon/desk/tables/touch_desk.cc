#include "daemon/desk/tables/touch_desk.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "daemon/desk/tables/entry_doubt.h"
#include "daemon/report/status_report.h"

namespace stanok::daemon {
namespace {

using channels::ShortText;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;
namespace commands = channels::commands;

Failure refused_touch(const char* code, std::string text, int channel) {
  return {FailureKind::refused, code, std::move(text), channel, {}};
}

std::string three_decimals(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", value);
  return text.data();
}

// By its word in programs, or by its name in the machine.
std::optional<std::size_t> axis_named(const channels::MachineConfig& machine,
                                      const channels::ChannelConfig& channel,
                                      const std::string& name) {
  for (std::size_t k = 0; k < channel.words.size(); ++k) {
    if (channel.words[k] == name) return k;
  }
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    if (machine.axes[channel.axes[k]].name == name) return k;
  }
  return std::nullopt;
}

// Why no value of a single axis brings the point there; empty: one does.
std::string obstacle_of(const lang::Meaning& meaning, std::size_t axis) {
  const lang::MeaningTerms& terms = *meaning.terms;
  if (!terms.frame.rotation.is_identity()) return "the coordinate system is rotated or tilted";
  if (terms.gain[axis] != 1.0 || terms.shift[axis] != 0.0) return "the axis is scaled or mirrored";
  if (terms.transformation.kind != lang::Transformation::off)
    return "a transformation (G12.1, G7.1) is active";
  if (meaning.codes[lang::Group::polar] == lang::g(16)) return "polar input (G16) is active";
  return "";
}

// The key of the tool table for a length along X, Y or Z of the channel; empty: there is none.
std::string key_of(const lang::MeaningTerms& terms, std::size_t axis) {
  constexpr std::array keys{"length_x", "length_y", "length"};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (terms.geometry.at(k).exists() && terms.geometry.at(k).place() == axis) return keys.at(k);
  }
  return "";
}

// What is in force is the row of the tool, or no length at all.
bool touches_what_is_in_force(const lang::ToolLength& length, int tool, int edge) {
  if (length.mode == lang::LengthMode::tip) return false;
  if (length.row == lang::ToolLength::Row::none) return length.offset_mm == std::array<double, 3>{};
  return length.row == lang::ToolLength::Row::added && length.tool == tool && length.edge == edge &&
         length.base_mm == std::array<double, 3>{};
}

}  // namespace

Expected<TouchDesk::Wanted, Failure> TouchDesk::wanted(const json& parameters, int channel) const {
  const channels::MachineConfig& machine = machine_.file().machine;
  const channels::ChannelConfig& config = config_of(machine, channel);
  const channels::ChannelOutput output = output_of(machine_.newest_output(), channel);
  const channels::SituationReport situation = machine_.situation(output);
  if (parameters.value("situation", situation.number) != situation.number) {
    return Unexpected<Failure>(refused_touch(
        "E6090", "codes, tool or tables have changed since then: check them again", channel));
  }
  const auto name = parameters["axis"].get<std::string>();
  const auto axis = axis_named(machine, config, name);
  if (!axis)
    return Unexpected<Failure>(refused_touch("E6052", "the channel has no axis " + name, channel));
  const std::string as = parameters.value("as", "");
  if (as.empty() && situation.meaning.is_diameter(*axis)) {
    return Unexpected<Failure>(refused_touch(
        "E6091", name + " is shown as a diameter: add as radius or as diameter", channel));
  }
  const std::string obstacle = obstacle_of(situation.meaning, *axis);
  if (!obstacle.empty()) return Unexpected<Failure>(refused_touch("E6092", obstacle, channel));
  Wanted wanted;
  wanted.situation = situation.number;
  wanted.axis = *axis;
  wanted.point_W = parameters["value"].get<double>() * (as == "diameter" ? 0.5 : 1.0);
  if (machine.axes[config.axes[*axis]].rotary) wanted.unit = "deg";
  wanted.expected = output.point_W[*axis].value - wanted.point_W;
  return wanted;
}

TouchDesk::Refusal TouchDesk::doubt(const json& parameters, const channels::OperatorCommand& entry,
                                    const Wanted& wanted, int channel) const {
  if (parameters.value("confirmed", 0) != 0) return std::nullopt;
  const channels::MachineConfig& machine = machine_.file().machine;
  const std::string reason = doubt_of_value(machine, entry);
  if (!reason.empty()) return refused_touch("E6093", reason + ": confirm the value", channel);
  const double most = machine.entry_limits.touch_off_max;
  if (std::abs(wanted.expected) <= most) return std::nullopt;
  return refused_touch("E6093",
                       "the value would change by " + three_decimals(wanted.expected) + " " +
                           wanted.unit + ", which is more than " + three_decimals(most) + " " +
                           wanted.unit + ": confirm the change",
                       channel);
}

std::optional<double> TouchDesk::value_of(const channels::OperatorCommand& place) const {
  return value_at(machine_.tables(), place);
}

void TouchDesk::touch_offset(const json& parameters, int channel, Answer answer) {
  auto found = wanted(parameters, channel);
  if (!found) return answer(Unexpected<Failure>(found.error()));
  const channels::MachineConfig& machine = machine_.file().machine;
  const channels::ChannelConfig& config = config_of(machine, channel);
  const channels::ChannelOutput output = output_of(machine_.newest_output(), channel);
  const auto& terms = *machine_.situation(output).meaning.terms;
  const std::string place =
      parameters["offset"].get<std::string>() + " " + machine.axes[config.axes[found->axis]].name;
  channels::OperatorEvent event;
  event.channel = channel;
  event.situation = found->situation;
  event.command = commands::OffsetTouch{
      .place = ShortText(place), .point_W = found->point_W, .active = terms.frame.work_offset};
  const commands::OffsetSet back{.place = ShortText(place)};
  const double value = terms.work_offset_B[found->axis] + found->expected;
  found->expected = value - value_of(back).value_or(0.0);
  const commands::OffsetSet entry{.place = back.place, .value = value};
  if (const auto refusal = doubt(parameters, entry, *found, channel))
    return answer(Unexpected<Failure>(*refusal));
  submit(event, back, std::move(answer));
}

void TouchDesk::touch_tool(const json& parameters, int channel, Answer answer) {
  auto found = wanted(parameters, channel);
  if (!found) return answer(Unexpected<Failure>(found.error()));
  const channels::ChannelOutput output = output_of(machine_.newest_output(), channel);
  const auto& terms = *machine_.situation(output).meaning.terms;
  const int tool = parameters["number"].get<int>();
  const int edge = parameters.value("edge", 1);
  const std::string key = key_of(terms, found->axis);
  if (key.empty())
    return answer(Unexpected<Failure>(
        refused_touch("E6092", "a tool has no length along this axis", channel)));
  if (!touches_what_is_in_force(terms.length, tool, edge)) {
    return answer(Unexpected<Failure>(refused_touch(
        "E6092", "the active length is not that of tool " + std::to_string(tool), channel)));
  }
  const commands::ToolSet back{.key = ShortText(key), .tool = tool, .edge = edge};
  const auto old = value_of(back);
  if (!old)
    return answer(
        Unexpected<Failure>(refused_touch("E5021", "there is no such tool or edge", channel)));
  const bool counts = terms.length.row == lang::ToolLength::Row::added;
  if (!counts) found->expected -= *old;
  commands::ToolSet entry = back;
  entry.value = *old + found->expected;
  if (const auto refusal = doubt(parameters, entry, *found, channel))
    return answer(Unexpected<Failure>(*refusal));
  channels::OperatorEvent event;
  event.channel = channel;
  event.situation = found->situation;
  event.command = commands::ToolTouch{
      .key = ShortText(key), .point_W = found->point_W, .tool = tool, .edge = edge};
  submit(event, back, std::move(answer));
}

// The answer holds what the cycle has made of it.
void TouchDesk::submit(const channels::OperatorEvent& event, const channels::OperatorCommand& back,
                       Answer answer) {
  const double before = value_of(back).value_or(0.0);
  desk_.submit(event, WaitFor::accepted,
               [this, back, before, answer = std::move(answer)](const CommandResult& outcome) {
                 if (!outcome) return answer(outcome);
                 const double after = value_of(back).value_or(before);
                 Touch touch{++touched_, back, before, after};
                 std::visit(
                     [&](auto& command) {
                       if constexpr (requires { command.value; }) command.value = before;
                     },
                     touch.back);
                 if (touches_.size() == touches_max) touches_.pop_front();
                 touches_.push_back(touch);
                 answer(json{{"old", before}, {"new", after}, {"undo", touch.number}});
               });
}

void TouchDesk::undo(const json& parameters, Answer answer) {
  const auto touch = std::ranges::find_if(
      touches_, [&](const Touch& one) { return one.number == parameters["undo"]; });
  if (touch == touches_.end())
    return answer(Unexpected<Failure>(refused_touch("E6094", "no touch-off has this number", 0)));
  if (value_of(touch->back) != touch->after) {
    return answer(Unexpected<Failure>(
        refused_touch("E6094", "the value has changed since it was touched off", 0)));
  }
  channels::OperatorEvent event;
  event.command = touch->back;
  const json told{{"old", touch->after}, {"new", touch->before}};
  desk_.submit(event, WaitFor::accepted,
               [told, answer = std::move(answer)](const CommandResult& outcome) {
                 answer(outcome ? CommandResult(told) : outcome);
               });
}

}  // namespace stanok::daemon

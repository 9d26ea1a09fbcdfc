#include "daemon/scope/scope_desk.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/enum_names.h"
#include "base/nearest_name.h"
#include "base/place.h"
#include "protocol/contract/base64.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;
using Kind = ScopeTrigger::Kind;

constexpr double length_usual_s = 2.0;

constexpr auto state_names = enum_names<ScopeState>({
    {ScopeState::off, "off"},
    {ScopeState::waiting, "waiting"},
    {ScopeState::recording, "recording"},
    {ScopeState::complete, "complete"},
});
constexpr auto trigger_names = enum_names<Kind>({
    {Kind::none, "none"},
    {Kind::level, "level"},
    {Kind::event, "event"},
    {Kind::block, "block"},
    {Kind::alarm, "alarm"},
});

Unexpected<Failure> wrong_order(std::string text) {
  return Unexpected<Failure>(
      Failure{FailureKind::invalid_parameters, "E9003", std::move(text), 0, {}});
}

// Names with blanks or commas between them.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  std::string name;
  for (const char letter : text + ' ') {
    if (letter != ' ' && letter != ',') {
      name += letter;
    } else if (!name.empty()) {
      names.push_back(std::exchange(name, {}));
    }
  }
  return names;
}

Expected<std::vector<ScopeSignal>, Failure> wanted_signals(const channels::MachineConfig& machine,
                                                           const std::string& text) {
  const std::vector<ScopeSignal> all = scope_signals(machine);
  std::vector<ScopeSignal> wanted;
  for (const std::string& name : names_in(text)) {
    const auto found = std::ranges::find(all, name, &ScopeSignal::name);
    if (found == all.end())
      return wrong_order("there is no signal " + name + "; scope.signals lists them");
    wanted.push_back(*found);
  }
  if (wanted.empty()) return wrong_order("signals names no signal");
  if (wanted.size() > Scope::signals_max) return wrong_order("signals names more than 8 signals");
  return wanted;
}

std::size_t cycles_in(double time_s, const channels::MachineConfig& machine) {
  return checked_size(std::round(time_s * 1e6 / machine.cycle_us));
}

std::optional<std::string> set_trigger(const json& parameters, ScopeOrder& order) {
  ScopeTrigger& trigger = order.trigger;
  trigger.kind = trigger_names.value(parameters.value("trigger", "none")).value_or(Kind::none);
  trigger.edge = parameters.value("edge", "rising") == "falling" ? ScopeTrigger::Edge::falling
                                                                 : ScopeTrigger::Edge::rising;
  trigger.level = parameters.value("level", 0.0);
  trigger.event = parameters.value("event", std::string());
  trigger.channel = parameters.value("channel", 0);
  trigger.line = parameters.value("line", 0U);
  if (trigger.kind == Kind::block && trigger.line == 0)
    return "a block trigger needs a line number";
  if (trigger.kind != Kind::level) return std::nullopt;
  const auto name = parameters.value("signal", order.signals.front().name);
  const auto found = std::ranges::find(order.signals, name, &ScopeSignal::name);
  if (found == order.signals.end()) return "signal must be one of the recorded signals";
  trigger.signal = checked_size(found - order.signals.begin());
  return std::nullopt;
}

std::string bytes_of(const std::vector<float>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(float));
  for (const float value : values) {
    const auto word = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<char>(word >> shift & 0xFFU));
  }
  return bytes;
}

json signal_json(const std::string& name, const std::string& unit,
                 const std::optional<double>& limit) {
  return {{"name", name}, {"unit", unit}, {"limit", limit ? json(*limit) : json(nullptr)}};
}

}  // namespace

json scope_signal_list(const channels::MachineConfig& machine) {
  json list = json::array();
  for (const ScopeSignal& signal : scope_signals(machine))
    list.push_back(signal_json(signal.name, signal.unit, signal.limit));
  return {{"signals", std::move(list)}};
}

Expected<json, Failure> start_scope(Scope& scope, const channels::MachineConfig& machine,
                                    const json& parameters) {
  auto signals = wanted_signals(machine, parameters["signals"].get<std::string>());
  if (!signals) return Unexpected<Failure>(signals.error());
  ScopeOrder order{.signals = std::move(*signals), .trigger = {}, .before = 0, .cycles = 0};
  if (const auto fault = set_trigger(parameters, order)) return wrong_order(*fault);
  const double length_s = parameters.value("length_s", length_usual_s);
  order.cycles = std::max<std::size_t>(1, cycles_in(length_s, machine));
  if (order.cycles > Scope::cycles_max)
    return wrong_order(
        "at this cycle time a recording has at most " +
        std::to_string(Scope::cycles_max * checked_size(machine.cycle_us) / 1'000'000) + " s");
  if (order.trigger.kind != Kind::none)
    order.before = cycles_in(parameters.value("before_s", length_s / 4), machine);
  if (order.before >= order.cycles) return wrong_order("before_s must be shorter than length_s");
  return json{{"id", scope.start(std::move(order))}};
}

json scope_reading(const Scope& scope, const channels::MachineConfig& machine,
                   const json& parameters) {
  const ScopeReading reading = scope.read(parameters.value("from", std::size_t{0}));
  json signals = json::array();
  for (const auto& signal : reading.signals)
    signals.push_back(signal_json(signal.name, signal.unit, signal.limit));
  const std::size_t width = std::max<std::size_t>(1, reading.signals.size());
  return {{"id", reading.id},
          {"state", std::string(state_names[reading.state])},
          {"signals", std::move(signals)},
          {"cycle_us", machine.cycle_us},
          {"first_cycle", reading.first_cycle},
          {"cycles", reading.cycles},
          {"trigger", reading.trigger_cycle ? json(*reading.trigger_cycle) : json(nullptr)},
          {"from", reading.from},
          {"count", reading.values.size() / width},
          {"values", protocol::base64(bytes_of(reading.values))}};
}

}  // namespace stanok::daemon

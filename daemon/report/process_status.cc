#include "daemon/report/process_status.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/enum_names.h"
#include "base/units.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

constexpr auto law_names = enum_names<motion::LawKind>({
    {motion::LawKind::none, ""},
    {motion::LawKind::linear, "linear"},
    {motion::LawKind::modulated, "modulated"},
    {motion::LawKind::interrupted, "interrupted"},
    {motion::LawKind::curve, "curve"},
});

constexpr auto module_state_names = enum_names<motion::ModuleState>({
    {motion::ModuleState::reset, "reset"},
    {motion::ModuleState::ready, "ready"},
    {motion::ModuleState::running, "running"},
    {motion::ModuleState::fault, "fault"},
});

// Laws that the cycle forms.
json automatic_laws(const channels::ProcessOutput& process) {
  json rows = json::array();
  for (const auto& one : process.automatic) {
    if (one.law == motion::LawKind::none) continue;
    rows.push_back({{"law", law_names[one.law]},
                    {"state", module_state_names[one.state]},
                    {"feed_part", one.part}});
  }
  return rows;
}

// How the operator interrupts the feed.
json interruption(const channels::ProcessOutput& process) {
  if (process.interruption.stand_mm <= 0.0) return nullptr;
  return {{"la_mm", process.interruption.stand_mm},
          {"lb_mm", process.interruption.cut_mm},
          {"rests", process.interruptions}};
}

constexpr auto force_state_names = enum_names<motion::ForceState>({
    {motion::ForceState::off, "off"},
    {motion::ForceState::idle_power, "idle_power"},
    {motion::ForceState::holding, "holding"},
    {motion::ForceState::regulating, "regulating"},
    {motion::ForceState::fault, "fault"},
});

constexpr auto doubt_names = enum_names<motion::PowerDoubt>({
    {motion::PowerDoubt::none, "none"},
    {motion::PowerDoubt::lost, "lost"},
    {motion::PowerDoubt::below_idle, "below_idle"},
    {motion::PowerDoubt::no_answer, "no_answer"},
    {motion::PowerDoubt::stays_high, "stays_high"},
});

constexpr auto reference_names = enum_names<motion::CutReference>({
    {motion::CutReference::none, "none"},
    {motion::CutReference::programmed, "programmed"},
    {motion::CutReference::cut, "cut"},
    {motion::CutReference::depth, "depth"},
});

// JSON has no word for "not a number".
json finite_or_null(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json force_control(const channels::ProcessOutput& process) {
  if (!process.has_force_control) return nullptr;
  const motion::ForceStatus& force = process.force;
  return {{"state", force_state_names[force.state]},
          {"force_set_n", force.force_now_n},
          {"force_n", force.force_n},
          {"power_w", finite_or_null(force.power_w)},
          {"power_idle_w", force.power_idle_w},
          {"idle_captures", force.captures},
          {"radius_mm", force.radius_mm},
          {"feed_mm_min", seconds_per_minute * force.feed_per_s},
          {"feed_min_mm_min", seconds_per_minute * force.feed_min_per_s},
          {"feed_max_mm_min", seconds_per_minute * force.feed_max_per_s},
          {"vibration_um", force.vibration_um},
          {"vibration_hz", force.vibration_hz},
          {"level_um", force.level_um},
          {"reduced_mass_kg", force.reduced_mass_kg},
          {"oscillation_n", force.oscillation_n},
          {"oscillation_hz", force.oscillation_hz},
          {"doubt", doubt_names[force.doubt]},
          {"reference", reference_names[force.reference]},
          {"force_worst_n", force.force_worst_n > 0.0 ? json(force.force_worst_n) : json(nullptr)}};
}

}  // namespace

json process_status(const channels::ChannelOutput& output) {
  const channels::ProcessOutput& process = output.process;
  const bool has_law = output.running && process.law != motion::LawKind::none;
  return {{"channel", output.id},
          {"law", has_law ? json(law_names[process.law]) : json(nullptr)},
          {"increments", has_law ? process.increments : 0},
          {"stands", process.stands},
          {"interruption", interruption(process)},
          {"automatic", automatic_laws(process)},
          {"adaptive", force_control(process)},
          {"feed_mm_min", process.feed_mm_per_min},
          {"feed_mm_rev", process.feed_mm_per_rev},
          {"spindle_rev_min", process.spindle_rev_per_min},
          {"cutting_speed_m_min", process.cutting_speed_m_per_min}};
}

}  // namespace stanok::daemon

#include "daemon/desk/process_status.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace stanok::daemon {
namespace {

using nlohmann::json;

const char* law_word(motion::LawKind law) {
  switch (law) {
    case motion::LawKind::none:
      return "";
    case motion::LawKind::linear:
      return "linear";
    case motion::LawKind::modulated:
      return "modulated";
    case motion::LawKind::interrupted:
      return "interrupted";
    case motion::LawKind::curve:
      return "curve";
  }
  return "";
}

const char* state_word(motion::ModuleState state) {
  switch (state) {
    case motion::ModuleState::reset:
      return "reset";
    case motion::ModuleState::ready:
      return "ready";
    case motion::ModuleState::running:
      return "running";
    case motion::ModuleState::fault:
      return "fault";
  }
  return "";
}

// Laws that the cycle forms.
json automatic_laws(const channels::ProcessOutput& process) {
  json rows = json::array();
  for (const auto& one : process.automatic) {
    if (one.law == motion::LawKind::none) continue;
    rows.push_back(
        {{"law", law_word(one.law)}, {"state", state_word(one.state)}, {"feed_part", one.part}});
  }
  return rows;
}

// Of the feed, by the operator.
json interruption(const channels::ProcessOutput& process) {
  if (process.interruption.stand_mm <= 0.0) return nullptr;
  return {{"la_mm", process.interruption.stand_mm},
          {"lb_mm", process.interruption.cut_mm},
          {"rests", process.interruptions}};
}

const char* force_word(motion::ForceState state) {
  switch (state) {
    case motion::ForceState::off:
      return "off";
    case motion::ForceState::idle_power:
      return "idle_power";
    case motion::ForceState::holding:
      return "holding";
    case motion::ForceState::regulating:
      return "regulating";
    case motion::ForceState::fault:
      return "fault";
  }
  return "";
}

// JSON has no word for "not a number".
json number_or_null(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json force_control(const channels::ProcessOutput& process) {
  if (!process.has_force_control) return nullptr;
  constexpr double s_per_min = 60.0;
  const motion::ForceStatus& force = process.force;
  return {{"state", force_word(force.state)},
          {"force_set_n", force.force_now_n},
          {"force_n", force.force_n},
          {"power_w", number_or_null(force.power_w)},
          {"power_idle_w", force.power_idle_w},
          {"idle_captures", force.captures},
          {"radius_mm", force.radius_mm},
          {"feed_mm_min", s_per_min * force.feed_per_s},
          {"feed_min_mm_min", s_per_min * force.feed_min_per_s},
          {"feed_max_mm_min", s_per_min * force.feed_max_per_s},
          {"vibration_um", force.vibration_um},
          {"vibration_hz", force.vibration_hz},
          {"level_um", force.level_um},
          {"reduced_mass_kg", force.reduced_mass_kg},
          {"oscillation_n", force.oscillation_n},
          {"oscillation_hz", force.oscillation_hz}};
}

}  // namespace

json process_status(const channels::ChannelOutput& output) {
  const channels::ProcessOutput& process = output.process;
  const bool has_law = output.running && process.law != motion::LawKind::none;
  return {{"channel", output.id},
          {"law", has_law ? json(law_word(process.law)) : json(nullptr)},
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

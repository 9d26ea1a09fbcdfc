#include "daemon/process_status.h"

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
          {"feed_mm_min", process.feed_mm_per_min},
          {"feed_mm_rev", process.feed_mm_per_rev},
          {"spindle_rev_min", process.spindle_rev_per_min},
          {"cutting_speed_m_min", process.cutting_speed_m_per_min}};
}

}  // namespace stanok::daemon

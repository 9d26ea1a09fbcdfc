#include "daemon/report/search_report.h"

#include <algorithm>
#include <cmath>

namespace stanok::daemon {
namespace {

using nlohmann::json;

const char* turning_word(const lang::SearchState& state, int spindle) {
  const auto found = state.spindles.find(spindle);
  if (found == state.spindles.end()) return "stop";
  switch (found->second.action) {
    case lang::SpindleAction::clockwise:
      return "clockwise";
    case lang::SpindleAction::counter_clockwise:
      return "counter_clockwise";
    case lang::SpindleAction::orient:
      return "orient";
    case lang::SpindleAction::set_speed:
    case lang::SpindleAction::stop:
      return "stop";
  }
  return "";
}

json spindles_json(const lang::SearchState& state) {
  json spindles = json::array();
  std::set<int> known;
  for (const auto& [id, command] : state.spindles) known.insert(id);
  for (const auto& [id, speed] : state.speeds) known.insert(id);
  for (const int id : known) {
    const auto speed = state.speeds.find(id);
    json spindle = {{"spindle", id},
                    {"turns", turning_word(state, id)},
                    {"speed_rev_per_min", speed == state.speeds.end() ? 0.0 : speed->second}};
    const auto mode = state.cutting_speeds.find(id);
    if (mode != state.cutting_speeds.end() && mode->second.constant)
      spindle["cutting_speed_m_per_min"] = mode->second.speed_m_per_min;
    spindles.push_back(std::move(spindle));
  }
  return spindles;
}

json omissions_json(const lang::SearchState& state) {
  json list = json::array();
  for (const auto& omission : state.omissions)
    list.push_back(
        {{"what", omission.what}, {"count", omission.count}, {"first_line", omission.first.line}});
  return list;
}

std::string coolant_text(const lang::CoolantCommand& coolant) {
  if (coolant.mist) return coolant.flood ? "mist and flood" : "mist";
  return coolant.flood ? "flood" : "off";
}

json by_word(const std::vector<std::string>& words, const std::vector<double>& values) {
  json object = json::object();
  for (std::size_t k = 0; k < values.size(); ++k) object[words[k]] = values[k];
  return object;
}

constexpr double same_place = 1e-6;  // mm, deg

bool stands_elsewhere(const channels::SearchReport& search, const channels::ChannelOutput& now) {
  for (std::size_t k = 0; k < search.axes_M.size(); ++k)
    if (std::abs(search.axes_M[k] - now.axes[static_cast<int>(k)].position) > same_place)
      return true;
  return false;
}

bool shall_turn(lang::SpindleAction action) {
  return action == lang::SpindleAction::clockwise ||
         action == lang::SpindleAction::counter_clockwise;
}

// Whether the spindle (0: the master spindle) is asked for that already, at the speed of the
// search.
bool turns_so(const channels::ProcessOutput& process, int spindle, lang::SpindleAction action,
              const lang::SearchState& state) {
  constexpr double same_speed = 1e-6;  // rev/min
  const double sign = action == lang::SpindleAction::clockwise ? 1.0 : -1.0;
  const auto speed = state.speeds.find(spindle);
  const auto is_it = [&](double rev_per_min) {
    const double now = sign * rev_per_min;
    return now > 0.0 && (speed == state.speeds.end() || std::abs(now - speed->second) < same_speed);
  };
  if (spindle == 0) return is_it(process.spindle_rev_per_min);
  return std::ranges::any_of(process.spindles, [&](const channels::SpindleSetpoint& setpoint) {
    return setpoint.id == spindle && is_it(setpoint.target_rev_per_min);
  });
}

std::string list_of(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + text;
  return list;
}

json approach_json(const channels::SearchReport& report, const channels::ChannelOutput& output) {
  using Kind = channels::SearchReport::Leg::Kind;
  json moves = json::array();
  for (const auto& leg : report.approach) {
    const bool plunges = leg.kind == Kind::plunge;
    moves.push_back({{"kind", plunges                  ? "plunge"
                              : leg.kind == Kind::lift ? "lift"
                                                       : "lateral"},
                     {"to", by_word(report.words, leg.end)},
                     {"length_mm", leg.length_mm},
                     {"feed_mm_min", plunges ? json(report.plunge_feed_mm_min) : json(nullptr)}});
  }
  return {{"number", report.number},
          {"moves", std::move(moves)},
          {"changes", changes_of_start(report, output)}};
}

}  // namespace

std::vector<std::string> changes_of_start(const channels::SearchReport& report,
                                          const channels::ChannelOutput& output) {
  const lang::SearchState& state = report.state;
  std::vector<std::string> changes;
  if (state.tool_changed && state.tool != output.tool.number)
    changes.push_back("tool " + std::to_string(state.tool) + " instead of " +
                      std::to_string(output.tool.number));
  for (const auto& [id, command] : state.spindles) {
    if (shall_turn(command.action) && !turns_so(output.process, id, command.action, state))
      changes.push_back(id == 0 ? "the spindle turning"
                                : "spindle " + std::to_string(id) + " turning");
  }
  const bool coolant_differs =
      state.coolant.mist != output.coolant.mist || state.coolant.flood != output.coolant.flood;
  if (coolant_differs) changes.push_back("coolant " + coolant_text(state.coolant));
  return changes;
}

json search_json(const channels::SearchReport& report, const channels::ChannelOutput& output) {
  const lang::SearchState& state = report.state;
  json result = {{"target", report.file + ":" + std::to_string(report.line)},
                 {"calculated", state.calculated}};
  if (!state.calculated) return result;
  result["units"] = report.meaning.inches() ? "inch" : "mm";
  result["diameter"] = json::array();
  for (std::size_t k = 0; k < report.words.size(); ++k) {
    if (report.meaning.is_diameter(k)) result["diameter"].push_back(report.words[k]);
  }
  result["point_W"] = by_word(report.words, report.point_W);
  result["position"] = by_word(report.words, report.position);
  result["stands_at"] = by_word(report.words, report.stands_at);
  result["work_offset"] = state.frame.work_offset;
  result["tool"] = state.tool;
  result["tool_prepared"] = state.tool_prepared;
  result["spindles"] = spindles_json(state);
  result["coolant"] = coolant_text(state.coolant);
  result["feed_law"] = state.feed_law.kind != lang::FeedLaw::Kind::off;
  result["force_control"] = !state.force_commands.empty();
  result["not_executed"] = omissions_json(state);
  result["approach"] = approach_json(report, output);
  return result;
}

std::optional<protocol::Failure> obstacle_to_start(RunningMachine& machine, int channel,
                                                   const nlohmann::json& parameters) {
  const auto search = machine.search(channel);
  if (!search || !search->state.calculated) return std::nullopt;
  const auto refused = [&](const char* code, const std::string& text) {
    return protocol::Failure{protocol::FailureKind::refused, code, text, channel, {}};
  };
  const std::string target = search->file + ":" + std::to_string(search->line);
  const std::string number = std::to_string(search->number);
  const auto given = parameters.value("approach", std::uint32_t{0});
  if (given == 0)
    return refused("E6045", "the program would begin at " + target +
                                ": check the approach and give its number, " + number);
  const channels::CycleOutput output = machine.newest_output();
  const channels::ChannelOutput* const now = output.of_channel(channel);
  if (now == nullptr || given != search->number || now->tag.situation != search->situation ||
      stands_elsewhere(*search, *now))
    return refused("E6046", "axes, tool or tables have changed since " + target + " was searched");
  const auto changes = changes_of_start(*search, *now);
  if (!changes.empty() && parameters.value("restore", 0) == 0)
    return refused("E6047", "the program needs at " + target + ": " + list_of(changes));
  return std::nullopt;
}

}  // namespace stanok::daemon

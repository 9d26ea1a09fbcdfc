#include "daemon/report/channel_display.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace stanok::daemon {
namespace {

using nlohmann::json;

const char* direction_word(double rev_per_min) {
  if (rev_per_min > 0.0) return "clockwise";
  return rev_per_min < 0.0 ? "counter-clockwise" : "stopped";
}

// nullptr: there is none that answers.
const drives::DriveFeedback* feedback_of(int spindle, const drives::BusStatus& bus) {
  const std::string name = "S" + std::to_string(spindle);
  const auto drive = std::find_if(bus.axes.begin(), bus.axes.end(),
                                  [&](const auto& status) { return status.axis == name; });
  return drive == bus.axes.end() || !drive->in_contact ? nullptr : &drive->feedback;
}

json measured(int spindle, const drives::BusStatus& bus) {
  const auto* feedback = feedback_of(spindle, bus);
  return feedback == nullptr ? json(nullptr) : json(feedback->velocity);
}

json measured_power(int spindle, const drives::BusStatus& bus) {
  const auto* feedback = feedback_of(spindle, bus);
  return feedback == nullptr || !std::isfinite(feedback->power_w) ? json(nullptr)
                                                                  : json(feedback->power_w);
}

}  // namespace

json tool_at_work(const channels::ToolAtWork& tool, const channels::TablesConfig& tables) {
  const auto row = std::find_if(tables.tools.begin(), tables.tools.end(), [&](const auto& edge) {
    return edge.number == tool.number && edge.edge == tool.edge;
  });
  const bool has_name = tool.number != 0 && row != tables.tools.end() && !row->name.empty();
  return {{"number", tool.number},
          {"edge", tool.edge},
          {"name", has_name ? json(row->name) : json(nullptr)}};
}

json spindles_of(const channels::ChannelConfig& config, const channels::ChannelOutput& output,
                 const drives::BusStatus& bus) {
  json spindles = json::array();
  for (const int id : config.spindles) {
    const auto& asked = output.process.spindles;
    const auto at =
        std::find_if(asked.begin(), asked.end(),
                     [&](const channels::SpindleSetpoint& one) { return one.id == id; });
    const double commanded = at == asked.end() ? 0.0 : at->rev_per_min;
    spindles.push_back({{"id", id},
                        {"direction", direction_word(commanded)},
                        {"commanded_rev_min", commanded},
                        {"actual_rev_min", measured(id, bus)},
                        {"power_w", measured_power(id, bus)}});
  }
  return spindles;
}

json wait_of(const channels::ChannelOutput& output) {
  if (output.wait.cause == channels::WaitCause::nothing) return nullptr;
  json waited = json::array();
  for (int id = 0; id < 32; ++id) {
    const bool is_other = id != output.id;
    if (is_other && (output.wait.channels >> static_cast<unsigned>(id) & 1U) != 0)
      waited.push_back(id);
  }
  const bool has_number = output.wait.cause == channels::WaitCause::mark ||
                          output.wait.cause == channels::WaitCause::input;
  return {{"for", channels::name_of(output.wait.cause)},
          {"number", has_number ? json(output.wait.number) : json(nullptr)},
          {"channels", std::move(waited)}};
}

json work_offset_of(const std::vector<std::string>& g_codes) {
  const auto code = std::find_if(g_codes.begin(), g_codes.end(), [](const std::string& one) {
    return one.size() >= 3 && one.starts_with("G5") && one[2] >= '4' && one[2] <= '9';
  });
  return code == g_codes.end() ? json(nullptr) : json(*code);
}

json retrace_of(const channels::RetraceState& state) {
  json line = nullptr;
  if (state.line != 0) line = state.line;
  return {{"blocks", state.blocks_back}, {"to_line", state.oldest_line}, {"line", std::move(line)}};
}

json coolant_of(const std::vector<std::string>& m_codes) {
  json coolant = json::array();
  for (const std::string& code : m_codes) {
    if (code == "M7" || code == "M8") coolant.push_back(code == "M7" ? "mist" : "flood");
  }
  return coolant;
}

lang::ActiveCodes codes_in_effect(const lang::Meaning& meaning,
                                  const channels::ChannelOutput& output) {
  lang::ActiveCodes codes = meaning.codes;
  const double target = output.process.spindles[0].target_rev_per_min;
  const lang::CodeNumber turns = target > 0.0 ? lang::m(3) : lang::m(4);
  if (target != 0.0) codes[lang::Group::spindle] = turns;
  codes[lang::Group::mist] = output.coolant.mist ? lang::m(7) : lang::m(9);
  codes[lang::Group::flood] = output.coolant.flood ? lang::m(8) : lang::m(9);
  return codes;
}

namespace {

json values_by_word(const channels::ChannelConfig& config, const lang::AxisValues& values) {
  json words = json::object();
  for (std::size_t k = 0; k < config.words.size(); ++k) words[config.words[k]] = values[k];
  return words;
}

lang::AxisValues point_W(const channels::ChannelOutput& output) {
  lang::AxisValues point{};
  for (std::size_t k = 0; k < point.size(); ++k) point[k] = output.point_W[k].value;
  return point;
}

}  // namespace

json position_of(const channels::ChannelConfig& config, const channels::ChannelOutput& output,
                 const lang::Meaning& meaning) {
  return values_by_word(config, lang::words_at(meaning, point_W(output)));
}

json point_of(const channels::ChannelConfig& config, const channels::ChannelOutput& output) {
  return values_by_word(config, point_W(output));
}

json diameters_of(const channels::ChannelConfig& config, const lang::Meaning& meaning) {
  json diameters = json::array();
  for (std::size_t k = 0; k < config.words.size(); ++k) {
    if (meaning.is_diameter(k)) diameters.push_back(config.words[k]);
  }
  return diameters;
}

json distance_to_go(const channels::ChannelConfig& config, const channels::ChannelOutput& output,
                    const channels::SituationReport& situation) {
  if (!output.running) return nullptr;
  lang::AxisValues way_W{};
  for (std::size_t k = 0; k < way_W.size() && situation.end_W; ++k)
    way_W[k] = (*situation.end_W)[k] - output.point_W[k].value;
  return values_by_word(config, lang::words_of_way(situation.meaning, way_W));
}

}  // namespace stanok::daemon

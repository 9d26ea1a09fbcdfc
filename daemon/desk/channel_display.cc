#include "daemon/desk/channel_display.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace stanok::daemon {
namespace {

using nlohmann::json;

const char* direction_word(double rev_per_min) {
  if (rev_per_min > 0.0) return "clockwise";
  return rev_per_min < 0.0 ? "counter-clockwise" : "stopped";
}

json measured(int spindle, const drives::BusStatus& bus) {
  const std::string name = "S" + std::to_string(spindle);
  const auto drive = std::find_if(bus.axes.begin(), bus.axes.end(),
                                  [&](const auto& status) { return status.axis == name; });
  if (drive == bus.axes.end() || !drive->in_contact) return nullptr;
  return drive->feedback.velocity;
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
                        {"actual_rev_min", measured(id, bus)}});
  }
  return spindles;
}

json distance_to_go(const channels::ChannelConfig& config, const channels::ChannelOutput& output,
                    const channels::BlockReport& block) {
  if (!output.running) return nullptr;
  json distances = json::object();
  for (std::size_t k = 0; k < config.words.size(); ++k)
    distances[config.words[k]] = block.end_W ? (*block.end_W)[k] - output.point_W[k].value : 0.0;
  return distances;
}

}  // namespace stanok::daemon

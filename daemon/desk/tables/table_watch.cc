#include "daemon/desk/tables/table_watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "daemon/report/inventory.h"

namespace stanok::daemon {

using nlohmann::json;

TableWatch::Values TableWatch::values() const {
  Values values;
  const channels::TablesConfig tables = machine_.tables();
  for (const channels::ToolEdge& tool : tables.tools) {
    const std::string name =
        "T" + std::to_string(tool.number) + "." + std::to_string(tool.edge) + " ";
    const json edge = tool_json(tool);
    for (const auto& [key, value] : edge.items()) {
      const bool is_name = key == "number" || key == "edge";
      if (value.is_number() && !is_name) values[name + key] = value.get<double>();
    }
  }
  for (const auto& [name, row] : tables.offsets) {
    for (const auto& [axis, value] : row) values[fmt::format("{} {}", name, axis)] = value;
  }
  return values;
}

bool TableWatch::compare(const std::string& by, double time_s) {
  Values now = values();
  const bool has_changed = is_known_ && now != known_;
  if (has_changed) {
    // What a table does not name is nought.
    Values all = known_;
    for (const auto& [what, value] : now) all.emplace(what, 0.0);
    for (const auto& [what, value] : all) {
      const auto known = known_.find(what);
      const auto found = now.find(what);
      const double from = known == known_.end() ? 0.0 : known->second;
      const double to = found == now.end() ? 0.0 : found->second;
      if (from != to)
        changes_.push_front({.time_s = time_s, .by = by, .what = what, .from = from, .to = to});
    }
    if (changes_.size() > changes_max) changes_.resize(changes_max);
  }
  known_ = std::move(now);
  is_known_ = true;
  return has_changed;
}

void TableWatch::note(const std::string& by, double time_s) {
  compare(by, time_s);
}

std::string TableWatch::newest_program() const {
  const std::vector<channels::RunReport> runs = machine_.runs();
  const auto newest = std::ranges::max_element(
      runs, {}, [](const channels::RunReport& run) { return run.begun_at; });
  return newest == runs.end() ? "" : newest->program;
}

bool TableWatch::look(double time_s) {
  const channels::CycleOutput output = machine_.newest_output();
  Standing now;
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    if (channel.running) return false;
    now[channel.id] = {channel.run, channel.scheme};
  }
  if (is_known_ && now == standing_) return false;
  bool is_other = false;
  for (const auto& [channel, standing] : now) {
    const auto before = standing_.find(channel);
    // Without axes, or before it has told of itself, a channel has no scheme.
    if (before != standing_.end() && before->second.second != 0)
      is_other = is_other || before->second.second != standing.second;
  }
  standing_ = std::move(now);
  const bool was_known = is_known_;
  return compare(newest_program(), time_s) || (was_known && is_other);
}

json TableWatch::history() const {
  json changes = json::array();
  for (const Change& change : changes_) {
    changes.push_back({{"time_s", change.time_s},
                       {"by", change.by},
                       {"what", change.what},
                       {"from", change.from},
                       {"to", change.to}});
  }
  return {{"changes", std::move(changes)}};
}

}  // namespace stanok::daemon

#include "jobs/tools/foreign_reader.h"

#include <algorithm>
#include <cmath>

#include "jobs/tools/foreign_text.h"
#include "jobs/tools/tool_values.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

// What a file of ten thousand wrong lines shows of them.
constexpr std::size_t faults_max = 100;

std::string tool_text(int number, int edge) {
  const std::string text = "tool " + std::to_string(number);
  return edge == 1 ? text : text + " edge " + std::to_string(edge);
}

std::string unit_text(const ToolKey& key) {
  return key.unit.empty() ? "" : " " + std::string(key.unit);
}

}  // namespace

void ForeignReader::fault(const ForeignPlace& place, const std::string& text) {
  if (faults_.size() == faults_max) {
    faults_.push_back({.file = file_, .text = "there are more faults; correct these first"});
  }
  if (faults_.size() > faults_max) return;
  faults_.push_back({.file = place.file.empty() ? file_ : place.file,
                     .line = place.line,
                     .column = place.column,
                     .text = place.member.empty() ? text : place.member + ": " + text});
}

bool ForeignReader::has_number(int number, int edge) {
  const config::Allowed numbers = tool_key("number").allowed;
  const config::Allowed edges = tool_key("edge").allowed;
  if (number >= numbers.min && number <= numbers.max && edge >= edges.min && edge <= edges.max) {
    return true;
  }
  lose({.tool = number,
        .edge = edge,
        .field = "tool",
        .value = tool_text(number, edge),
        .reason = "tools of stanok have the numbers 1 to " + plain_number(numbers.max) +
                  " and the edges 1 to " + plain_number(edges.max)});
  return false;
}

ForeignTool* ForeignReader::begin(int number, int edge, const ForeignPlace& place) {
  if (!has_number(number, edge)) return nullptr;
  const auto [entry, is_new] = tools_.try_emplace({number, edge});
  if (!is_new) {
    fault(place, tool_text(number, edge) +
                     " appears twice; give each tool a number of its own in the program that "
                     "wrote the file");
    return nullptr;
  }
  entry->second.edge.number = number;
  entry->second.edge.edge = edge;
  places_[{number, edge}] = place;
  return &entry->second;
}

ForeignTool* ForeignReader::tool(int number, const ForeignPlace& place) {
  const auto found = tools_.find({number, 1});
  return found == tools_.end() ? begin(number, 1, place) : &found->second;
}

void ForeignReader::give(ForeignTool& tool, std::string_view name, double value,
                         const ForeignPlace& place) {
  const ToolKey& key = tool_key(name);
  // -0 + 0 is 0.
  const bool is_allowed = value >= key.allowed.min && value <= key.allowed.max;
  if (!std::isfinite(value) || !is_allowed || !set_number(tool.edge, key, value + 0.0)) {
    fault(place, std::string(name) + " of " + tool_text(tool.edge.number, tool.edge.edge) + " is " +
                     config::number_text(value) + unit_text(key) + "; it must be " + range_of(key) +
                     "; check the value and its unit");
    return;
  }
  if (!is_given(tool, name)) tool.given.push_back(key.name);
}

void ForeignReader::give_text(ForeignTool& tool, std::string_view name, std::string_view text) {
  const ToolKey& key = tool_key(name);
  set_text(tool.edge, key, std::string(text));
  if (!is_given(tool, name)) tool.given.push_back(key.name);
}

void ForeignReader::check_corners() {
  for (const auto& [number, tool] : tools_) {
    const ToolEdge& edge = tool.edge;
    if (edge.corner_radius <= edge.radius) continue;
    fault(places_[number], "the corner radius of " + tool_text(edge.number, edge.edge) + ", " +
                               config::number_text(edge.corner_radius) +
                               " mm, exceeds its radius, " + config::number_text(edge.radius) +
                               " mm; correct one of them");
  }
}

ForeignTools ForeignReader::finish() {
  check_corners();
  if (tools_.empty() && faults_.empty()) {
    const std::string reason =
        found_.not_carried.empty() ? "" : ": " + found_.not_carried.front().reason;
    fault({}, "no tool that can be carried" + reason + "; check the file and --format");
  }
  if (!faults_.empty()) throw config::ConfigError(std::move(faults_));
  for (auto& [number, tool] : tools_) found_.tools.push_back(std::move(tool));
  return std::move(found_);
}

bool is_given(const ForeignTool& tool, std::string_view key) {
  return std::ranges::find(tool.given, key) != tool.given.end();
}

}  // namespace stanok::jobs

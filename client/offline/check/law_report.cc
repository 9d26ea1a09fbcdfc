#include "client/offline/check/law_report.h"

#include <fmt/format.h>

#include <optional>

#include "client/terminal/diagnostic_output.h"
#include "client/terminal/text_table.h"
#include "protocol/contract/plane_json.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

const char* name_of_law(const jobs::LawBlock& block) {
  switch (block.kind) {
    case motion::LawKind::none:
      break;
    case motion::LawKind::linear:
      if (block.units.speed == motion::LawSpeed::rev_per_min) return "spindle speed";
      return block.units.speed == motion::LawSpeed::m_per_min ? "cutting speed" : "linear";
    case motion::LawKind::modulated:
      return "modulated";
    case motion::LawKind::interrupted:
      return "interrupted";
    case motion::LawKind::curve:
      return "curve";
  }
  return "none";
}

const char* unit_of(const jobs::LawBlock& block) {
  return block.units.per_revolution ? "mm/rev" : "mm/min";
}

std::string cell(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "";
}

std::optional<double> cycle_of(const motion::LawEstimate& estimate) {
  return estimate.cycle ? std::optional(estimate.cycle->exact) : std::nullopt;
}

std::vector<std::string> cells_of_law(const jobs::LawBlock& block) {
  const motion::LawEstimate& e = block.estimate;
  return {fmt::format("{}:{}", block.place.file, block.place.line),
          name_of_law(block),
          fmt::format("{:.3f}", block.path_mm),
          std::to_string(e.increments),
          fmt::format("{:.6g}", e.feed_first),
          fmt::format("{:.6g}", e.feed_last),
          unit_of(block),
          fmt::format("{}{:.4f}", block.time_is_least ? ">= " : "", e.time_s),
          cell(e.closed_form_s, "{:.4f}"),
          cell(cycle_of(e), "{:.4f}"),
          cell(e.duration_rev, "{:.4g}"),
          cell(e.spacing_rev, "{:.4g}"),
          cell(e.modulation_depth, "{:.4g}")};
}

void put(ordered_json& json, const char* name, const std::optional<double>& value) {
  if (value) json[name] = *value;
}

ordered_json fields_of_law(const jobs::LawBlock& block) {
  const motion::LawEstimate& e = block.estimate;
  ordered_json json = {{"file", block.place.file},   {"line", block.place.line},
                       {"law", name_of_law(block)},  {"path_mm", block.path_mm},
                       {"increments", e.increments}, {"feed_first", e.feed_first},
                       {"feed_last", e.feed_last},   {"feed_unit", unit_of(block)},
                       {"time_s", e.time_s},         {"time_is_least", block.time_is_least}};
  put(json, "closed_form_s", e.closed_form_s);
  put(json, "cycle_s", cycle_of(e));
  if (e.cycle) put(json, "cycle_closed_form_s", e.cycle->corrected);
  put(json, "k_a", e.duration_rev);
  put(json, "k_b", e.spacing_rev);
  put(json, "k_m", e.modulation_depth);
  return json;
}

}  // namespace

std::string estimate_table(const std::vector<CheckedProgram>& programs, const Terminal& terminal) {
  TextTable table({"block", "law", "mm", "increments", "from", "to", "unit", "s", "closed form",
                   "cycle s", "K_A", "K_B", "K_M"});
  bool any = false;
  for (const CheckedProgram& program : programs) {
    for (const jobs::LawBlock& block : program.laws) table.add_row(cells_of_law(block));
    any = any || !program.laws.empty();
  }
  return any ? table.text(terminal) : "no feed laws\n";
}

ordered_json estimate_json(const std::vector<CheckedProgram>& programs) {
  ordered_json json = {{"diagnostics", ordered_json::array()},
                       {"feed_laws", ordered_json::array()},
                       {"tilted_planes", ordered_json::array()}};
  for (const CheckedProgram& program : programs) {
    for (const Diagnostic& d : program.diagnostics) json["diagnostics"].push_back(to_json(d));
    for (const jobs::LawBlock& block : program.laws)
      json["feed_laws"].push_back(fields_of_law(block));
    for (auto& plane : protocol::plane_json(program.planes))
      json["tilted_planes"].push_back(std::move(plane));
  }
  return json;
}

}  // namespace stanok::client

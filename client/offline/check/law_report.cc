#include "client/offline/check/law_report.h"

#include <fmt/format.h>

#include <optional>

#include "client/terminal/diagnostic_output.h"
#include "client/terminal/text_table.h"
#include "jobs/dry_run/law_fields.h"
#include "protocol/contract/fields_json.h"
#include "protocol/contract/plane_json.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

std::string cell(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "";
}

std::vector<std::string> cells(const jobs::LawBlock& block) {
  const motion::LawEstimate& e = block.estimate;
  return {fmt::format("{}:{}", block.place.file, block.place.line),
          law_name(block),
          fmt::format("{:.3f}", block.path_mm),
          std::to_string(e.increments),
          fmt::format("{:.6g}", e.feed_first),
          fmt::format("{:.6g}", e.feed_last),
          feed_unit(block),
          fmt::format("{}{:.4f}", block.time_is_least ? ">= " : "", e.time_s),
          cell(e.closed_form_s, "{:.4f}"),
          cell(jobs::cycle_time_s(e), "{:.4f}"),
          cell(e.duration_rev, "{:.4g}"),
          cell(e.spacing_rev, "{:.4g}"),
          cell(e.modulation_depth, "{:.4g}")};
}

}  // namespace

std::string estimate_table(const std::vector<CheckedProgram>& programs, const Terminal& terminal) {
  TextTable table({"block", "law", "mm", "increments", "from", "to", "unit", "s", "closed form",
                   "cycle s", "K_A", "K_B", "K_M"});
  bool any = false;
  for (const CheckedProgram& program : programs) {
    for (const jobs::LawBlock& block : program.laws) table.add_row(cells(block));
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
      json["feed_laws"].push_back(protocol::fields_json(jobs::law_fields(block)));
    for (auto& plane : protocol::plane_json(program.planes))
      json["tilted_planes"].push_back(std::move(plane));
  }
  return json;
}

}  // namespace stanok::client

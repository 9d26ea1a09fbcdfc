#include "client/offline/check/check_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/place.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/screen_text.h"
#include "client/terminal/text_table.h"
#include "protocol/contract/plane_json.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

struct Totals {
  std::uint64_t blocks = 0;
  std::size_t errors = 0;
  std::size_t warnings = 0;
  double seconds = 0.0;
};

std::size_t count_of(const Diagnostics& diagnostics, Severity severity) {
  return checked_size(std::ranges::count(diagnostics, severity, &Diagnostic::severity));
}

Totals totals_of(const CheckedProgram& program) {
  return {program.blocks, count_of(program.diagnostics, Severity::error),
          count_of(program.diagnostics, Severity::warning), program.seconds};
}

Totals totals_of(const std::vector<CheckedProgram>& programs) {
  Totals sum;
  for (const CheckedProgram& program : programs) {
    const Totals one = totals_of(program);
    sum.blocks += one.blocks;
    sum.errors += one.errors;
    sum.warnings += one.warnings;
    sum.seconds += one.seconds;
  }
  return sum;
}

std::vector<std::string> cells_of_totals(const std::string& name, const Totals& totals) {
  return {name, std::to_string(totals.blocks), std::to_string(totals.errors),
          std::to_string(totals.warnings), fmt::format("{:.3f}", totals.seconds)};
}

ordered_json fields_of_totals(const Totals& totals) {
  return {{"blocks", totals.blocks},
          {"errors", totals.errors},
          {"warnings", totals.warnings},
          {"seconds", totals.seconds}};
}

}  // namespace

std::string summary_table(const std::vector<CheckedProgram>& programs, const Terminal& terminal) {
  TextTable table({"program", "blocks", "errors", "warnings", "seconds"});
  for (const CheckedProgram& program : programs) {
    table.add_row(cells_of_totals(program.file, totals_of(program)));
  }
  const auto faulty = std::count_if(programs.begin(), programs.end(), [](const CheckedProgram& p) {
    return has_errors(p.diagnostics);
  });
  const std::string sum = fmt::format("{} programs, {} with errors", programs.size(), faulty);
  table.add_row(cells_of_totals(sum, totals_of(programs)));
  return table.text(terminal);
}

ordered_json summary_json(const std::vector<CheckedProgram>& programs) {
  ordered_json json;
  json["files"] = ordered_json::array();
  for (const CheckedProgram& program : programs) {
    ordered_json one = {{"file", program.file}};
    one.update(fields_of_totals(totals_of(program)));
    one["diagnostics"] = ordered_json::array();
    for (const Diagnostic& d : program.diagnostics) one["diagnostics"].push_back(to_json(d));
    one["tilted_planes"] = protocol::plane_json(program.planes);
    json["files"].push_back(std::move(one));
  }
  json["totals"] = fields_of_totals(totals_of(programs));
  return json;
}

}  // namespace stanok::client

#include "client/command_line/explain_command.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/catalogue.h"
#include "base/enum_names.h"
#include "client/terminal/output.h"
#include "client/terminal/screen_text.h"

namespace stanok::client {
namespace {

using nlohmann::json;

struct ExplainOptions {
  std::string code;
  bool json = false;
};

constexpr auto reaction_texts = enum_names<Reaction, 1>({
    {Reaction::warning, "warning, nothing stops"},
    {Reaction::program_end, "the program ends after the prepared blocks"},
    {Reaction::program_abort, "the program ends at once"},
    {Reaction::feed_hold, "feed hold of the channel"},
    {Reaction::axis_stop, "the faulty axis stops, the others hold"},
    {Reaction::all_axes_off, "all axes off"},
});

json row_json(const CatalogueRow& row) {
  return {{"code", row.code},
          {"title", row.title},
          {"reaction", static_cast<int>(row.reaction)},
          {"remedy", row.remedy},
          {"go_on", row.go_on}};
}

// The row of a code; those of a number without its letter.
std::vector<const CatalogueRow*> rows_of_code(const std::string& code) {
  if (const CatalogueRow* const row = find_in_catalogue(in_capitals(code))) return {row};
  std::vector<const CatalogueRow*> rows;
  for (const CatalogueRow& row : catalogue()) {
    if (row.code.substr(1) == code) rows.push_back(&row);
  }
  return rows;
}

int explain(const ExplainOptions& options) {
  const auto rows = rows_of_code(options.code);
  if (rows.empty()) {
    write_message("there is no code " + options.code +
                  "; docs/reference/alarms.md lists all of them\n");
    return 1;
  }
  if (options.json && rows.size() == 1) {
    write_json(row_json(*rows.front()));
  } else if (options.json) {
    json list = json::array();
    for (const CatalogueRow* row : rows) list.push_back(row_json(*row));
    write_json(list);
  } else {
    for (const CatalogueRow* row : rows) write_data(explanation(std::string(row->code)));
  }
  return 0;
}

}  // namespace

std::string explanation(const std::string& code) {
  const CatalogueRow* row = find_in_catalogue(in_capitals(code));
  if (row == nullptr) return "";
  return std::string(row->code) + ": " + std::string(row->title) +
         "\n  reaction: " + std::string(reaction_texts[row->reaction]) +
         "\n  remedy:   " + std::string(row->remedy) + "\n  go on:    " + std::string(row->go_on) +
         "\n";
}

void add_explain_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand("explain", "tell what a code means and what to do");
  command->add_option("CODE", options->code, "code of the catalogue, as E7001, or its number")
      ->required();
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = explain(*options); });
}

}  // namespace stanok::client

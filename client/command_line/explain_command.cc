#include "client/command_line/explain_command.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/catalogue.h"
#include "client/terminal/output.h"

namespace stanok::client {
namespace {

using nlohmann::json;

struct ExplainOptions {
  std::string code;
  bool json = false;
};

std::string_view words_of(Reaction reaction) {
  switch (reaction) {
    case Reaction::warning:
      return "warning, nothing stops";
    case Reaction::program_end:
      return "the program ends after the prepared blocks";
    case Reaction::program_abort:
      return "the program ends at once";
    case Reaction::feed_hold:
      return "feed hold of the channel";
    case Reaction::axis_stop:
      return "the faulty axis stops, the others hold";
    case Reaction::all_axes_off:
      return "all axes off";
  }
  return "";
}

std::string upper(std::string code) {
  std::transform(code.begin(), code.end(), code.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return code;
}

json row_json(const CatalogueRow& row) {
  return {{"code", row.code},
          {"title", row.title},
          {"reaction", static_cast<int>(row.reaction)},
          {"remedy", row.remedy},
          {"go_on", row.go_on}};
}

int explain(const ExplainOptions& options) {
  const CatalogueRow* row = find_in_catalogue(upper(options.code));
  if (row == nullptr) {
    write_message("no such code: " + options.code + "\n");
    return 1;
  }
  if (options.json) {
    write_json(row_json(*row));
  } else {
    write_data(explanation(options.code));
  }
  return 0;
}

}  // namespace

std::string explanation(std::string code) {
  const CatalogueRow* row = find_in_catalogue(upper(std::move(code)));
  if (row == nullptr) return "";
  return std::string(row->code) + ": " + std::string(row->title) +
         "\n  reaction: " + std::string(words_of(row->reaction)) +
         "\n  remedy:   " + std::string(row->remedy) + "\n  go on:    " + std::string(row->go_on) +
         "\n";
}

void add_explain_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand("explain", "what a code means and what to do");
  command->add_option("CODE", options->code, "code of the catalogue, as E7001")->required();
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = explain(*options); });
}

}  // namespace stanok::client

#include "client/offline/history/history_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/terminal/exit_codes.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"
#include "client/terminal/text_table.h"
#include "gateway/history/answers.h"
#include "gateway/history/queries.h"
#include "gateway/outbox/wall_clock.h"
#include "protocol/contract/socket_location.h"

namespace stanok::client {
namespace {

using gateway::ColumnKind;
using gateway::History;
using nlohmann::json;

constexpr const char* noun = "history";
constexpr const char* noun_help = "earlier runs: logs of a machine; runs, alarms and use of a cell";

struct HistoryOptions {
  std::string database;
  std::string since = "30d";
  std::string machine;
  bool json = false;
  std::string from;
  std::string to;
};

double since_s(const std::string& text) {
  if (const auto time_s = gateway::time_back_from_now(text)) return *time_s;
  throw CLI::ValidationError("--since wants a time back from now, like 30d, 12h or 45min");
}

std::string usual_database() {
  const char* named = std::getenv("STANOK_HISTORY");  // NOLINT(concurrency-mt-unsafe)
  if (named != nullptr && *named != '\0') return named;
  return protocol::default_state_directory("gateway") / "history.sqlite";
}

std::string cell_of(const gateway::Value& value, ColumnKind kind) {
  if (!value) return "-";
  switch (kind) {
    case ColumnKind::time:
      return gateway::utc_text(gateway::number_of(value));
    case ColumnKind::yes_no:
      return *value == "1" ? "yes" : "no";
    case ColumnKind::number:
      return fmt::format("{:.10g}", std::stod(fmt::format("{:.4f}", gateway::number_of(value))));
    case ColumnKind::text:
      return *value;
  }
  return "";
}

void print_json(const gateway::Query& query, const gateway::Rows& rows) {
  json list = json::array();
  for (const gateway::Row& row : rows) {
    json entry = json::object();
    for (std::size_t i = 0; i < row.size(); ++i)
      entry[std::string(query.columns[i].name)] = gateway::json_of(row[i], query.columns[i].kind);
    list.push_back(std::move(entry));
  }
  write_json(json{{query.name, std::move(list)}});
}

void print_table(const gateway::Query& query, const gateway::Rows& rows) {
  std::vector<std::string> headings;
  for (const gateway::Column& column : query.columns) headings.emplace_back(column.name);
  TextTable table(std::move(headings));
  for (const gateway::Row& row : rows) {
    std::vector<std::string> cells;
    cells.reserve(row.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      cells.push_back(cell_of(row[i], query.columns[i].kind));
    table.add_row(std::move(cells));
  }
  write_data(table.text(Terminal(STDOUT_FILENO)));
}

void show(const gateway::Query& query, const HistoryOptions& options) {
  const double begin_s = since_s(options.since);
  const auto history =
      gateway::open_history(options.database.empty() ? usual_database() : options.database);
  const auto rows = gateway::ask(*history, query, begin_s, options.machine);
  if (options.json)
    print_json(query, rows);
  else
    print_table(query, rows);
}

void copy(const HistoryOptions& options) {
  for (const std::string& name : {options.from, options.to})
    if (gateway::holds_password(name))
      throw std::runtime_error("a password does not belong into " + std::string("an address: ") +
                               "write it into the file that PGPASSFILE names");
  const auto from = gateway::open_history(options.from);
  History to(options.to);
  const auto counts = to.copy_from(*from);
  json result = json::object();
  for (std::size_t i = 0; i < counts.size(); ++i)
    result[gateway::history_tables()[i].name] = counts[i];
  if (options.json) {
    write_json(result);
    return;
  }
  for (const auto& [name, count] : result.items())
    write_data(fmt::format("{}: {} entries\n", name, count.get<std::int64_t>()));
}

void add_query(CLI::App& history, const gateway::Query& query, int& exit_code) {
  const auto options = std::make_shared<HistoryOptions>();
  CLI::App& command = *history.add_subcommand(std::string(query.name), std::string(query.help));
  command
      .add_option("--database", options->database,
                  "SQLite file or postgresql://...; default: $STANOK_HISTORY, otherwise the "
                  "history of the gateway of this user")
      ->type_name("DATABASE");
  command.add_option("--since", options->since, "how far back from now; default 30d")
      ->type_name("30d|12h|45min");
  command.add_option("--machine", options->machine, "show this machine only")->type_name("NAME");
  command.add_flag("--json", options->json, "print JSON");
  command.callback([&query, options, &exit_code] {
    show(query, *options);
    exit_code = 0;
  });
}

}  // namespace

void add_history_commands(CLI::App& app, int& exit_code) {
  CLI::App& history = noun_command(app, noun, noun_help);
  for (const gateway::Query& query : gateway::queries()) add_query(history, query, exit_code);
  const auto options = std::make_shared<HistoryOptions>();
  CLI::App& command = *history.add_subcommand(
      "copy", "add the entries of one history to another, of either database engine");
  command.add_option("from", options->from, "SQLite file or postgresql://...")
      ->required()
      ->type_name("FROM");
  command.add_option("to", options->to, "likewise; created if it does not exist")
      ->required()
      ->type_name("TO");
  command.add_flag("--json", options->json, "print JSON");
  command.callback([options, &exit_code] {
    copy(*options);
    exit_code = 0;
  });
}

}  // namespace stanok::client

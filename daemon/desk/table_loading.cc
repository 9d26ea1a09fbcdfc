#include "daemon/desk/table_loading.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "channels/stores/live_tables.h"
#include "config/files/tables_file.h"
#include "config/text/config_error.h"
#include "config/text/fault_list.h"
#include "daemon/desk/tables/entry_doubt.h"
#include "daemon/report/inventory.h"
#include "protocol/contract/json_text.h"

namespace stanok::daemon {
namespace {

using channels::OperatorEvent;
using channels::TablesConfig;
using channels::ToolEdge;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

Failure failure_of_config(const config::ConfigError& error) {
  const config::ConfigFault& first = error.faults().front();
  std::string text = first.text;
  const std::size_t others = error.faults().size() - 1;
  if (others >= config::FaultList::kept_max) {
    text += " (and more than " + std::to_string(config::FaultList::kept_max) + " others)";
  } else if (others > 0) {
    text += " (and " + std::to_string(others) + " more)";
  }
  Failure failure{FailureKind::program_error, "E9014", std::move(text), 0, {}};
  failure.place.file = first.file;
  failure.place.line = static_cast<int>(first.line);
  failure.place.column = static_cast<int>(first.column);
  return failure;
}

OperatorEvent event_of(const channels::OperatorCommand& command) {
  OperatorEvent event;
  event.command = command;
  return event;
}

using Edges = std::map<std::pair<int, int>, const ToolEdge*>;  // by number and edge

// An edge that no table names is there with zeros.
json edge_now(const Edges& edges, int number, int edge) {
  const auto found = edges.find({number, edge});
  if (found != edges.end()) return tool_json(*found->second);
  ToolEdge plain;
  plain.number = number;
  plain.edge = edge;
  return tool_json(plain);
}

Expected<std::vector<OperatorEvent>, Failure> changes_of_tool(const ToolEdge& wanted,
                                                              const Edges& now) {
  const json before = edge_now(now, wanted.number, wanted.edge);
  const json after = tool_json(wanted);
  std::vector<OperatorEvent> commands;
  for (const auto& [key, value] : after.items()) {
    if (before.at(key) == value) continue;
    if (channels::tool_value_named(key) == 0) {
      return Unexpected<Failure>(Failure{
          FailureKind::refused,
          "E9015",
          "tool " + std::to_string(wanted.number) + ", edge " + std::to_string(wanted.edge) + ": " +
              key + " is " + protocol::json_text(before.at(key)) + " in the machine, but " +
              protocol::json_text(value) + " in the text",
          0,
          {}});
    }
    commands.push_back(
        event_of(channels::commands::ToolSet{.key = channels::ShortText(std::string_view(key)),
                                             .value = value.get<double>(),
                                             .tool = wanted.number,
                                             .edge = wanted.edge}));
  }
  return commands;
}

// What is not named is zero.
double value_in_rows(const std::map<std::string, channels::AxisRow>& rows, const std::string& name,
                     const std::string& axis) {
  const auto row = rows.find(name);
  if (row == rows.end()) return 0.0;
  const auto value = row->second.find(axis);
  return value == row->second.end() ? 0.0 : value->second;
}

// Programs store them (G28.1); a text that has others cannot be loaded.
std::optional<Failure> change_of_reference_point(const TablesConfig& wanted,
                                                 const TablesConfig& now) {
  for (const auto& [channel, points] : wanted.reference_points) {
    const auto of_channel = now.reference_points.find(channel);
    for (const auto& [name, row] : points) {
      for (const auto& [axis, value] : row) {
        const bool has_any = of_channel != now.reference_points.end();
        const double before = has_any ? value_in_rows(of_channel->second, name, axis) : 0.0;
        if (value == before) continue;
        std::string text = "reference point " + name;
        text.append(" of channel ").append(std::to_string(channel)).append(": ").append(axis);
        text.append(" is ")
            .append(protocol::json_text(json(before)))
            .append(" in the machine, but ");
        text.append(protocol::json_text(json(value))).append(" in the text");
        return Failure{FailureKind::refused, "E9015", std::move(text), 0, {}};
      }
    }
  }
  return std::nullopt;
}

// Every value that wants to be confirmed, by its row, as long as people read on.
std::optional<Failure> doubts_about(const RunningMachine& machine, const TablesConfig& now,
                                    const std::vector<OperatorEvent>& commands) {
  constexpr int told_max = 20;
  std::string text;
  int doubts = 0;
  for (const OperatorEvent& event : commands) {
    const std::string doubt = doubt_of_entry(machine.file().machine, now, event.command);
    if (doubt.empty() || ++doubts > told_max) continue;
    text += (text.empty() ? "" : "; ") + doubt;
  }
  if (doubts == 0) return std::nullopt;
  if (doubts > told_max) text += "; and " + std::to_string(doubts - told_max) + " more";
  return Failure{FailureKind::refused, "E6095", std::move(text), 0, {}};
}

// What is left of a loading, shared by the answers of its commands.
struct Loading {
  CommandDesk& desk;
  std::vector<OperatorEvent> commands;
  Answer answer;
  std::size_t done = 0;
};

void submit_next(const std::shared_ptr<Loading>& loading) {
  if (loading->done == loading->commands.size())
    return loading->answer(json{{"values", loading->done}});
  loading->desk.submit(
      loading->commands[loading->done], WaitFor::accepted, [loading](const CommandResult& outcome) {
        if (outcome) {
          ++loading->done;
          return submit_next(loading);
        }
        Failure failure = outcome.error();
        failure.message += "; " + std::to_string(loading->done) + " of " +
                           std::to_string(loading->commands.size()) + " values had been written";
        loading->answer(Unexpected<Failure>(std::move(failure)));
      });
}

// A part of a table would be refused in the middle of it.
std::optional<Failure> refusal_in_run(const channels::CycleOutput& output) {
  for (int k = 0; k < output.channel_count; ++k) {
    const channels::ChannelOutput& channel = output.channels[k];
    if (!channel.running) continue;
    return Failure{FailureKind::refused,
                   "E6003",
                   "a program is running or held: tables are loaded when it has ended",
                   channel.id,
                   {}};
  }
  return std::nullopt;
}

}  // namespace

Expected<std::vector<OperatorEvent>, Failure> commands_to_load(RunningMachine& machine,
                                                               const std::string& text,
                                                               const std::string& name,
                                                               Confirmed confirmed) {
  if (auto refusal = refusal_in_run(machine.newest_output()))
    return Unexpected<Failure>(std::move(*refusal));
  const TablesConfig now = machine.tables();
  TablesConfig wanted;
  try {
    wanted =
        config::read_tables_text(text, name, config::names_of_axes(machine.file().machine), now);
  } catch (const config::ConfigError& error) {
    return Unexpected<Failure>(failure_of_config(error));
  }
  if (auto refusal = change_of_reference_point(wanted, now))
    return Unexpected<Failure>(std::move(*refusal));
  std::vector<OperatorEvent> commands;
  Edges edges;
  for (const ToolEdge& tool : now.tools) edges.try_emplace({tool.number, tool.edge}, &tool);
  for (const ToolEdge& tool : wanted.tools) {
    const auto changes = changes_of_tool(tool, edges);
    if (!changes) return changes;
    commands.insert(commands.end(), changes->begin(), changes->end());
  }
  for (const auto& [offset, values] : wanted.offsets) {
    for (const auto& [axis, value] : values) {
      if (value == value_in_rows(now.offsets, offset, axis)) continue;
      std::string place = offset;
      place.append(" ").append(axis);
      commands.push_back(event_of(channels::commands::OffsetSet{
          .place = channels::ShortText(std::string_view(place)), .value = value}));
    }
  }
  if (confirmed == Confirmed::yes) return commands;
  if (auto doubts = doubts_about(machine, now, commands))
    return Unexpected<Failure>(std::move(*doubts));
  return commands;
}

void submit_one_by_one(CommandDesk& desk, std::vector<OperatorEvent> commands, Answer answer) {
  submit_next(std::make_shared<Loading>(Loading{desk, std::move(commands), std::move(answer)}));
}

}  // namespace stanok::daemon

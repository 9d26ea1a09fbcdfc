#include "jobs/tools/tables_text.h"

#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "base/utf8.h"
#include "channels/contract/tool_value.h"
#include "config/text/config_error.h"
#include "config/text/fault_list.h"
#include "jobs/tools/foreign_text.h"
#include "jobs/tools/tool_values.h"

namespace stanok::jobs {
namespace {

namespace fs = std::filesystem;
using channels::ToolEdge;
using EdgeNumber = std::pair<int, int>;  // number, edge

std::string quoted_toml(const std::string& text) {
  std::ostringstream stream;
  stream << toml::value<std::string>(text);
  return stream.str();
}

std::string toml_text_of(const ToolEdge& tool, const ToolKey& key) {
  const std::string text = text_of(tool, key);
  return is_text(key) ? quoted_toml(text) : text;
}

std::string key_line(const ToolEdge& tool, const ToolKey& key) {
  return std::string(key.name) + " = " + toml_text_of(tool, key) + "\n";
}

std::string row_text(const ForeignTool& tool) {
  std::string text = "[[tool]]\nnumber = " + std::to_string(tool.edge.number) + "\n";
  if (tool.edge.edge != 1) text += "edge = " + std::to_string(tool.edge.edge) + "\n";
  for (const ToolKey& key : config::tool_keys()) {
    const bool is_given = std::ranges::find(tool.given, key.name) != tool.given.end();
    if (is_given && key.name != "number" && key.name != "edge") text += key_line(tool.edge, key);
  }
  return text;
}

// Replaces pieces of a text whose places were found before any of them was replaced.
class TextEdits {
 public:
  explicit TextEdits(const std::string& text) : text_(text) {
    for (const TextLine& line : lines_of(text_)) {
      line_begins_.push_back(checked_offset(line.text.data()));
    }
    line_begins_.push_back(text_.size());
  }

  void replace(const toml::source_region& region, std::string with) {
    const std::size_t begin = offset_of(region.begin);
    edits_.insert_or_assign(begin, Edit{offset_of(region.end), std::move(with)});
  }
  void insert_below(unsigned line, std::string with) {
    const std::size_t at = line_begins_[std::min<std::size_t>(line, line_begins_.size() - 1)];
    Edit& edit = edits_.try_emplace(at, Edit{at, ""}).first->second;
    edit.with = std::move(with) + edit.with;
  }

  [[nodiscard]] std::string result() const {
    std::string text;
    std::size_t from = 0;
    for (const auto& [begin, edit] : edits_) {
      if (begin < from) continue;
      text.append(text_, from, begin - from);
      text += edit.with;
      from = std::max(edit.end, begin);
    }
    return text + text_.substr(from);
  }

 private:
  struct Edit {
    std::size_t end;
    std::string with;
  };

  [[nodiscard]] std::size_t checked_offset(const char* at) const {
    return static_cast<std::size_t>(at - text_.data());
  }
  // Columns of TOML count characters.
  [[nodiscard]] std::size_t offset_of(const toml::source_position& place) const {
    const std::size_t line = std::min<std::size_t>(place.line, line_begins_.size()) - 1;
    const std::size_t begin = line_begins_[line];
    const std::string_view rest = std::string_view(text_).substr(begin);
    return std::min(begin + offset_of_character(rest, place.column - 1), text_.size());
  }

  const std::string& text_;
  std::vector<std::size_t> line_begins_;
  std::map<std::size_t, Edit> edits_;
};

std::map<EdgeNumber, const toml::table*> rows_of(const toml::table& root) {
  std::map<EdgeNumber, const toml::table*> rows;
  const toml::array* tools = root["tool"].as_array();
  if (tools == nullptr) return rows;
  for (const toml::node& node : *tools) {
    const toml::table* row = node.as_table();
    if (row == nullptr) continue;
    rows[{(*row)["number"].value_or(0), (*row)["edge"].value_or(1)}] = row;
  }
  return rows;
}

void refuse_equal_numbers(const fs::path& file, std::span<const ForeignTool> tools,
                          const std::map<EdgeNumber, const toml::table*>& rows) {
  std::vector<config::ConfigFault> faults;
  for (const ForeignTool& tool : tools) {
    const auto row = rows.find({tool.edge.number, tool.edge.edge});
    if (row == rows.end()) continue;
    const toml::source_position& place = row->second->source().begin;
    faults.push_back({.file = file.string(),
                      .line = place.line,
                      .column = place.column,
                      .text = "tool " + std::to_string(tool.edge.number) +
                              " is also in the imported file; --replace takes its values from "
                              "there"});
  }
  if (!faults.empty()) throw config::ConfigError(std::move(faults));
}

void replace_values(const ForeignTool& tool, const toml::table& row, TextEdits& edits) {
  std::string added;
  for (const ToolKey& key : config::tool_keys()) {
    if (std::ranges::find(tool.given, key.name) == tool.given.end()) continue;
    const toml::node* node = row.get(key.name);
    if (node == nullptr) {
      added += key_line(tool.edge, key);
    } else {
      edits.replace(node->source(), toml_text_of(tool.edge, key));
    }
  }
  if (!added.empty()) edits.insert_below(row.source().begin.line, std::move(added));
}

using Tools = std::map<EdgeNumber, ToolEdge>;

Tools tools_by_number(const std::string& text, const fs::path& file) {
  Tools tools;
  for (ToolEdge& tool : config::read_tools_text(text, file)) {
    tools.emplace(EdgeNumber{tool.number, tool.edge}, std::move(tool));
  }
  return tools;
}

Tools expected_tools(Tools tools, std::span<const ForeignTool> from) {
  for (const ForeignTool& tool : from) {
    ToolEdge& edge = tools[{tool.edge.number, tool.edge.edge}];
    edge.number = tool.edge.number;
    edge.edge = tool.edge.edge;
    for (const ToolKey& key : config::tool_keys()) {
      if (std::ranges::find(tool.given, key.name) == tool.given.end()) continue;
      is_text(key) ? set_text(edge, key, text_of(tool.edge, key))
                   : static_cast<void>(set_number(edge, key, number_of(tool.edge, key)));
    }
  }
  return tools;
}

bool have_same_values(const Tools& a, const Tools& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return std::ranges::all_of(config::tool_keys(), [&](const ToolKey& key) {
      return text_of(one.second, key) == text_of(other.second, key);
    });
  });
}

std::optional<toml::table> tree_of(const std::string& text, const fs::path& file) {
  config::FaultList faults;
  return config::parse_text(text, file, faults);
}

// Whether the edited text says what it should, and of all else the same as before.
bool is_right(const std::string& text, const fs::path& file, const Tools& expected,
              toml::table before) {
  auto after = tree_of(text, file);
  if (!after) return false;
  before.erase("tool");
  toml::table others = *after;
  others.erase("tool");
  return others == before && have_same_values(tools_by_number(text, file), expected);
}

}  // namespace

std::string tables_text(std::span<const ForeignTool> tools) {
  std::string text;
  for (const ForeignTool& tool : tools) text += (text.empty() ? "" : "\n") + row_text(tool);
  return text;
}

void keep_offsets(std::vector<ForeignTool>& tools) {
  for (ForeignTool& tool : tools) {
    std::erase_if(tool.given,
                  [](std::string_view key) { return channels::tool_value_named(key) == 0; });
  }
}

MergedTables merged_tables(const std::string& text, const fs::path& file,
                           std::span<const ForeignTool> tools, EqualNumbers rule) {
  const Tools before = tools_by_number(text, file);
  const toml::table root = tree_of(text, file).value_or(toml::table{});
  const auto rows = rows_of(root);
  if (rule == EqualNumbers::refuse) refuse_equal_numbers(file, tools, rows);
  MergedTables merged;
  TextEdits edits(text);
  std::string appended;
  for (const ForeignTool& tool : tools) {
    const auto row = rows.find({tool.edge.number, tool.edge.edge});
    if (row != rows.end()) {
      replace_values(tool, *row->second, edits);
      ++merged.replaced;
    } else {
      appended += "\n" + row_text(tool);
      ++merged.added;
    }
  }
  merged.text = edits.result();
  if (!merged.text.empty() && !merged.text.ends_with('\n')) merged.text += '\n';
  if (merged.text.empty() && !appended.empty()) appended.erase(0, 1);
  merged.text += appended;
  if (!is_right(merged.text, file, expected_tools(before, tools), root)) {
    throw config::ConfigError(
        {{.file = file.string(),
          .text = "the tools of this file cannot be edited in place; write each as a table "
                  "[[tool]] with one key in a line, or import into a new file with --output"}});
  }
  return merged;
}

}  // namespace stanok::jobs

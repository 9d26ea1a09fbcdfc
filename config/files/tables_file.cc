// Keys and checks of the tables file: [[tool]], [offset.G54], [reference_point.1.G28] and
// [variable.1].
#include "config/files/tables_file.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "channels/contract/output.h"
#include "config/files/foreign_tables.h"

namespace stanok::config {
namespace {

using channels::TablesConfig;
using channels::ToolEdge;

// Beside the axes of a work offset: what G10 L2 R writes.
constexpr std::string_view rotation_key = "R";

struct TablesFile {
  Subtables tools = nullptr;
  Subtable offsets = nullptr;
  Subtable reference_points = nullptr;
  Subtable variables = nullptr;
};

const Keys<TablesFile>& tables_keys() {
  static const Keys<TablesFile> keys = {
      {"tool", at<&TablesFile::tools>, optional, "", "one edge of a tool"},
      {"offset", at<&TablesFile::offsets>, optional, "", "work offsets"},
      {"reference_point", at<&TablesFile::reference_points>, optional, "", "points of G28 and G30"},
      {"variable", at<&TablesFile::variables>, optional, "",
       "common variables #500 to #999 of the dialects fanuc and haas, #10000 to #10499 of haas, "
       "and part counters, by channel"},
  };
  return keys;
}

using EdgeOfTool = std::pair<int, int>;  // number, edge

// What the row leaves out is as in `base`, else zero.
ToolEdge edge_to_begin_with(const toml::table& row, const std::map<EdgeOfTool, ToolEdge>& base) {
  const auto found = base.find({row["number"].value_or(0), row["edge"].value_or(1)});
  return found == base.end() ? ToolEdge{} : found->second;
}

std::vector<ToolEdge> read_tools(Subtables tools, const TablesConfig& tables, FaultList& faults) {
  std::vector<ToolEdge> edges;
  if (tools == nullptr) return edges;
  std::map<EdgeOfTool, ToolEdge> base;
  for (const ToolEdge& tool : tables.tools) base.try_emplace({tool.number, tool.edge}, tool);
  std::set<EdgeOfTool> seen;
  for (const toml::node& node : *tools) {
    const toml::table& table = *node.as_table();
    const Scope scope{faults, "tool " + std::to_string(table["number"].value_or(0))};
    ToolEdge edge = edge_to_begin_with(table, base);
    read_table(table, tool_keys(), edge, scope);
    if (!seen.emplace(edge.number, edge.edge).second) {
      scope.fault(place_of(table, "number"),
                  "edge " + std::to_string(edge.edge) +
                      " of this tool appears twice; give each row its own number or edge");
    }
    if (edge.corner_radius > edge.radius) {
      scope.fault(place_of(table, "corner_radius"),
                  "corner_radius exceeds radius, " + number_text(edge.radius));
    }
    edges.push_back(std::move(edge));
  }
  return edges;
}

void read_offset(const std::string& name, const toml::table& table,
                 const std::vector<std::string>& axis_names, TablesConfig& tables,
                 const Scope& scope) {
  std::vector<std::string_view> known(axis_names.begin(), axis_names.end());
  known.push_back(rotation_key);
  refuse_unknown_keys(table, known, scope);
  for (const auto& [axis, node] : table) {
    if (std::ranges::find(known, axis.str()) == known.end()) continue;
    const std::string_view meaning =
        axis.str() == rotation_key ? "rotation about Z" : "offset of the axis";
    double value = 0.0;
    detail::read_value(node, {.name = axis.str(), .unit = "mm, deg", .meaning = meaning}, scope,
                       value);
    tables.offsets[name][std::string(axis.str())] = value;
  }
}

void read_offsets(Subtable offsets, const std::vector<std::string>& axis_names,
                  TablesConfig& tables, FaultList& faults) {
  if (offsets == nullptr) return;
  for (const auto& [key, node] : *offsets) {
    const std::string name(key.str());
    const Scope scope{faults, "offset " + name};
    if (!is_work_offset(name)) {
      scope.fault(key.source(),
                  "no such work offset; use G54 to G59, \"G59.1\" to \"G59.3\" or "
                  "\"G54.1 P1\" and so on, names with a dot in quotes");
    } else if (!node.is_table()) {
      scope.fault(node.source(), "not a table; write the axes under [offset." + name + "]");
    } else {
      tables.offsets[name];
      read_offset(name, *node.as_table(), axis_names, tables, scope);
    }
  }
}

// 0: it is none.
int number_of_channel(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && number >= 1 && number <= channels::channels_max ? number : 0;
}

void read_reference_point(const std::string& name, const toml::table& table,
                          const std::vector<std::string>& axis_names, channels::AxisRow& row,
                          const Scope& scope) {
  const std::vector<std::string_view> known(axis_names.begin(), axis_names.end());
  refuse_unknown_keys(table, known, scope);
  for (const auto& [axis, node] : table) {
    if (std::ranges::find(known, axis.str()) == known.end()) continue;
    detail::read_value(node, {.name = axis.str(), .unit = "mm, deg", .meaning = name}, scope,
                       row[std::string(axis.str())]);
  }
}

void read_points_of_channel(int channel, const toml::table& points,
                            const std::vector<std::string>& axis_names, TablesConfig& tables,
                            FaultList& faults) {
  for (const auto& [key, node] : points) {
    const std::string name(key.str());
    const Scope scope{faults, "reference point " + name};
    if (!is_reference_point(name)) {
      scope.fault(key.source(),
                  "no such reference point; use G28, \"G30 P2\", \"G30 P3\" or "
                  "\"G30 P4\"");
    } else if (!node.is_table()) {
      scope.fault(node.source(), "not a table; write the axes under [reference_point." +
                                     std::to_string(channel) + ".\"" + name + "\"]");
    } else {
      read_reference_point(name, *node.as_table(), axis_names,
                           tables.reference_points[channel][name], scope);
    }
  }
}

void read_reference_points(Subtable channels, const std::vector<std::string>& axis_names,
                           TablesConfig& tables, FaultList& faults) {
  if (channels == nullptr) return;
  for (const auto& [key, node] : *channels) {
    const Scope scope{faults, "reference_point " + std::string(key.str())};
    const int channel = number_of_channel(key.str());
    if (channel == 0) {
      scope.fault(key.source(), "not the number of a channel; write [reference_point.1.G28]");
    } else if (!node.is_table()) {
      scope.fault(node.source(), "not a table; write [reference_point." + std::string(key.str()) +
                                     ".G28] and its axes");
    } else {
      read_points_of_channel(channel, *node.as_table(), axis_names, tables, faults);
    }
  }
}

// 0: it is none.
int number_of_variable(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && lang::is_kept_variable(number) ? number : 0;
}

void read_variables_of_channel(const toml::table& values, std::map<int, double>& variables,
                               const Scope& scope) {
  for (const auto& [key, node] : values) {
    const int number = number_of_variable(key.str());
    if (number == 0) {
      scope.fault(
          key.source(),
          "not a common variable; the numbers are 500 to 999, 3901, 3902 and 10000 to 10499");
      continue;
    }
    detail::read_value(node, {.name = key.str(), .unit = "", .meaning = "common variable"}, scope,
                       variables[number]);
  }
}

void read_variables(Subtable channels, TablesConfig& tables, FaultList& faults) {
  if (channels == nullptr) return;
  for (const auto& [key, node] : *channels) {
    const Scope scope{faults, "variable " + std::string(key.str())};
    const int channel = number_of_channel(key.str());
    if (channel == 0 || !node.is_table()) {
      scope.fault(key.source(), "not the table of a channel; write [variable.1] and 500 = 1.5");
    } else {
      read_variables_of_channel(*node.as_table(), tables.variables[channel], scope);
    }
  }
}

toml::table to_table(const channels::AxisRow& row) {
  toml::table table;
  for (const auto& [axis, value] : row) table.insert(axis, value);
  return table;
}

toml::table to_table(const ToolEdge& tool) {
  return toml::table{{"number", tool.number},
                     {"edge", tool.edge},
                     {"name", tool.name},
                     {"kind", tool.kind},
                     {"length", tool.length},
                     {"length_x", tool.length_x},
                     {"length_y", tool.length_y},
                     {"radius", tool.radius},
                     {"corner_radius", tool.corner_radius},
                     {"flute_length", tool.flute_length},
                     {"shank_diameter", tool.shank_diameter},
                     {"holder_diameter", tool.holder_diameter},
                     {"holder_length", tool.holder_length},
                     {"point_angle", tool.point_angle},
                     {"taper_angle", tool.taper_angle},
                     {"wear_length", tool.wear_length},
                     {"wear_length_x", tool.wear_length_x},
                     {"wear_radius", tool.wear_radius},
                     {"overhang", tool.overhang},
                     {"orientation", tool.orientation},
                     {"angle_front", tool.angle_front},
                     {"angle_back", tool.angle_back}};
}

// The tables; nothing, and a fault, when the file cannot be read.
std::optional<toml::table> parse_tables(const std::filesystem::path& file, FaultList& faults) {
  const auto text = read_text(file, faults);
  if (!text) return std::nullopt;
  if (const auto foreign = foreign_tables_in(*text)) {
    faults.add(foreign->place_in(file),
               "this is " + foreign->what + ", not a tables file; run `stanok tool import " +
                   file.filename().string() + " --output tables.toml` and name tables.toml here");
    return std::nullopt;
  }
  return parse_text(*text, file, faults);
}

}  // namespace

const Keys<ToolEdge>& tool_keys() {
  static const Keys<ToolEdge> keys = {
      {"number", at<&ToolEdge::number>, required, "", "number of the tool (T, H)", from(1, 32000)},
      {"edge", at<&ToolEdge::edge>, optional, "", "number of its cutting edge", from(1, 99)},
      {"name", at<&ToolEdge::name>, optional, "", "name to display"},
      {"kind", at<&ToolEdge::kind>, optional, "", "shape of the cutting part",
       one_of({"flat", "ball", "bull", "drill", "taper", "insert", "probe"})},
      {"length", at<&ToolEdge::length>, optional, "mm",
       "from the spindle nose to the tip, along Z"},
      {"length_x", at<&ToolEdge::length_x>, optional, "mm", "from the nose to the tip, along X"},
      {"length_y", at<&ToolEdge::length_y>, optional, "mm", "from the nose to the tip, along Y"},
      {"radius", at<&ToolEdge::radius>, optional, "mm", "radius of the cutter", not_negative},
      {"corner_radius", at<&ToolEdge::corner_radius>, optional, "mm",
       "radius between face and flank, at most the radius of the cutter", not_negative},
      {"flute_length", at<&ToolEdge::flute_length>, optional, "mm", "cutting length", not_negative},
      {"shank_diameter", at<&ToolEdge::shank_diameter>, optional, "mm", "diameter of the shank",
       not_negative},
      {"holder_diameter", at<&ToolEdge::holder_diameter>, optional, "mm", "diameter of the holder",
       not_negative},
      {"holder_length", at<&ToolEdge::holder_length>, optional, "mm", "length of the holder",
       not_negative},
      {"point_angle", at<&ToolEdge::point_angle>, optional, "deg",
       "point angle of a drill, between its lips; 0: 118", from(0, 180)},
      {"taper_angle", at<&ToolEdge::taper_angle>, optional, "deg",
       "angle of a taper, between its axis and its flank", from(0, 89)},
      {"wear_length", at<&ToolEdge::wear_length>, optional, "mm", "added to the length"},
      {"wear_length_x", at<&ToolEdge::wear_length_x>, optional, "mm",
       "added to the length along X"},
      {"wear_radius", at<&ToolEdge::wear_radius>, optional, "mm", "added to the radius"},
      {"overhang", at<&ToolEdge::overhang>, optional, "mm", "overhang of the tool from its holder",
       not_negative},
      {"orientation", at<&ToolEdge::orientation>, optional, "",
       "orientation of a turning tool: 1 to 9 (G41, G42); 0: none", from(0, 9)},
      {"angle_front", at<&ToolEdge::angle_front>, optional, "deg", "front angle of an insert",
       from(-360, 360)},
      {"angle_back", at<&ToolEdge::angle_back>, optional, "deg", "back angle of an insert",
       from(-360, 360)},
  };
  return keys;
}

bool is_work_offset(std::string_view name) {
  constexpr std::string_view extended = "G54.1 P";
  if (name.starts_with(extended)) {
    const std::string_view number = name.substr(extended.size());
    return !number.empty() && number.size() <= 3 && number.front() != '0' &&
           number.find_first_not_of("0123456789") == std::string_view::npos;
  }
  constexpr std::array<std::string_view, 9> plain{"G54", "G55",   "G56",   "G57",  "G58",
                                                  "G59", "G59.1", "G59.2", "G59.3"};
  return std::ranges::find(plain, name) != plain.end();
}

bool is_reference_point(std::string_view name) {
  return name == "G28" || name == "G30 P2" || name == "G30 P3" || name == "G30 P4";
}

std::vector<std::string> names_of_axes(const channels::MachineConfig& machine) {
  std::vector<std::string> names;
  names.reserve(machine.axes.size());
  for (const channels::AxisConfig& axis : machine.axes) names.push_back(axis.name);
  return names;
}

TablesConfig read_tables(const std::filesystem::path& file,
                         const std::vector<std::string>& axis_names, FaultList& faults,
                         const TablesConfig& base) {
  TablesConfig tables;
  const auto root = parse_tables(file, faults);
  if (!root) return tables;
  TablesFile sections;
  read_table(*root, tables_keys(), sections, Scope{faults, "tables"});
  tables.tools = read_tools(sections.tools, base, faults);
  read_offsets(sections.offsets, axis_names, tables, faults);
  read_reference_points(sections.reference_points, axis_names, tables, faults);
  read_variables(sections.variables, tables, faults);
  return tables;
}

TablesConfig read_tables_text(const std::string& text, const std::filesystem::path& file,
                              const std::vector<std::string>& axis_names,
                              const TablesConfig& base) {
  FaultList faults({{file, text}});
  TablesConfig tables = read_tables(file, axis_names, faults, base);
  faults.throw_if_any();
  return tables;
}

std::vector<ToolEdge> read_tools_text(const std::string& text, const std::filesystem::path& file) {
  FaultList faults({{file, text}});
  std::vector<ToolEdge> tools;
  if (const auto root = parse_tables(file, faults)) {
    TablesFile sections;
    read_table(*root, tables_keys(), sections, Scope{faults, "tables"});
    tools = read_tools(sections.tools, {}, faults);
  }
  faults.throw_if_any();
  return tools;
}

std::string to_toml(const TablesConfig& tables) {
  toml::array tools;
  for (const ToolEdge& tool : tables.tools) tools.push_back(to_table(tool));
  toml::table offsets;
  for (const auto& [name, values] : tables.offsets) offsets.insert(name, to_table(values));
  toml::table reference_points;
  for (const auto& [channel, points] : tables.reference_points) {
    toml::table of_channel;
    for (const auto& [name, values] : points) of_channel.insert(name, to_table(values));
    reference_points.insert(std::to_string(channel), std::move(of_channel));
  }
  toml::table all{{"tool", std::move(tools)},
                  {"offset", std::move(offsets)},
                  {"reference_point", std::move(reference_points)}};
  if (!tables.variables.empty()) {
    toml::table variables;
    for (const auto& [channel, values] : tables.variables) {
      toml::table of_channel;
      for (const auto& [number, value] : values) of_channel.insert(std::to_string(number), value);
      variables.insert(std::to_string(channel), std::move(of_channel));
    }
    all.insert("variable", std::move(variables));
  }
  std::ostringstream text;
  text << all << "\n";
  return text.str();
}

std::vector<KeyRow> tool_key_rows() {
  return describe(tool_keys());
}

}  // namespace stanok::config

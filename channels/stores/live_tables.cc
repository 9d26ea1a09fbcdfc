#include "channels/stores/live_tables.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/visit_in_cycle.h"

namespace stanok::channels {
namespace {

constexpr int work_offsets_max = 9 + 300;  // G54..G59.3 and G54.1 P1..P300
constexpr int tools_without_row_max = 99;
constexpr int variables_of_channel = lang::kept_variables;

// In the order of ToolValue.
std::array<double, tool_values> values_of(const ToolEdge& tool) {
  return {
      tool.length,      tool.length_y,    tool.length_x,     tool.radius,
      tool.wear_length, tool.wear_radius, tool.overhang,     static_cast<double>(tool.orientation),
      tool.angle_front, tool.angle_back,  tool.wear_length_x};
}

// `Tool`: ToolEdge or ToolRow.
template <class Tool>
void take_values(const NumberedArray<std::atomic<double>, tool_values>& values, Tool& tool)
    RT_SAFE {
  tool.length = values[0];
  tool.length_y = values[1];
  tool.length_x = values[2];
  tool.radius = values[3];
  tool.wear_length = values[4];
  tool.wear_radius = values[5];
  tool.overhang = values[6];
  tool.orientation = static_cast<int>(values[7].load());
  tool.angle_front = values[8];
  tool.angle_back = values[9];
  tool.wear_length_x = values[10];
}

// What tools are ordered by.
std::pair<int, int> key_of(const ToolEdge& tool) RT_SAFE {
  return {tool.number, tool.edge};
}

constexpr double length_max = 1e5;  // mm, or deg of an offset

bool is_in_range(ToolValue value, double to) RT_SAFE {
  constexpr double angle_max = 360.0;
  switch (value) {
    case ToolValue::orientation:
      return to >= 0.0 && to <= 9.0 && to == static_cast<double>(static_cast<int>(to));
    case ToolValue::angle_front:
    case ToolValue::angle_back:
      return to >= -angle_max && to <= angle_max;
    case ToolValue::radius:
      return to >= 0.0 && to <= length_max;
    default:
      return to >= -length_max && to <= length_max;
  }
}

}  // namespace

std::string work_offset_name(int number) {
  if (number <= 6) return "G" + std::to_string(53 + number);
  if (number <= 9) return "G59." + std::to_string(number - 6);
  return "G54.1 P" + std::to_string(number - 9);
}

std::string reference_point_name(int which) {
  return which == 1 ? "G28" : "G30 P" + std::to_string(which);
}

int work_offset_number(std::string_view name) RT_SAFE {
  constexpr std::array<std::string_view, 9> plain{"G54", "G55",   "G56",   "G57",  "G58",
                                                  "G59", "G59.1", "G59.2", "G59.3"};
  const auto found = std::find(plain.begin(), plain.end(), name);
  if (found != plain.end()) return static_cast<int>(found - plain.begin()) + 1;
  constexpr std::string_view extended = "G54.1 P";
  // starts_with is substr inside, which may throw.
  if (name.size() < extended.size() || !std::equal(extended.begin(), extended.end(), name.begin()))
    return 0;
  int page = 0;
  name.remove_prefix(extended.size());
  if (name.empty() || name.size() > 3) return 0;
  for (const char c : name) {
    if (c < '0' || c > '9') return 0;
    page = 10 * page + (c - '0');
  }
  return page >= 1 && page <= work_offsets_max - 9 ? page + 9 : 0;
}

LiveTables::LiveTables(const MachineConfig& machine)
    : write_protected_(machine.tables_write_protected),
      unnamed_tools_(machine.unnamed_tools),
      bounds_(machine) {
  for (const AxisConfig& axis : machine.axes) columns_.push_back(axis.name);
  columns_.emplace_back("R");
  for (const ChannelConfig& channel : machine.channels) channels_.push_back(channel.id);
  reference_points_ = NumberedList<std::atomic<double>>(
      channels_.size() * lang::reference_point_count * columns_.size());
  for (const int channel : channels_) read_reference_points(channel, machine.tables);
  variables_ = NumberedList<std::atomic<double>>(channels_.size() * variables_of_channel);
  for (std::atomic<double>& value : variables_) value = std::nan("");
  for (const int channel : channels_) read_variables(channel, machine.tables);
  offsets_ = NumberedList<std::atomic<double>>(work_offsets_max * columns_.size());
  for (int number = 1; number <= work_offsets_max; ++number) {
    const auto row = machine.tables.offsets.find(work_offset_name(number));
    if (row == machine.tables.offsets.end()) continue;
    for (int axis = 0; axis < column_count(); ++axis) {
      const auto value = row->second.find(columns_[axis]);
      if (value != row->second.end()) offsets_[cell(number, axis)] = value->second;
    }
  }
  std::map<std::pair<int, int>, std::pair<ToolEdge, bool>> rows;
  for (int number = 0; number <= tools_without_row_max; ++number) {
    ToolEdge plain;
    plain.number = number;
    rows[{number, 1}] = {plain, true};
  }
  for (const ToolEdge& tool : machine.tables.tools) rows[key_of(tool)] = {tool, false};
  tools_ = NumberedList<ToolPlace>(rows.size());
  int place = 0;
  for (auto& [key, row] : rows) {
    ToolPlace& made = tools_[place++];
    made.fixed = row.first;
    made.row = row_of(row.first);
    made.is_default = row.second;
    made.exists = !row.second || unnamed_tools_ || made.fixed.number == 0;
    const auto values = values_of(made.fixed);
    for (std::size_t k = 0; k < values.size(); ++k) made.values[k] = values[k];
  }
}

void LiveTables::read_reference_points(int channel, const TablesConfig& tables) {
  const auto points = tables.reference_points.find(channel);
  if (points == tables.reference_points.end()) return;
  for (int which = 1; which <= lang::reference_point_count; ++which) {
    const auto row = points->second.find(reference_point_name(which));
    if (row == points->second.end()) continue;
    for (const auto& [axis, value] : row->second)
      store_reference_point(channel, which, axis, value);
  }
}

void LiveTables::read_variables(int channel, const TablesConfig& tables) {
  const auto values = tables.variables.find(channel);
  if (values == tables.variables.end()) return;
  for (const auto& [number, value] : values->second) set_variable(channel, number, value);
}

void LiveTables::add_variables(int channel, TablesConfig& tables) const {
  for (int cell = 0; cell < lang::kept_variables; ++cell) {
    const int number = lang::kept_variable_at(cell);
    const double value = variable(channel, number);
    if (!std::isnan(value)) tables.variables[channel][number] = value;
  }
}

int LiveTables::variable_cell(int channel, int number) const {
  const auto place = std::find(channels_.begin(), channels_.end(), channel) - channels_.begin();
  return static_cast<int>(place) * variables_of_channel + lang::kept_variable_place(number);
}

double LiveTables::variable(int channel, int number) const {
  return variables_[variable_cell(channel, number)].load(std::memory_order_relaxed);
}

void LiveTables::set_variable(int channel, int number, double value) {
  variables_[variable_cell(channel, number)].store(value, std::memory_order_relaxed);
}

int LiveTables::reference_cell(int channel, int which, std::string_view axis) const {
  const auto place = std::find(channels_.begin(), channels_.end(), channel) - channels_.begin();
  const int row = static_cast<int>(place) * lang::reference_point_count + which - 1;
  return row * column_count() + column(axis);
}

double LiveTables::reference_point(int channel, int which, std::string_view axis) const {
  return reference_points_[reference_cell(channel, which, axis)];
}

void LiveTables::store_reference_point(int channel, int which, std::string_view axis,
                                       double value) {
  reference_points_[reference_cell(channel, which, axis)] = value;
}

std::optional<double> LiveTables::offset(int number, int axis) const RT_SAFE {
  const int rotation = column_count() - 1;
  if (axis == lang::rotation_of_offset) axis = rotation;
  const bool exists = number >= 1 && number <= work_offsets_max && axis >= 0 && axis <= rotation;
  if (!exists) return std::nullopt;
  return offsets_[cell(number, axis)].load(std::memory_order_relaxed);
}

bool LiveTables::set_offset(int number, int axis, double value, Writer writer) RT_SAFE {
  if (write_protected_ && writer == Writer::program) return false;
  if (!offset(number, axis) || !(std::abs(value) <= length_max)) return false;
  if (axis == lang::rotation_of_offset) axis = column_count() - 1;
  offsets_[cell(number, axis)].store(value, std::memory_order_relaxed);
  return true;
}

int LiveTables::column(std::string_view axis) const RT_SAFE {
  for (int k = 0; k < column_count(); ++k) {
    if (columns_[k] == axis) return k;
  }
  return -1;
}

std::optional<double> LiveTables::offset(int number, const std::string& axis) const {
  if (number < 1 || number > work_offsets_max) return std::nullopt;
  const auto named = std::find(columns_.begin(), columns_.end(), axis);
  if (named == columns_.end()) return 0.0;
  return offset(number, static_cast<int>(named - columns_.begin()));
}

const LiveTables::ToolPlace* LiveTables::find(int number, int edge) const RT_SAFE {
  const int place = find_place(number, edge);
  if (place < 0 || !tools_[place].exists.load(std::memory_order_acquire)) return nullptr;
  return &tools_[place];
}

bool LiveTables::has_place(int number, int edge) const RT_SAFE {
  return find_place(number, edge) >= 0;
}

int LiveTables::find_place(int number, int edge) const RT_SAFE {
  const auto place = std::lower_bound(tools_.begin(), tools_.end(), std::pair{number, edge},
                                      [](const ToolPlace& tool, const std::pair<int, int>& sought)
                                          RT_SAFE { return key_of(tool.fixed) < sought; });
  if (place == tools_.end() || key_of(place->fixed) != std::pair{number, edge}) return -1;
  return static_cast<int>(place - tools_.begin());
}

std::optional<double> LiveTables::tool_value(int number, int edge, int value) const RT_SAFE {
  const ToolPlace* row = find(number, edge);
  if (row == nullptr || value < 1 || value > tool_values) return std::nullopt;
  return row->values[value - 1].load(std::memory_order_relaxed);
}

bool LiveTables::set_tool_value(int number, int edge, int value, double to, Writer writer) RT_SAFE {
  if (write_protected_ && writer == Writer::program) return false;
  const int place = find_place(number, edge);
  if (place < 0 || value < 1 || value > tool_values) return false;
  if (writer == Writer::program && !tools_[place].exists.load(std::memory_order_acquire))
    return false;
  if (number == 0 || !is_in_range(static_cast<ToolValue>(value), to)) return false;
  ToolPlace& row = tools_[place];
  row.values[value - 1].store(to, std::memory_order_relaxed);
  row.exists.store(true, std::memory_order_release);
  tool_writes_.fetch_add(1, std::memory_order_release);
  return true;
}

std::optional<ToolEdge> LiveTables::tool(int number, int edge) const {
  const ToolPlace* row = find(number, edge);
  if (row == nullptr) return std::nullopt;
  ToolEdge tool = row->fixed;
  take_values(row->values, tool);
  return tool;
}

ToolRow LiveTables::row(int number, int edge) const RT_SAFE {
  const ToolPlace* const place = number == 0 ? nullptr : find(number, edge);
  if (place == nullptr) return {};
  ToolRow row = place->row;
  take_values(place->values, row);
  return row;
}

TablesConfig LiveTables::snapshot() const {
  TablesConfig tables;
  for (const ToolPlace& row : tools_) {
    ToolEdge now = row.fixed;
    take_values(row.values, now);
    const bool filled = !unnamed_tools_ && row.fixed.number != 0 && row.exists;
    if (!row.is_default || filled || values_of(now) != values_of(row.fixed))
      tables.tools.push_back(now);
  }
  for (int number = 1; number <= work_offsets_max; ++number) {
    for (int axis = 0; axis < column_count(); ++axis) {
      const double value = offsets_[cell(number, axis)];
      if (value != 0.0) tables.offsets[work_offset_name(number)][columns_[axis]] = value;
    }
  }
  for (const int channel : channels_) add_reference_points(channel, tables);
  for (const int channel : channels_) add_variables(channel, tables);
  return tables;
}

void LiveTables::add_reference_points(int channel, TablesConfig& tables) const {
  for (int which = 1; which <= lang::reference_point_count; ++which) {
    for (int axis = 0; axis + 1 < column_count(); ++axis) {
      const double value = reference_point(channel, which, columns_[axis]);
      if (value == 0.0) continue;
      tables.reference_points[channel][reference_point_name(which)][columns_[axis]] = value;
    }
  }
}

namespace {

// Table 1 is the only one there is.
bool exists(const requests::OffsetRead& place) RT_SAFE {
  return place.table == 1;
}

int machine_axis(const requests::OffsetRead& place, NumberedSpan<const int> machine_axes) RT_SAFE {
  return place.axis >= 0 ? machine_axes[place.axis] : place.axis;
}

struct TableExecution {
  using Result = std::optional<double>;

  LiveTables& tables;
  NumberedSpan<const int> machine_axes;

  Result operator()(const requests::ToolRead& place) const RT_SAFE {
    return tables.tool_value(place.tool, place.edge, place.value);
  }
  Result operator()(const requests::ToolWrite& write) const RT_SAFE {
    const auto& [tool, edge, value] = write.place;
    if (!tables.set_tool_value(tool, edge, value, write.value)) return std::nullopt;
    return write.value;
  }
  Result operator()(const requests::OffsetRead& place) const RT_SAFE {
    if (!exists(place)) return std::nullopt;
    return tables.offset(place.offset, machine_axis(place, machine_axes));
  }
  Result operator()(const requests::OffsetWrite& write) const RT_SAFE {
    const requests::OffsetRead& place = write.place;
    const int axis = machine_axis(place, machine_axes);
    if (!exists(place) || !tables.set_offset(place.offset, axis, write.value)) return std::nullopt;
    return write.value;
  }
  Result operator()(const auto& /*other*/) const RT_SAFE { return std::nullopt; }
};

}  // namespace

std::optional<double> execute_table_request(LiveTables& tables, const Request& request,
                                            NumberedSpan<const int> machine_axes) RT_SAFE {
  return visit_in_cycle(TableExecution{tables, machine_axes}, request);
}

namespace {

// As work_offset_name.
void append_work_offset(ReasonText& text, int number) RT_SAFE {
  if (number <= 6) {
    text.append("G").append(long{53} + number);
  } else if (number <= 9) {
    text.append("G59.").append(long{number} - 6);
  } else {
    text.append("G54.1 P").append(long{number} - 9);
  }
}

struct EntryReason {
  const LiveTables& tables;
  NumberedSpan<const int> machine_axes;

  ReasonText operator()(const requests::ToolWrite& write) const RT_SAFE {
    const auto& [tool, edge, value] = write.place;
    if (!tables.tool_value(tool, edge, value)) return {};
    const auto named = static_cast<ToolValue>(value);
    const EntryBound bound = tables.bounds().of_tool(named);
    if (bound.holds(write.value)) return {};
    ReasonText text("tool ");
    text.append(long{tool}).append(", edge ").append(long{edge}).append(", ");
    text.append(name_of(named)).append(": ");
    return text.append(reason_against(bound, write.value).view());
  }
  ReasonText operator()(const requests::OffsetWrite& write) const RT_SAFE {
    const int axis = machine_axis(write.place, machine_axes);
    if (!exists(write.place) || !tables.offset(write.place.offset, axis)) return {};
    const EntryBound bound = tables.bounds().of_offset(axis);
    if (bound.holds(write.value)) return {};
    ReasonText text;
    append_work_offset(text, write.place.offset);
    text.append(" ").append(tables.column_name(axis)).append(": ");
    return text.append(reason_against(bound, write.value).view());
  }
  ReasonText operator()(const auto& /*other*/) const RT_SAFE { return {}; }
};

}  // namespace

ReasonText implausible_entry(const LiveTables& tables, const Request& request,
                             NumberedSpan<const int> machine_axes) RT_SAFE {
  return visit_in_cycle(EntryReason{tables, machine_axes}, request);
}

}  // namespace stanok::channels

#include "channels/stores/live_tables.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"
#include "base/visit_in_cycle.h"
#include "channels/stores/table_view.h"

namespace stanok::channels {
namespace {

constexpr int variables_of_channel = lang::kept_variables;
constexpr double length_max = 1e5;  // mm, or deg of an offset

}  // namespace

std::string reference_point_name(int which) {
  return which == 1 ? "G28" : "G30 P" + std::to_string(which);
}

LiveTables::LiveTables(const MachineConfig& machine)
    : layout_(machine),
      write_protected_(machine.tables_write_protected),
      unnamed_tools_(machine.unnamed_tools),
      bounds_(machine),
      cells_(checked_size(layout_.cells())) {
  for (const ChannelConfig& channel : machine.channels) channels_.push_back(channel.id);
  reference_points_ = NumberedList<std::atomic<double>>(
      channels_.size() * lang::reference_point_count * checked_size(layout_.column_count()));
  for (const int channel : channels_) read_reference_points(channel, machine.tables);
  variables_ = NumberedList<std::atomic<double>>(channels_.size() * variables_of_channel);
  for (std::atomic<double>& value : variables_) value = std::nan("");
  for (const int channel : channels_) read_variables(channel, machine.tables);
  read_tools_and_offsets(machine.tables);
}

void LiveTables::read_tools_and_offsets(const TablesConfig& tables) {
  for (int number = 1; number <= TableLayout::work_offsets_max; ++number) {
    const auto row = tables.offsets.find(work_offset_name(number));
    if (row == tables.offsets.end()) continue;
    for (const auto& [axis, value] : row->second) {
      const int column = layout_.column(axis);
      if (column >= 0) cells_[layout_.offset_cell(number, column)] = value;
    }
  }
  for (int place = 0; place < layout_.tool_count(); ++place) {
    const auto values = values_of(layout_.tool(place).fixed);
    for (int k = 0; k < tool_values; ++k) cells_[layout_.tool_cell(place, k + 1)] = values[k];
    cells_[layout_.presence_cell(place)] = begins_present(place) ? 1.0 : 0.0;
  }
}

bool LiveTables::begins_present(int place) const RT_SAFE {
  const TableLayout::ToolPlace& tool = layout_.tool(place);
  return !tool.is_default || unnamed_tools_ || tool.fixed.number == 0;
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
  return row * layout_.column_count() + layout_.column(axis);
}

double LiveTables::reference_point(int channel, int which, std::string_view axis) const {
  return reference_points_[reference_cell(channel, which, axis)];
}

void LiveTables::store_reference_point(int channel, int which, std::string_view axis,
                                       double value) {
  reference_points_[reference_cell(channel, which, axis)] = value;
}

// Who reads the cell by itself sees the value at once, who follows the writes by its number.
void LiveTables::write(int cell, double value) RT_SAFE {
  writes_.add({.cell = cell, .value = value}, cells_[cell]);
}

std::optional<double> LiveTables::offset(int number, int axis) const RT_SAFE {
  const int cell = layout_.offset_cell(number, axis);
  if (cell < 0) return std::nullopt;
  return value_of(cell);
}

bool LiveTables::set_offset(int number, int axis, double value, Writer writer) RT_SAFE {
  if (write_protected_ && writer == Writer::program) return false;
  const int cell = layout_.offset_cell(number, axis);
  if (cell < 0 || !(std::abs(value) <= length_max)) return false;
  write(cell, value);
  return true;
}

int LiveTables::find(int number, int edge) const RT_SAFE {
  const int place = layout_.tool_place(number, edge);
  return place >= 0 && value_of(layout_.presence_cell(place)) != 0.0 ? place : -1;
}

bool LiveTables::has_place(int number, int edge) const RT_SAFE {
  return layout_.tool_place(number, edge) >= 0;
}

std::optional<double> LiveTables::tool_value(int number, int edge, int value) const RT_SAFE {
  const int place = find(number, edge);
  if (place < 0 || value < 1 || value > tool_values) return std::nullopt;
  return value_of(layout_.tool_cell(place, value));
}

bool LiveTables::set_tool_value(int number, int edge, int value, double to, Writer writer) RT_SAFE {
  if (write_protected_ && writer == Writer::program) return false;
  const int place =
      writer == Writer::program ? find(number, edge) : layout_.tool_place(number, edge);
  if (place < 0 || value < 1 || value > tool_values) return false;
  if (number == 0 || !can_be(static_cast<ToolValue>(value), to)) return false;
  write(layout_.tool_cell(place, value), to);
  if (value_of(layout_.presence_cell(place)) == 0.0) write(layout_.presence_cell(place), 1.0);
  return true;
}

ToolRow LiveTables::row(int number, int edge) const RT_SAFE {
  const int place = number == 0 ? -1 : find(number, edge);
  if (place < 0) return {};
  ToolRow row = layout_.tool(place).row;
  take_values([&](int value) RT_SAFE { return value_of(layout_.tool_cell(place, value)); }, row);
  return row;
}

TablesConfig LiveTables::snapshot() const {
  TablesConfig tables = TableView(*this).rows();
  for (const int channel : channels_) add_reference_points(channel, tables);
  for (const int channel : channels_) add_variables(channel, tables);
  return tables;
}

void LiveTables::add_reference_points(int channel, TablesConfig& tables) const {
  for (int which = 1; which <= lang::reference_point_count; ++which) {
    for (int axis = 0; axis + 1 < layout_.column_count(); ++axis) {
      const std::string name(layout_.column_name(axis));
      const double value = reference_point(channel, which, name);
      if (value == 0.0) continue;
      tables.reference_points[channel][reference_point_name(which)][name] = value;
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
    text.append(" ").append(tables.layout().column_name(axis)).append(": ");
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

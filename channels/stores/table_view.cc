#include "channels/stores/table_view.h"

namespace stanok::channels {

void TableView::copy() {
  const TableWrites& writes = live_.writes();
  cells_.resize(checked_size(live_.layout().cells()));
  do {
    version_ = writes.newest();
    for (int cell = 0; cell < live_.layout().cells(); ++cell) cells_[cell] = live_.value_of(cell);
  } while (writes.begun() != version_);
}

void TableView::advance_to(std::uint64_t version) {
  while (version_ < version) {
    const auto write = live_.writes().at(version_ + 1);
    if (!write) return copy();
    cells_[write->cell] = write->value;
    ++version_;
  }
}

std::optional<double> TableView::offset(int number, int axis) const {
  const int cell = live_.layout().offset_cell(number, axis);
  return cell < 0 ? std::nullopt : std::optional(cells_[cell]);
}

// An axis without a column has no offset.
std::optional<double> TableView::offset(int number, const std::string& axis) const {
  const TableLayout& layout = live_.layout();
  const int column = layout.column(axis);
  if (column >= 0) return offset(number, column);
  return layout.offset_cell(number, 0) < 0 ? std::nullopt : std::optional(0.0);
}

int TableView::place_of_tool(int number, int edge) const {
  const TableLayout& layout = live_.layout();
  const int place = layout.tool_place(number, edge);
  return place >= 0 && cells_[layout.presence_cell(place)] != 0.0 ? place : -1;
}

ToolEdge TableView::edge_at(int place) const {
  const TableLayout& layout = live_.layout();
  ToolEdge tool = layout.tool(place).fixed;
  take_values([&](int value) { return cells_[layout.tool_cell(place, value)]; }, tool);
  return tool;
}

std::optional<double> TableView::tool_value(int number, int edge, int value) const {
  const int place = place_of_tool(number, edge);
  if (place < 0 || value < 1 || value > tool_values) return std::nullopt;
  return cells_[live_.layout().tool_cell(place, value)];
}

std::optional<ToolEdge> TableView::tool(int number, int edge) const {
  const int place = place_of_tool(number, edge);
  return place < 0 ? std::nullopt : std::optional(edge_at(place));
}

TablesConfig TableView::rows() const {
  const TableLayout& layout = live_.layout();
  TablesConfig rows;
  for (int place = 0; place < layout.tool_count(); ++place) {
    const TableLayout::ToolPlace& tool = layout.tool(place);
    const ToolEdge now = edge_at(place);
    const bool is_present = cells_[layout.presence_cell(place)] != 0.0;
    const bool was_filled = is_present && !live_.begins_present(place);
    if (!tool.is_default || was_filled || values_of(now) != values_of(tool.fixed))
      rows.tools.push_back(now);
  }
  for (int number = 1; number <= TableLayout::work_offsets_max; ++number) {
    for (int column = 0; column < layout.column_count(); ++column) {
      const double value = cells_[layout.offset_cell(number, column)];
      if (value == 0.0) continue;
      const std::string name(layout.column_name(column));
      rows.offsets[work_offset_name(number)][name] = value;
    }
  }
  return rows;
}

}  // namespace stanok::channels

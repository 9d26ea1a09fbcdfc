#include "jobs/tools/tool_csv.h"

#include <algorithm>
#include <optional>

#include "jobs/tools/csv_rows.h"
#include "jobs/tools/foreign_reader.h"
#include "jobs/tools/foreign_text.h"
#include "jobs/tools/tool_values.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

// What the cells below a heading are.
struct CsvColumn {
  std::string heading;
  const ToolKey* key = nullptr;  // null: the tables file has no such key
  double factor = 1.0;
  std::optional<LengthUnit> unit;  // of the heading
};

CsvColumn column_of(const std::string& heading) {
  CsvColumn column{.heading = heading, .key = nullptr, .unit = std::nullopt};
  std::string name = in_lower_case(heading);
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
    const std::string end = "_" + std::string(name_of(unit));
    if (!name.ends_with(end)) continue;
    name.resize(name.size() - end.size());
    column.unit = unit;
  }
  if (name == "diameter") {
    name = "radius";
    column.factor = 0.5;
  }
  const auto& keys = config::tool_keys();
  const auto found = std::ranges::find(keys, name, &ToolKey::name);
  const bool is_known = found != keys.end() && (!column.unit || is_length(*found));
  if (is_known) column.key = &*found;
  return column;
}

class CsvReader {
 public:
  explicit CsvReader(const ForeignSource& source) : reader_(source), unit_(source.unit) {}

  void read(std::string_view text) {
    const CsvRows found = csv_rows(text, reader_);
    separator_ = found.separator;
    if (found.rows.empty()) return;
    if (!read_headings(found.rows.front())) return;
    for (const CsvRow& row : std::span(found.rows).subspan(1)) read_row(row);
  }
  [[nodiscard]] ForeignTools finish() { return reader_.finish(); }

 private:
  bool read_headings(const CsvRow& row) {
    for (const CsvCell& cell : row) columns_.push_back(column_of(cell.text));
    const bool has_plain_length = std::ranges::any_of(columns_, [](const CsvColumn& column) {
      return column.key != nullptr && is_length(*column.key) && !column.unit;
    });
    if (has_plain_length && !unit_) {
      reader_.remark(
          "the headings do not state the unit: lengths are taken as mm; write length_inch and so "
          "on, or give --unit inch");
    }
    if (place_of_key("number") < columns_.size()) return true;
    reader_.fault(row.front().place,
                  "the first row has no heading 'number'; it names keys of the tables file, as in "
                  "number,name,length_mm,radius_mm");
    return false;
  }

  [[nodiscard]] std::size_t place_of_key(std::string_view name) const {
    std::size_t place = 0;
    while (place < columns_.size() &&
           (columns_[place].key == nullptr || columns_[place].key->name != name)) {
      ++place;
    }
    return place;
  }

  // A whole number; nothing: there is none, and for `otherwise` none is wanted.
  std::optional<int> whole(const CsvRow& row, std::string_view name, std::optional<int> otherwise) {
    const std::size_t place = place_of_key(name);
    if (place >= row.size() || row[place].text.empty()) {
      if (!otherwise) reader_.fault(row.front().place, "no number of a tool in this row");
      return otherwise;
    }
    const auto value = whole_number_of_text(row[place].text);
    if (!value) {
      reader_.fault(row[place].place, "'" + shortened(row[place].text) + "' is not the " +
                                          std::string(name) + " of a tool; write a whole number");
    }
    return value;
  }

  void read_row(const CsvRow& row) {
    const auto number = whole(row, "number", std::nullopt);
    const auto edge = whole(row, "edge", 1);
    if (!number || !edge) return;
    ForeignTool* tool = reader_.begin(*number, *edge, row.front().place);
    if (tool == nullptr) return;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].text.empty()) continue;
      if (i < columns_.size()) {
        take(*tool, columns_[i], row[i]);
      } else {
        reader_.fault(row[i].place, "more cells than headings; a text with a comma needs quotes");
      }
    }
  }

  void take(ForeignTool& tool, const CsvColumn& column, const CsvCell& cell) {
    if (column.key == nullptr) {
      reader_.lose({.tool = tool.edge.number,
                    .edge = tool.edge.edge,
                    .field = column.heading.empty() ? "(no heading)" : column.heading,
                    .value = shortened(cell.text),
                    .reason = "the tables have no such key"});
      return;
    }
    const ToolKey& key = *column.key;
    if (key.name == "number" || key.name == "edge") return;
    if (key.name == "kind") {
      take_kind(tool, key, cell);
    } else if (is_text(key)) {
      reader_.give_text(tool, key.name, in_one_line(cell.text));
    } else if (const auto value = number_of_cell(cell.text, separator_)) {
      const LengthUnit unit = column.unit.value_or(unit_.value_or(LengthUnit::mm));
      const double own = is_length(key) ? mm_of(*value, unit) : *value;
      reader_.give(tool, key.name, column.factor * own, cell.place);
    } else {
      reader_.fault(cell.place, "'" + shortened(cell.text) + "' is not a number (" +
                                    column.heading + "); write one, as in 6.35");
    }
  }

  void take_kind(ForeignTool& tool, const ToolKey& key, const CsvCell& cell) {
    const std::string kind = in_lower_case(cell.text);
    const auto& kinds = key.allowed.names;
    if (std::ranges::find(kinds, kind) != kinds.end()) {
      reader_.give_text(tool, "kind", kind);
      return;
    }
    std::string names;
    for (const std::string_view name : kinds)
      names += (names.empty() ? "" : ", ") + std::string(name);
    reader_.fault(cell.place,
                  "there is no kind '" + shortened(cell.text) + "'; write one of " + names);
  }

  ForeignReader reader_;
  std::optional<LengthUnit> unit_;
  char separator_ = ',';
  std::vector<CsvColumn> columns_;
};

std::string cell_of(const ToolEdge& tool, const ToolKey& key, LengthUnit unit) {
  if (is_text(key)) return csv_cell(text_of(tool, key));
  const double value = number_of(tool, key);
  return plain_number(is_length(key) ? in_unit(value, unit) : value);
}

}  // namespace

ForeignTools read_tool_csv(const ForeignSource& source) {
  CsvReader reader(source);
  reader.read(text_of(source));
  return reader.finish();
}

std::vector<ForeignFile> write_tool_csv(std::span<const ToolEdge> tools,
                                        const WriteChoice& choice) {
  std::string text;
  for (const ToolKey& key : config::tool_keys()) {
    text += (text.empty() ? "" : ",") + std::string(key.name);
    if (is_length(key)) text += "_" + std::string(name_of(choice.unit));
  }
  text += "\r\n";
  for (const ToolEdge& tool : tools) {
    std::string row;
    for (const ToolKey& key : config::tool_keys()) {
      row += (row.empty() ? "" : ",") + cell_of(tool, key, choice.unit);
    }
    text += row + "\r\n";
  }
  return {{choice.file, text}};
}

}  // namespace stanok::jobs

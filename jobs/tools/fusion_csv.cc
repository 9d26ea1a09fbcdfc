#include "jobs/tools/fusion_csv.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>

#include "jobs/tools/csv_rows.h"
#include "jobs/tools/foreign_reader.h"
#include "jobs/tools/foreign_text.h"
#include "jobs/tools/fusion_tools.h"

namespace stanok::jobs {
namespace {

struct FusionParameter {
  std::string_view name;
  std::string_view key;
  double factor = 1.0;
  enum class Of : std::uint8_t { length, angle } of = Of::length;
};
constexpr std::array fusion_parameters{
    FusionParameter{"tool_diameter", "radius", 0.5},
    FusionParameter{"tool_cornerRadius", "corner_radius"},
    FusionParameter{"tool_fluteLength", "flute_length"},
    FusionParameter{"tool_shaftDiameter", "shank_diameter"},
    FusionParameter{"tool_bodyLength", "overhang"},
    FusionParameter{"tool_assemblyGaugeLength", "length"},
    FusionParameter{"tool_tipAngle", "point_angle", 1.0, FusionParameter::Of::angle},
    FusionParameter{"tool_taperAngle", "taper_angle", 1.0, FusionParameter::Of::angle},
};
// Of a cone, the diameter of the tip.
constexpr FusionParameter diameter_of_tip{"tool_tipDiameter", "radius", 0.5};

// "tool_diameter" of "Diameter (tool_diameter)".
std::string parameter_of(const std::string& heading) {
  const std::size_t begin = heading.rfind('(');
  if (begin == std::string::npos || !heading.ends_with(')')) return heading;
  return heading.substr(begin + 1, heading.size() - begin - 2);
}

class FusionCsvReader {
 public:
  explicit FusionCsvReader(const ForeignSource& source) : reader_(source) {}

  void read(std::string_view text) {
    const CsvRows found = csv_rows(text, reader_);
    separator_ = found.separator;
    if (found.rows.empty()) return;
    for (const CsvCell& cell : found.rows.front()) headings_.push_back(parameter_of(cell.text));
    if (std::ranges::find(headings_, "tool_number") == headings_.end()) {
      reader_.fault(found.rows.front().front().place,
                    "no heading 'Number (tool_number)'; this is not a table of Fusion: export it "
                    "again, or give --format csv for a table of stanok");
      return;
    }
    for (const CsvRow& row : std::span(found.rows).subspan(1)) read_row(row);
  }
  [[nodiscard]] ForeignTools finish() { return reader_.finish(); }

 private:
  using Cells = std::map<std::string_view, const CsvCell*>;  // by parameter

  [[nodiscard]] Cells cells_of(const CsvRow& row) const {
    Cells cells;
    for (std::size_t i = 0; i < std::min(row.size(), headings_.size()); ++i) {
      if (!row[i].text.empty()) cells.emplace(headings_[i], &row[i]);
    }
    return cells;
  }

  static std::string text_in(const Cells& cells, std::string_view parameter) {
    const auto found = cells.find(parameter);
    return found == cells.end() ? "" : found->second->text;
  }

  void read_row(const CsvRow& row) {
    Cells cells = cells_of(row);
    const std::string index = text_in(cells, "tool_index");
    const auto number = number_of_cell(text_in(cells, "tool_number"), separator_);
    if (!number || *number != static_cast<double>(static_cast<int>(*number))) {
      reader_.fault(
          row.front().place,
          "no whole tool_number in this row; number the tools in Fusion and export again");
      return;
    }
    if (!index.empty() && !indices_.insert(index).second) {
      reader_.lose({.tool = static_cast<int>(*number),
                    .field = "preset_name",
                    .value = shortened(text_in(cells, "preset_name")),
                    .reason = "the tables have no presets"});
      return;
    }
    ForeignTool* tool = reader_.begin(static_cast<int>(*number), 1, row.front().place);
    if (tool == nullptr) return;
    const FusionType* type = fusion_type_named(text_in(cells, "tool_type"));
    take_texts(*tool, cells, type);
    take_values(*tool, cells, type);
    for (const std::string_view known : {"tool_index", "tool_number", "tool_unit",
                                         "tool_library_version", "CSV_TOOLS_VERSION_1"}) {
      cells.erase(known);
    }
    for (const auto& [parameter, cell] : cells) lose(*tool, parameter, cell->text, "");
  }

  void take_texts(ForeignTool& tool, Cells& cells, const FusionType* row) {
    const std::string name = in_one_line(text_in(cells, "tool_description"));
    if (!name.empty()) reader_.give_text(tool, "name", name);
    const std::string type = text_in(cells, "tool_type");
    if (row != nullptr) reader_.give_text(tool, "kind", row->kind);
    if (row == nullptr) lose(tool, "tool_type", type, "the tables have no such kind; it is flat");
    if (row != nullptr && !row->difference.empty()) lose(tool, "tool_type", type, row->difference);
    cells.erase("tool_description");
    cells.erase("tool_type");
  }

  void take_values(ForeignTool& tool, Cells& cells, const FusionType* type) {
    const LengthUnit unit =
        text_in(cells, "tool_unit") == "inches" ? LengthUnit::inch : LengthUnit::mm;
    const bool is_cone =
        type != nullptr && type->is_measured_at_its_end && cells.contains(diameter_of_tip.name);
    if (is_cone) take(tool, cells, diameter_of_tip, unit);
    for (const FusionParameter& row : fusion_parameters) {
      if (is_cone && row.key == "radius") continue;  // not carried
      take(tool, cells, row, unit);
    }
  }

  void take(ForeignTool& tool, Cells& cells, const FusionParameter& row, LengthUnit unit) {
    const auto found = cells.find(row.name);
    if (found == cells.end()) return;
    const CsvCell& cell = *found->second;
    cells.erase(found);
    const auto value = number_of_cell(cell.text, separator_);
    if (!value) {
      reader_.fault(cell.place, "'" + shortened(cell.text) + "' is not a number (" +
                                    std::string(row.name) + "); export the table again");
      return;
    }
    const double own = row.of == FusionParameter::Of::length ? mm_of(*value, unit) : *value;
    reader_.give(tool, row.key, row.factor * own, cell.place);
  }

  // What says nothing is not lost.
  void lose(const ForeignTool& tool, std::string_view parameter, const std::string& value,
            std::string_view reason) {
    if (value.empty() || value == "0" || in_lower_case(value) == "false") return;
    reader_.lose(
        {.tool = tool.edge.number,
         .field = std::string(parameter),
         .value = shortened(value),
         .reason = reason.empty() ? "the tables have no such value" : std::string(reason)});
  }

  ForeignReader reader_;
  char separator_ = ',';
  std::vector<std::string> headings_;
  std::set<std::string> indices_;
};

}  // namespace

ForeignTools read_fusion_csv(const ForeignSource& source) {
  FusionCsvReader reader(source);
  reader.read(text_of(source));
  return reader.finish();
}

}  // namespace stanok::jobs

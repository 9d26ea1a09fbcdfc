#include "jobs/tools/tool_formats.h"

#include <algorithm>

#include "jobs/tools/foreign_text.h"
#include "jobs/tools/freecad_tools.h"
#include "jobs/tools/fusion_csv.h"
#include "jobs/tools/fusion_tools.h"
#include "jobs/tools/linuxcnc_table.h"
#include "jobs/tools/offset_listing.h"
#include "jobs/tools/tool_csv.h"
#include "jobs/tools/tool_values.h"

namespace stanok::jobs {
namespace {

std::vector<CarriedKey> all_keys() {
  std::vector<CarriedKey> keys;
  for (const ToolKey& key : config::tool_keys()) {
    const bool tells_tools_apart = key.name == "number" || key.name == "edge";
    if (!tells_tools_apart && key.name != "kind") keys.push_back({key.name});
  }
  return keys;
}

std::vector<CarriedKey> keys_of_listings() {
  return {{"name"}, {"length"}, {"wear_length"}, {"radius"}, {"wear_radius"}};
}

std::string names_of(bool (*is_meant)(const ToolFormat&)) {
  std::string names;
  for (const ToolFormat& format : tool_formats()) {
    if (is_meant(format)) names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

std::string in_code(std::string_view text) {
  return "`" + std::string(text) + "`";
}

std::string carried_text(const ToolFormat& format) {
  std::string text = format.numbers == ToolNumbers::number ? "`number`" : "`number`, `edge`";
  for (const CarriedKey& carried : format.carried) {
    text += ", " + in_code(carried.key);
    if (!carried.kinds.empty()) text += " (" + std::string(carried.kinds) + ")";
  }
  if (format.kinds.empty()) return text;
  text += ", `kind` (";
  for (const std::string_view kind : format.kinds) {
    text += (kind == format.kinds.front() ? "" : " ") + std::string(kind);
  }
  return text + ")";
}

std::string suffixes_text(const ToolFormat& format) {
  std::string text;
  for (const std::string_view suffix : format.suffixes) {
    text += (text.empty() ? "" : ", ") + in_code(suffix);
  }
  return text.empty() ? "–" : text;
}

std::string decimals_text(const ToolFormat& format) {
  if (format.decimals.mm == 0) return "all";
  return std::to_string(format.decimals.mm) + " (mm), " + std::to_string(format.decimals.inch) +
         " (inch)";
}

}  // namespace

const std::vector<ToolFormat>& tool_formats() {
  static const std::vector<ToolFormat> formats{
      {.name = "linuxcnc",
       .title = "LinuxCNC tool table",
       .suffixes = {".tbl"},
       .read = &read_linuxcnc_table,
       .write = &write_linuxcnc_table,
       .carried = {{"name"},
                   {"length"},
                   {"length_x"},
                   {"length_y"},
                   {"radius"},
                   {"orientation"},
                   {"angle_front"},
                   {"angle_back"}},
       .kinds = {}},
      {.name = "csv",
       .title = "tables with keys of the tables file as headings, for spreadsheets",
       .suffixes = {".csv"},
       .read = &read_tool_csv,
       .write = &write_tool_csv,
       .carried = all_keys(),
       .kinds = tool_key("kind").allowed.names,
       .numbers = ToolNumbers::number_and_edge},
      {.name = "freecad",
       .title = "FreeCAD tool libraries and, to import, tool bits",
       .suffixes = {".fctl", ".fctb"},
       .read = &read_freecad_tools,
       .write = &write_freecad_tools,
       .carried = {{"name"},
                   {"radius"},
                   {"corner_radius", "bull"},
                   {"flute_length"},
                   {"shank_diameter"},
                   {"point_angle", "drill"},
                   {"taper_angle", "taper"}},
       .kinds = {"flat", "ball", "bull", "drill", "taper", "probe"}},
      {.name = "fusion",
       .title = "Fusion tool libraries",
       .suffixes = {".json", ".tools"},
       .read = &read_fusion_tools,
       .write = &write_fusion_tools,
       .carried = {{"name"},
                   {"length"},
                   {"radius"},
                   {"corner_radius"},
                   {"flute_length"},
                   {"shank_diameter"},
                   {"holder_diameter"},
                   {"holder_length"},
                   {"point_angle"},
                   {"taper_angle"},
                   {"overhang"}},
       .kinds = tool_key("kind").allowed.names},
      {.name = "fusion-csv",
       .title = "Fusion and HSMWorks tables",
       .suffixes = {},
       .read = &read_fusion_csv,
       .carried = {{"name"},
                   {"length"},
                   {"radius"},
                   {"corner_radius"},
                   {"flute_length"},
                   {"shank_diameter"},
                   {"point_angle"},
                   {"taper_angle"},
                   {"overhang"}},
       .kinds = tool_key("kind").allowed.names},
      {.name = "fanuc",
       .title = "Fanuc offset listings",
       .suffixes = {},
       .read = &read_fanuc_offsets,
       .write = &write_fanuc_offsets,
       .carried = keys_of_listings(),
       .kinds = {},
       .decimals = {.mm = 3, .inch = 4}},
      {.name = "haas",
       .title = "Haas offset listings",
       .suffixes = {".ofs"},
       .read = &read_haas_offsets,
       .write = &write_haas_offsets,
       .carried = keys_of_listings(),
       .kinds = {},
       .decimals = {.mm = 3, .inch = 4}},
  };
  return formats;
}

const ToolFormat* tool_format_named(std::string_view name) {
  const auto& formats = tool_formats();
  const auto found = std::ranges::find(formats, name, &ToolFormat::name);
  return found == formats.end() ? nullptr : &*found;
}

const ToolFormat* tool_format_of(const std::filesystem::path& file) {
  const std::string suffix = in_lower_case(file.extension().string());
  const ToolFormat* found = nullptr;
  for (const ToolFormat& format : tool_formats()) {
    if (std::ranges::find(format.suffixes, suffix) == format.suffixes.end()) continue;
    if (found != nullptr) return nullptr;
    found = &format;
  }
  return found;
}

std::string names_of_readable_formats() {
  return names_of([](const ToolFormat& format) { return format.read != nullptr; });
}

std::string names_of_writable_formats() {
  return names_of([](const ToolFormat& format) { return format.write != nullptr; });
}

std::string table_of_tool_formats() {
  std::string text =
      "| format | files of | ends in | decimals | keys of the tables file that it carries |\n"
      "|---|---|---|---|---|\n";
  for (const ToolFormat& format : tool_formats()) {
    text += "| " + in_code(format.name) + " | " + std::string(format.title) +
            (format.write == nullptr ? ", import only" : "") + " | " + suffixes_text(format) +
            " | " + decimals_text(format) + " | " + carried_text(format) + " |\n";
  }
  return text;
}

}  // namespace stanok::jobs

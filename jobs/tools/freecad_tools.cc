#include "jobs/tools/freecad_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "jobs/tools/foreign_reader.h"
#include "jobs/tools/foreign_text.h"
#include "jobs/tools/json_members.h"

namespace stanok::jobs {
namespace {

namespace fs = std::filesystem;
using channels::ToolEdge;

// A bit has no number of its own.
constexpr int number_of_single_bit = 1;

struct BitShape {
  std::string_view shape;  // without its end
  std::string_view kind;
};
// Of several with one kind, the first is written.
constexpr std::array bit_shapes{
    BitShape{"endmill", "flat"},  BitShape{"ballend", "ball"}, BitShape{"bullnose", "bull"},
    BitShape{"drill", "drill"},   BitShape{"v-bit", "taper"},  BitShape{"vbit", "taper"},
    BitShape{"chamfer", "taper"}, BitShape{"probe", "probe"},
};

struct BitUnit {
  std::string_view name;
  double factor;  // to mm or deg
  LengthUnit unit = LengthUnit::mm;
};
constexpr std::array length_units{
    BitUnit{"mm", 1.0},
    BitUnit{"", 1.0},
    BitUnit{"cm", 10.0},
    BitUnit{"m", 1000.0},
    BitUnit{"in", 1.0, LengthUnit::inch},
    BitUnit{"\"", 1.0, LengthUnit::inch},
    BitUnit{"inch", 1.0, LengthUnit::inch},
    BitUnit{"ft", 12.0, LengthUnit::inch},
};
constexpr std::array angle_units{BitUnit{"deg", 1.0}, BitUnit{"", 1.0}, BitUnit{"°", 1.0},
                                 BitUnit{"rad", 180.0 / std::numbers::pi}};

struct BitParameter {
  std::string_view name;
  std::string_view key;
  double factor = 1.0;
};
// FlatRadius of a bull nose is the radius of its corner, as the newer CornerRadius.
constexpr std::array bit_parameters{
    BitParameter{"CuttingEdgeHeight", "flute_length"},
    BitParameter{"ShankDiameter", "shank_diameter"},
    BitParameter{"FlatRadius", "corner_radius"},
    BitParameter{"CornerRadius", "corner_radius"},
};

double tangent_of(double angle_deg) {
  return std::tan(angle_deg * std::numbers::pi / 180.0);
}

// A cone has the diameter of its tip in the tables; that of its upper end follows from its height.
double upper_diameter(const ToolEdge& cone) {
  return 2.0 * (cone.radius + cone.flute_length * tangent_of(cone.taper_angle));
}

class BitReader {
 public:
  explicit BitReader(const ForeignSource& source) : source_(source), reader_(source) {}

  void read(std::string_view text) {
    const auto json = json_of(text, reader_);
    if (!json) return;
    if (json->is_object() && json->contains("tools")) {
      read_library(*json);
    } else {
      reader_.remark("a tool bit has no number: it becomes tool 1; a library (.fctl) numbers it");
      read_bit(*json, number_of_single_bit, "");
    }
  }
  [[nodiscard]] ForeignTools finish() { return reader_.finish(); }

 private:
  void read_library(const Json& json) {
    JsonMembers library(json, "", reader_);
    library.take("version");
    library.take("label");
    const Json& tools = library.list("tools");
    for (std::size_t i = 0; i < tools.size(); ++i) {
      read_entry(tools[i], "tools[" + std::to_string(i) + "]");
    }
    library.lose_the_rest(0, "the tables have no such value");
  }

  void read_entry(const Json& json, const std::string& path) {
    JsonMembers entry(json, path, reader_);
    const auto number = entry.number("nr");
    const auto file = entry.text("path");
    if (!number || !file || *number != std::trunc(*number) || std::abs(*number) > 1e9) {
      reader_.fault({.member = path},
                    "must have a whole number nr and a path; save the library again in FreeCAD");
      return;
    }
    entry.lose_the_rest(static_cast<int>(*number), "the tables have no such value");
    const auto bytes = bytes_of_bit(*file);
    if (!bytes) {
      reader_.fault(
          entry.place_of_member("path"),
          "the tool bit " + shortened(*file) +
              " is neither beside the library nor in Bit beside its folder; copy it there");
      return;
    }
    ForeignSource bit = source_;
    bit.file = *file;
    bit.bytes = *bytes;
    if (const auto parsed = json_of(text_of(bit), reader_, *file)) {
      read_bit(*parsed, static_cast<int>(*number), *file);
    }
  }

  // A path that leads elsewhere is not followed: only the name of the bit is used.
  std::optional<std::string> bytes_of_bit(const std::string& path) {
    const fs::path name = fs::path(path).filename();
    if (!source_.other_file || name.empty()) return std::nullopt;
    const fs::path folder = source_.file.parent_path();
    for (const fs::path& place :
         {folder / name, folder / ".." / "Bit" / name, folder / "Bit" / name}) {
      if (auto bytes = source_.other_file(place)) return bytes;
    }
    return std::nullopt;
  }

  void read_bit(const Json& json, int number, const std::string& file) {
    JsonMembers bit(json, "", reader_, file);
    ForeignTool* tool = reader_.begin(number, 1, {.file = file});
    if (tool == nullptr) return;
    bit.take("version");
    if (const auto name = bit.text("name"); name && !name->empty()) {
      reader_.give_text(*tool, "name", in_one_line(*name));
    }
    take_shape(*tool, bit);
    JsonMembers parameters = bit.object("parameter");
    if (tool->edge.kind == "taper") {
      take_cone(*tool, parameters);
    } else {
      take_cutter(*tool, parameters);
    }
    parameters.lose_the_rest(number, "the tables have no such value");
    bit.object("attribute").lose_the_rest(number, "the tables have no such value");
    bit.lose_the_rest(number, "the tables have no such value");
  }

  void take_shape(ForeignTool& tool, JsonMembers& bit) {
    const std::string shape = bit.text("shape").value_or("");
    bit.take("shape-type");
    const std::string stem = in_lower_case(fs::path(shape).stem().string());
    const auto row = std::ranges::find(bit_shapes, stem, &BitShape::shape);
    if (row != bit_shapes.end()) {
      reader_.give_text(tool, "kind", row->kind);
    } else if (!shape.empty()) {
      reader_.lose({.tool = tool.edge.number,
                    .field = "shape",
                    .value = shortened(shape),
                    .reason = "the tables have no such kind; it is flat"});
    }
  }

  void take_cutter(ForeignTool& tool, JsonMembers& parameters) {
    take(tool, parameters, "Diameter", "radius", 0.5);
    for (const BitParameter& row : bit_parameters) {
      take(tool, parameters, row.name, row.key, row.factor);
    }
    if (tool.edge.kind == "drill") take(tool, parameters, "TipAngle", "point_angle", 1.0);
  }

  void take_cone(ForeignTool& tool, JsonMembers& parameters) {
    take(tool, parameters, "TipDiameter", "radius", 0.5);
    take(tool, parameters, "CuttingEdgeAngle", "taper_angle", 0.5);
    for (const BitParameter& row : bit_parameters) {
      take(tool, parameters, row.name, row.key, row.factor);
    }
    const auto diameter = value_of(parameters, "Diameter", Quantity::length);
    constexpr double smallest_difference_mm = 1e-6;
    if (!diameter || std::abs(*diameter - upper_diameter(tool.edge)) < smallest_difference_mm) {
      return;
    }
    reader_.lose({.tool = tool.edge.number,
                  .field = "Diameter",
                  .value = plain_number(*diameter),
                  .reason = "a taper has the diameter of its tip, its angle and its flute length"});
  }

  enum class Quantity : std::uint8_t { length, angle };

  void take(ForeignTool& tool, JsonMembers& parameters, std::string_view name, std::string_view key,
            double factor) {
    const Quantity quantity = key.ends_with("angle") ? Quantity::angle : Quantity::length;
    if (const auto value = value_of(parameters, name, quantity)) {
      reader_.give(tool, key, factor * *value, parameters.place_of_member(name));
    }
  }

  // In mm or deg.
  std::optional<double> value_of(JsonMembers& parameters, std::string_view name,
                                 Quantity quantity) {
    const Json* member = parameters.take(name);
    if (member == nullptr || member->is_null()) return std::nullopt;
    if (member->is_number()) return member->get<double>();
    const std::string text = member->is_string() ? member->get<std::string>() : "";
    const std::string_view trimmed_text = trimmed(text);
    const std::size_t end =
        std::min(trimmed_text.find_first_not_of("0123456789+-.,eE"), trimmed_text.size());
    const auto value = number_with_comma(trimmed_text.substr(0, end));
    const std::string_view unit = trimmed(trimmed_text.substr(end));
    const auto scaled = value ? scaled_value(*value, unit, quantity) : std::nullopt;
    if (!scaled) {
      reader_.fault(parameters.place_of_member(name),
                    "is '" + shown(*member) + "'; write a number and its unit, as in \"" +
                        (quantity == Quantity::length ? "6.0 mm\" or \"0.25 in\"" : "118 deg\""));
    }
    return scaled;
  }

  static std::optional<double> number_with_comma(std::string_view text) {
    std::string written(text);
    std::ranges::replace(written, ',', '.');
    return number_of_text(written);
  }

  static std::optional<double> scaled_value(double value, std::string_view unit,
                                            Quantity quantity) {
    if (quantity == Quantity::angle) {
      const auto row = std::ranges::find(angle_units, unit, &BitUnit::name);
      return row == angle_units.end() ? std::nullopt : std::optional(row->factor * value);
    }
    const auto row = std::ranges::find(length_units, unit, &BitUnit::name);
    if (row == length_units.end()) return std::nullopt;
    return mm_of(row->factor * value, row->unit);
  }

  const ForeignSource& source_;
  ForeignReader reader_;
};

std::string length_text(double value_mm, LengthUnit unit) {
  return plain_number(in_unit(value_mm, unit)) + (unit == LengthUnit::mm ? " mm" : " in");
}

std::string angle_text(double angle_deg) {
  return plain_number(angle_deg) + " deg";
}

// What is 0 is not known: FreeCAD takes the value of the shape.
Json parameters_of(const ToolEdge& tool, LengthUnit unit) {
  Json parameters = Json::object();
  if (tool.flute_length != 0.0) {
    parameters["CuttingEdgeHeight"] = length_text(tool.flute_length, unit);
  }
  if (tool.kind == "taper") {
    parameters["CuttingEdgeAngle"] = angle_text(2.0 * tool.taper_angle);
    parameters["Diameter"] = length_text(upper_diameter(tool), unit);
    parameters["TipDiameter"] = length_text(2.0 * tool.radius, unit);
  } else {
    parameters["Diameter"] = length_text(2.0 * tool.radius, unit);
  }
  if (tool.kind == "bull") parameters["FlatRadius"] = length_text(tool.corner_radius, unit);
  const bool has_point = tool.kind == "drill" && tool.point_angle != 0.0;
  if (has_point) parameters["TipAngle"] = angle_text(tool.point_angle);
  if (tool.shank_diameter != 0.0) {
    parameters["ShankDiameter"] = length_text(tool.shank_diameter, unit);
  }
  return parameters;
}

std::string bit_text(const ToolEdge& tool, LengthUnit unit) {
  const auto row = std::ranges::find(bit_shapes, tool.kind, &BitShape::kind);
  const std::string shape(row == bit_shapes.end() ? "endmill" : row->shape);
  Json bit;
  bit["version"] = 2;
  bit["name"] = tool.name;
  bit["shape"] = shape + ".fcstd";
  bit["parameter"] = parameters_of(tool, unit);
  bit["attribute"] = Json::object();
  return json_file_text(bit);
}

// Bits of libraries in Library lie in Bit, others beside them.
fs::path folder_of_bits(const fs::path& library) {
  const fs::path folder = library.parent_path();
  return folder.filename() == "Library" ? folder.parent_path() / "Bit" : folder;
}

}  // namespace

ForeignTools read_freecad_tools(const ForeignSource& source) {
  BitReader reader(source);
  reader.read(text_of(source));
  return reader.finish();
}

std::vector<ForeignFile> write_freecad_tools(std::span<const ToolEdge> tools,
                                             const WriteChoice& choice) {
  if (in_lower_case(choice.file.extension().string()) == ".fctb") {
    throw config::ConfigError(
        {{.file = choice.file.string(),
          .text = "a tool bit has no number; export a library, which ends in .fctl: its tool bits "
                  "are written beside it"}});
  }
  std::vector<ForeignFile> files;
  Json library{{"label", choice.file.stem().string()}, {"tools", Json::array()}, {"version", 1}};
  for (const ToolEdge& tool : tools) {
    const std::string name =
        choice.file.stem().string() + "_T" + std::to_string(tool.number) + ".fctb";
    files.push_back({folder_of_bits(choice.file) / name, bit_text(tool, choice.unit)});
    library["tools"].push_back({{"nr", tool.number}, {"path", name}});
  }
  files.push_back({choice.file, json_file_text(library)});
  return files;
}

}  // namespace stanok::jobs

#include "jobs/tools/fusion_tools.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "jobs/tools/foreign_reader.h"
#include "jobs/tools/foreign_text.h"
#include "jobs/tools/json_members.h"
#include "jobs/tools/zip_members.h"

namespace stanok::jobs {
namespace {

using channels::ToolEdge;

// Of several with one kind, the first is written.
constexpr std::string_view tip_only = "the diameter of a taper is that of its tip";
constexpr std::string_view shape_differs = "the kind is the nearest of the tables";
constexpr std::array fusion_types{
    FusionType{"flat end mill", "flat"},
    FusionType{"ball end mill", "ball"},
    FusionType{"bull nose end mill", "bull"},
    FusionType{"drill", "drill"},
    FusionType{"tapered mill", "taper"},
    FusionType{"probe", "probe"},
    FusionType{"turning general", "insert"},
    FusionType{"face mill", "flat", shape_differs},
    FusionType{"slot mill", "flat", shape_differs},
    FusionType{"reamer", "flat", shape_differs},
    FusionType{"boring bar", "flat", shape_differs},
    FusionType{"counter bore", "flat", shape_differs},
    FusionType{"spot drill", "drill", shape_differs},
    FusionType{"center drill", "drill", shape_differs},
    FusionType{"chamfer mill", "taper", shape_differs, true},
    FusionType{"counter sink", "taper", shape_differs, true},
    FusionType{"turning boring", "insert", shape_differs},
    FusionType{"turning threading", "insert", shape_differs},
    FusionType{"turning grooving", "insert", shape_differs},
};

struct FusionLength {
  std::string_view name;
  std::string_view key;
  double factor = 1.0;
};
constexpr std::array fusion_lengths{
    FusionLength{"RE", "corner_radius"},           FusionLength{"LCF", "flute_length"},
    FusionLength{"SFDM", "shank_diameter"},        FusionLength{"LB", "overhang"},
    FusionLength{"assemblyGaugeLength", "length"},
};
constexpr std::array fusion_angles{FusionLength{"SIG", "point_angle"},
                                   FusionLength{"TA", "taper_angle"}};

constexpr std::string_view nothing_like_it = "the tables have no such value";

class FusionReader {
 public:
  explicit FusionReader(const ForeignSource& source) : source_(source), reader_(source) {}

  void read() {
    if (!is_zip(source_.bytes)) {
      read_text(text_of(source_), source_.file.string());
      return;
    }
    const auto members = zip_members(source_.bytes, ".json");
    if (!members) {
      reader_.fault({}, members.error());
      return;
    }
    for (const UnpackedMember& member : *members) {
      ForeignSource inner = source_;
      inner.file = source_.file / member.name;
      inner.bytes = member.bytes;
      read_text(text_of(inner), inner.file.string());
    }
    if (members->empty()) reader_.fault({}, "no .json in this ZIP file; export it again");
  }
  [[nodiscard]] ForeignTools finish() { return reader_.finish(); }

 private:
  void read_text(const std::string& text, const std::string& file) {
    const auto json = json_of(text, reader_, file);
    if (!json) return;
    JsonMembers library(*json, "", reader_, file);
    library.take("version");
    const Json& tools = library.list("data");
    for (std::size_t i = 0; i < tools.size(); ++i) {
      read_tool(tools[i], "data[" + std::to_string(i) + "]", file);
    }
    library.lose_the_rest(0, nothing_like_it);
  }

  void read_tool(const Json& json, const std::string& path, const std::string& file) {
    JsonMembers members(json, path, reader_, file);
    const std::string type = members.text("type").value_or("");
    const std::string description = in_one_line(members.text("description").value_or(""));
    if (type == "holder") {
      reader_.lose({.tool = 0,
                    .field = path,
                    .value = shortened(description),
                    .reason = "a holder without a tool"});
      return;
    }
    JsonMembers post = members.object("post-process");
    const auto number = post.number("number");
    if (!number || *number != std::trunc(*number) || std::abs(*number) > 1e9) {
      reader_.fault(post.place_of_member("number"),
                    "the tool has no whole number; number the tools in Fusion and export again");
      return;
    }
    const LengthUnit unit = unit_of(members, LengthUnit::mm);
    ForeignTool* tool = reader_.begin(static_cast<int>(*number), 1, post.place_of_member("number"));
    if (tool == nullptr) return;
    if (!description.empty()) reader_.give_text(*tool, "name", description);
    take_type(*tool, type);
    take_geometry(*tool, members, unit, fusion_type_named(type));
    take_holder(*tool, members, unit);
    take_post(*tool, post);
    members.lose_the_rest(tool->edge.number, nothing_like_it);
  }

  LengthUnit unit_of(JsonMembers& members, LengthUnit otherwise) {
    const auto unit = members.text("unit");
    if (!unit) return otherwise;
    if (*unit == "inches") return LengthUnit::inch;
    if (*unit != "millimeters") {
      reader_.fault(members.place_of_member("unit"),
                    "is '" + shortened(*unit) + "'; it must be millimeters or inches");
    }
    return LengthUnit::mm;
  }

  void take_type(ForeignTool& tool, const std::string& type) {
    const FusionType* row = fusion_type_named(type);
    if (row != nullptr) reader_.give_text(tool, "kind", row->kind);
    const std::string_view difference =
        row == nullptr ? "the tables have no such kind; it is flat" : row->difference;
    if (difference.empty() || type.empty()) return;
    reader_.lose({.tool = tool.edge.number,
                  .field = "type",
                  .value = shortened(type),
                  .reason = std::string(difference)});
  }

  void give(ForeignTool& tool, JsonMembers& members, const FusionLength& row, LengthUnit unit) {
    if (const auto value = members.number(row.name)) {
      reader_.give(tool, row.key, row.factor * mm_of(*value, unit),
                   members.place_of_member(row.name));
    }
  }

  void take_geometry(ForeignTool& tool, JsonMembers& members, LengthUnit unit,
                     const FusionType* type) {
    JsonMembers geometry = members.object("geometry");
    const Json* tip = geometry.take("tip-diameter");
    const bool has_tip =
        type != nullptr && type->is_measured_at_its_end && tip != nullptr && tip->is_number();
    if (has_tip) {
      give(tool, geometry, {"tip-diameter", "radius", 0.5}, unit);
      if (const auto diameter = geometry.number("DC")) lose_value(tool, "DC", *diameter, tip_only);
    } else {
      give(tool, geometry, {"DC", "radius", 0.5}, unit);
      if (tip != nullptr) lose_json(tool, "tip-diameter", *tip);
    }
    for (const FusionLength& row : fusion_lengths) give(tool, geometry, row, unit);
    for (const FusionLength& row : fusion_angles) give(tool, geometry, row, LengthUnit::mm);
    geometry.lose_the_rest(tool.edge.number, nothing_like_it);
  }

  void lose_value(const ForeignTool& tool, std::string_view name, double value,
                  std::string_view reason) {
    reader_.lose({.tool = tool.edge.number,
                  .field = std::string(name),
                  .value = plain_number(value),
                  .reason = std::string(reason)});
  }
  void lose_json(const ForeignTool& tool, std::string_view name, const Json& value) {
    if (value == Json(0)) return;
    reader_.lose({.tool = tool.edge.number,
                  .field = std::string(name),
                  .value = shown(value),
                  .reason = std::string(nothing_like_it)});
  }

  // The tables have a holder as one cylinder: as wide as the widest segment, as long as all.
  void take_holder(ForeignTool& tool, JsonMembers& members, LengthUnit unit_of_tool) {
    JsonMembers holder = members.object("holder");
    const LengthUnit unit = unit_of(holder, unit_of_tool);
    const Json& segments = holder.list("segments");
    holder.take("type");
    double diameter = 0.0;
    double length = 0.0;
    bool is_cylinder = true;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      JsonMembers segment(segments[i],
                          holder.place_of_member("segments").member + "[" + std::to_string(i) + "]",
                          reader_);
      const double lower = segment.number("lower-diameter").value_or(0.0);
      const double upper = segment.number("upper-diameter").value_or(lower);
      length += segment.number("height").value_or(0.0);
      is_cylinder = is_cylinder && lower == upper && (i == 0 || lower == diameter);
      diameter = std::max({diameter, lower, upper});
    }
    if (!segments.empty()) {
      const ForeignPlace place = holder.place_of_member("segments");
      reader_.give(tool, "holder_diameter", mm_of(diameter, unit), place);
      reader_.give(tool, "holder_length", mm_of(length, unit), place);
    }
    if (!is_cylinder) {
      reader_.lose({.tool = tool.edge.number,
                    .field = "holder.segments",
                    .value = shown(segments),
                    .reason = "a holder is one cylinder, as wide as the widest segment"});
    }
    holder.lose_the_rest(tool.edge.number, "of a holder, the tables have its cylinder only",
                         "holder.");
  }

  // Offsets that have the number of the tool say nothing new.
  void take_post(ForeignTool& tool, JsonMembers& post) {
    for (const std::string_view name : {"diameter-offset", "length-offset"}) {
      const Json* value = post.take(name);
      if (value != nullptr && !value->is_null() && *value != Json(tool.edge.number)) {
        lose_json(tool, name, *value);
      }
    }
    post.lose_the_rest(tool.edge.number, nothing_like_it);
  }

  const ForeignSource& source_;
  ForeignReader reader_;
};

Json geometry_of(const ToolEdge& tool, LengthUnit unit) {
  Json geometry{{"DC", in_unit(2.0 * tool.radius, unit)}};
  const auto add = [&](std::string_view name, double value) {
    if (value != 0.0) geometry[std::string(name)] = value;
  };
  add("RE", in_unit(tool.corner_radius, unit));
  add("LCF", in_unit(tool.flute_length, unit));
  add("SFDM", in_unit(tool.shank_diameter, unit));
  add("LB", in_unit(tool.overhang, unit));
  add("assemblyGaugeLength", in_unit(tool.length, unit));
  add("SIG", tool.point_angle);
  add("TA", tool.taper_angle);
  return geometry;
}

Json holder_json_of(const ToolEdge& tool, LengthUnit unit) {
  Json segment = Json::object();
  segment["height"] = in_unit(tool.holder_length, unit);
  segment["lower-diameter"] = in_unit(tool.holder_diameter, unit);
  segment["upper-diameter"] = segment["lower-diameter"];
  Json holder{{"type", "holder"}};
  holder["segments"] = Json::array();
  holder["segments"].push_back(std::move(segment));
  return holder;
}

Json tool_json_of_fusion(const ToolEdge& tool, LengthUnit unit) {
  const std::string unit_text = unit == LengthUnit::mm ? "millimeters" : "inches";
  const auto row = std::ranges::find(fusion_types, tool.kind, &FusionType::kind);
  Json json{{"type", row == fusion_types.end() ? fusion_types.front().type : row->type},
            {"unit", unit_text},
            {"description", tool.name},
            {"geometry", geometry_of(tool, unit)}};
  if (tool.holder_diameter != 0.0 || tool.holder_length != 0.0) {
    json["holder"] = holder_json_of(tool, unit);
    json["holder"]["unit"] = unit_text;
  }
  json["post-process"] = {
      {"number", tool.number}, {"diameter-offset", tool.number}, {"length-offset", tool.number}};
  return json;
}

}  // namespace

const FusionType* fusion_type_named(std::string_view type) {
  const auto* found = std::ranges::find(fusion_types, type, &FusionType::type);
  return found == fusion_types.end() ? nullptr : found;
}

ForeignTools read_fusion_tools(const ForeignSource& source) {
  FusionReader reader(source);
  reader.read();
  return reader.finish();
}

std::vector<ForeignFile> write_fusion_tools(std::span<const ToolEdge> tools,
                                            const WriteChoice& choice) {
  Json library{{"data", Json::array()}, {"version", 1}};
  for (const ToolEdge& tool : tools) {
    library["data"].push_back(tool_json_of_fusion(tool, choice.unit));
  }
  std::string text = json_file_text(library);
  const bool is_packed = in_lower_case(choice.file.extension().string()) == ".tools";
  return {{choice.file, is_packed ? zip_of({"tools.json", text}) : text}};
}

}  // namespace stanok::jobs

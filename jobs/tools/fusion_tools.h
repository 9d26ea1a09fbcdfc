// Tool libraries of Fusion: JSON, or .tools, a ZIP file with the same JSON in tools.json.
//
//   {"data": [{"type": "flat end mill", "unit": "millimeters", "description": "6 mm",
//              "geometry": {"DC": 6, "LCF": 18, "OAL": 57, "SFDM": 6, "LB": 35},
//              "holder": {"segments": [{"height": 55, "lower-diameter": 32, "upper-diameter":
//              32}]}, "post-process": {"number": 3}}], "version": 1}
//
// Each tool has its unit, and its holder has one of its own. DC is the cutting diameter, RE the
// corner radius, LCF the flute length, SFDM the diameter of the shank, LB the length below the
// holder, SIG the point angle, TA the taper angle, assemblyGaugeLength the length from the spindle
// nose: a design value, not a measured one. Names after ISO 13399.
// Source: libraries that Fusion exports.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

[[nodiscard]] ForeignTools read_fusion_tools(const ForeignSource& source);
// For a file that ends in .tools the ZIP file, else JSON.
[[nodiscard]] std::vector<ForeignFile> write_fusion_tools(std::span<const channels::ToolEdge> tools,
                                                          const WriteChoice& choice);

// What a type of Fusion is in the tables file.
struct FusionType {
  std::string_view type;
  std::string_view kind;
  std::string_view difference{};  // what the kind lacks of the type; empty: nothing
  // Cones of which DC is the diameter at the upper end, not at the tip.
  bool is_measured_at_its_end = false;
};
// Null: no kind is like it.
[[nodiscard]] const FusionType* fusion_type_named(std::string_view type);

}  // namespace stanok::jobs

#include "protocol/contract/result_shapes.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "protocol/contract/json_rpc.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

// What "$name" stands for.
constexpr auto named_shapes = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"alarm",
     R"({"channel":"integer","number":"integer","cycle":"integer","at":"number?","code":"string","text":"string",
      "file":"string?","line":"integer?","column":"integer?","reaction":"integer?",
      "remedy":"string?","acknowledged?":"boolean"})"},
    // Accepted, or, when the end is waited for, how the run ended.
    {"end of run", R"({"accepted?":"boolean","program?":"string","ok?":"boolean",
      "blocks?":"integer","time_s?":"number","path_mm?":"number"})"},
    {"percentiles", R"({"p50":"number","p90?":"number","p99":"number","p999":"number",
      "max":"number"})"},
    {"numbers", R"({"*":"number"})"},
    {"counts", R"({"*":"integer"})"},
    {"tool", R"({"number":"integer","edge":"integer","name":"string","kind":"string",
      "length":"number","length_x":"number","length_y":"number","radius":"number",
      "corner_radius":"number","wear_length":"number","wear_length_x":"number",
      "wear_radius":"number","overhang":"number",
      "flute_length":"number","shank_diameter":"number","holder_diameter":"number",
      "holder_length":"number","orientation":"integer","angle_front":"number",
      "angle_back":"number","point_angle":"number","taper_angle":"number"})"},
    {"axis", R"({"position":"number","verified":"boolean","takes_part":"boolean",
      "enabled":"boolean","brake":"boolean"})"},
    {"spindle", R"({"id":"integer","direction":"string","commanded_rev_min":"number",
      "actual_rev_min":"number?","power_w":"number?"})"},
    {"carried", R"({"scheme":"integer","pose":["number"]})"},
    {"on_part", R"({"tip":["number"],"direction":["number"],"work":"any","machine":"any"})"},
    {"wait", R"({"for":"string","number":"integer?","channels":["integer"]})"},
    {"channel", R"({"id":"integer","name":"string","words":["string"],"axis_names":["string"],
      "cycle":"integer","age_ms":"integer","state":"string","program_status":"string",
      "waits_for":"$wait?","single_block":"boolean","optional_stop":"boolean","first_part":"boolean",
      "block_skip":["integer"],"work_offset":"string?","coolant":["string"],"held_by":"string?",
      "aside":"boolean","retrace":{"blocks":"integer","to_line":"integer","line":"integer?"},
      "spindles_off":"boolean","coolant_off":"boolean","tap_in_hole":"boolean","controlled_by":"string?",
      "alarm":"$alarm?","program":"string?","run":"integer","file":"string?","line":"integer","block":"integer",
      "scheme":"integer","situation":"integer","units":"string","diameter":["string"],
      "position":"$numbers","point_W":"$numbers","to_go":"$numbers?","axes":{"*":"$axis"},
      "feed_mm_s":"number","speed_mm_s":"number","feed_mm_min":"number","feed_mm_rev":"number",
      "speed_mm_min":"number","g_codes":["string"],"m_codes":["string"],
      "tool":{"number":"integer","edge":"integer","name":"string?"},
      "tool_direction":"any","on_part":"$on_part?","spindles":["$spindle"],
      "override":{"feed":"number","rapid":"number","spindle":"number"},"begins_at":"string?",
      "predicted_s":"number?","remaining_s":"number?","planned_path":"integer?",
      "foreseen":"$alarm?",
      "queue":{"programs":"integer","started":"boolean","version":"integer"}})"},
    {"queues", R"({"queues":[{"channel":"integer","started":"boolean","started_by":"string?",
      "stopped_by":"string?","under_way":"integer?",
      "programs":[{"id":"integer","program":"string"}]}]})"},
    {"drive", R"({"axis":"string","state":"string","in_contact":"boolean","fault_code":"integer",
      "position":"number","velocity":"number","following_error":"number","power_w":"number",
      "vibration_um":"number","vibration_hz":"number","temperature_c":"number",
      "referenced":"boolean","brake_closed":"boolean","home_switch":"boolean",
      "limit_negative":"boolean","limit_positive":"boolean","index_position":"number",
      "index_count":"integer","losses":"integer","answers":"integer","errors":"integer",
      "errors_by_kind":"$counts"})"},
});

std::string_view named_shape(std::string_view name) {
  const auto row = std::find_if(named_shapes.begin(), named_shapes.end(),
                                [&](const auto& one) { return one.first == name; });
  return row == named_shapes.end() ? "\"any\"" : row->second;
}

json schema_of(const json& shape);

json or_null(json schema) {
  return {{"anyOf", {std::move(schema), {{"type", "null"}}}}};
}

json schema_of_type(std::string type) {
  if (type.ends_with('?')) return or_null(schema_of_type(type.substr(0, type.size() - 1)));
  if (type == "any") return json::object();
  if (type.starts_with('$')) return schema_of(json_from_text(named_shape(type.substr(1))));
  return {{"type", type}};
}

json schema_of_object(const json& shape) {
  json schema = {{"type", "object"}};
  if (shape.contains("*")) {
    schema["additionalProperties"] = schema_of(shape["*"]);
    return schema;
  }
  schema["properties"] = json::object();
  schema["required"] = json::array();
  for (const auto& [name, member] : shape.items()) {
    const bool is_optional = name.ends_with('?');
    const std::string plain = is_optional ? name.substr(0, name.size() - 1) : name;
    schema["properties"][plain] = schema_of(member);
    if (!is_optional) schema["required"].push_back(plain);
  }
  return schema;
}

json schema_of(const json& shape) {
  if (shape.is_string()) return schema_of_type(shape.get<std::string>());
  if (shape.is_array()) return {{"type", "array"}, {"items", schema_of(shape[0])}};
  return schema_of_object(shape);
}

}  // namespace

json result_schema(const Method& method) {
  return schema_of(json_from_text(method.result));
}

}  // namespace stanok::protocol

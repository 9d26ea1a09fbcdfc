#include "protocol/result_shapes.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "protocol/json_rpc.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

// A shape is JSON with types in the place of values: "string", "integer", "number", "boolean",
// "any", with a question mark where null stands for none; "$name" for a shape of its own; a list of
// one shape for an array of it; an object with the member "*" for one with any names. A member
// whose name ends with "?" may be left out.
constexpr auto named_shapes = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"alarm", R"({"channel":"integer","cycle":"integer","code":"string","text":"string",
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
      "corner_radius":"number","wear_length":"number","wear_radius":"number","overhang":"number",
      "flute_length":"number","shank_diameter":"number","holder_diameter":"number",
      "holder_length":"number","orientation":"integer","angle_front":"number",
      "angle_back":"number","point_angle":"number","taper_angle":"number"})"},
    {"axis", R"({"position":"number","verified":"boolean","takes_part":"boolean",
      "enabled":"boolean","brake":"boolean"})"},
    {"spindle", R"({"id":"integer","direction":"string","commanded_rev_min":"number",
      "actual_rev_min":"number?"})"},
    {"channel", R"({"id":"integer","name":"string","words":["string"],"axis_names":["string"],
      "state":"string","program_status":"string","held_by":"string?","controlled_by":"string?",
      "alarm":"$alarm?","program":"string?","run":"integer","line":"integer","block":"integer",
      "scheme":"integer","position":"$numbers","to_go":"$numbers?","axes":{"*":"$axis"},
      "feed_mm_s":"number","speed_mm_s":"number","feed_mm_min":"number","feed_mm_rev":"number",
      "speed_mm_min":"number","g_codes":["string"],"m_codes":["string"],
      "tool":{"number":"integer","edge":"integer","name":"string?"},"spindles":["$spindle"],
      "override":{"feed":"number","rapid":"number","spindle":"number"},"begins_at":"string?",
      "predicted_s":"number?","remaining_s":"number?","foreseen":"$alarm?"})"},
    {"drive", R"({"axis":"string","state":"string","in_contact":"boolean","fault_code":"integer",
      "position":"number","velocity":"number","following_error":"number","power_w":"number",
      "vibration_um":"number","vibration_hz":"number","temperature_c":"number",
      "referenced":"boolean","brake_closed":"boolean","home_switch":"boolean",
      "limit_negative":"boolean","limit_positive":"boolean","index_position":"number",
      "index_count":"integer","losses":"integer","answers":"integer","errors":"integer",
      "errors_by_kind":"$counts"})"},
});

constexpr auto result_shapes = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"machine.status", R"({"name":"string","cycle_us":"integer","cycle":"integer",
      "machine_time_s":"number","on":"boolean","idle":"boolean","drives":"string",
      "rt":{"cycle_us":"$percentiles","latency_us":"$percentiles","overruns":"integer",
            "periods_skipped":"integer"},
      "real_time":{"scheduling":"string","memory_locked":"boolean","notes":["string"]},
      "outputs_lost":"integer",
      "channels":[{"id":"integer","name":"string","state":"string","program_status":"string"}]})"},
    {"channel.list", R"({"channels":[{"id":"integer","name":"string","kind":"string",
      "axes":["string"],"words":["string"],"scheme":"integer","state":"string",
      "program_status":"string"}]})"},
    {"channel.status", R"("$channel")"},
    {"channel.control", R"({"channel":"integer","controlled_by":"string?"})"},
    {"channel.watch", R"({"topics":["string"],"rate_hz":"number"})"},
    {"subscribe", R"({"topics":["string"],"rate_hz":"number"})"},
    {"program.run", R"("$end of run")"},
    {"program.start", R"("$end of run")"},
    {"mdi", R"("$end of run")"},
    {"program.list", R"({"root":"string","programs":[{"name":"string","bytes":"integer"}],
      "complete":"boolean"})"},
    {"program.history", R"({"runs":[{"channel":"integer","program":"string","blocks":"integer",
      "time_s":"number","path_mm":"number","ended":"boolean","ok":"boolean"}]})"},
    {"program.search", R"({"target":"string","calculated":"boolean"})"},
    {"kinematics.list", R"({"channel":"integer","schemes":[{"id":"integer","type":"string",
      "file":"string?","axes":["string"],"active":"boolean"}]})"},
    {"kinematics.status", R"({"channel":"integer","scheme":"integer","type":"string?",
      "axes":[{"name":"string","takes_part":"boolean","enabled":"boolean","brake":"boolean"}]})"},
    {"drive.list", R"({"bus":"string","poll_ms":"number","timeout_ms":"number",
      "drives":[{"axis":"string","unit":"integer","kind":"string","requests":"integer",
                 "watchdog_ms":"integer?","absolute_encoder":"boolean","position_scale":"number",
                 "velocity_scale":"number"}]})"},
    {"drive.status", R"({"choice":"string","endpoint":"string?","connected":"boolean",
      "connections":"integer","exchanges":"integer","errors":"$counts",
      "round_trip_us":"$percentiles",
      "vibration":[{"sensor":"string","amplitude_um":"number","frequency_hz":"number",
                    "samples":"integer","lost":"integer","errors":"integer"}],
      "axes":["$drive"]})"},
    {"alarm.list", R"({"alarms":["$alarm"]})"},
    {"alarm.history", R"({"alarms":["$alarm"]})"},
    {"tool.list", R"({"tools":["$tool"]})"},
    {"tool.get", R"("$tool")"},
    {"tool.load", R"({"values":"integer"})"},
    {"tool.save", R"({"tables":"string"})"},
    {"offset.list", R"({"axes":["string"],"offsets":{"*":"$numbers"}})"},
    {"process.status", R"({"channel":"integer","law":"string?","increments":"integer",
      "stands":"boolean","interruption":"any","automatic":["any"],"adaptive":"any",
      "feed_mm_min":"number","feed_mm_rev":"number","spindle_rev_min":"number",
      "cutting_speed_m_min":"number"})"},
    {"workpiece.allow", R"({"allowed":"boolean"})"},
    {"workpiece.status", R"({"allowed":"boolean","workpieces":[{"channel":"integer",
      "tool":"integer"}]})"},
    {"log.status", R"({"lcm":{"url":"string?","open":"boolean","sent":"integer","lost":"integer"},
      "file":{"path":"string?","bytes":"integer","events":"integer","error":"string?"},
      "flight":"string?","outputs_lost":"integer"})"},
    {"log.start", R"({"path":"string"})"},
    {"log.stop", R"({"path":"string"})"},
    {"system.info", R"({"server":"string","version":"string","api":"integer","build":"string",
      "pid":"integer","uptime_s":"number"})"},
    {"session.role", R"({"role":"string"})"},
    {"rpc.discover", R"({"openrpc":"string","info":{"title":"string","version":"string"},
      "methods":["any"]})"},
});

template <class Rows>
std::string_view shape_of(const Rows& rows, std::string_view name, std::string_view otherwise) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.first == name; });
  return row == rows.end() ? otherwise : row->second;
}

json schema_of(const json& shape);

json or_null(json schema) {
  return {{"anyOf", {std::move(schema), {{"type", "null"}}}}};
}

json schema_of_type(std::string type) {
  if (type.ends_with('?')) return or_null(schema_of_type(type.substr(0, type.size() - 1)));
  if (type == "any") return json::object();
  if (type.starts_with('$'))
    return schema_of(json_from_text(shape_of(named_shapes, type.substr(1), "\"any\"")));
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

json result_schema(std::string_view method) {
  constexpr std::string_view only_accepted = R"({"accepted":"boolean"})";
  return schema_of(json_from_text(shape_of(result_shapes, method, only_accepted)));
}

}  // namespace stanok::protocol

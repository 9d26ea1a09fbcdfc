#include "jobs/interpret/record_fields.h"

#include "base/enum_names.h"
#include "base/place.h"
#include "jobs/interpret/axis_fields.h"
#include "jobs/interpret/feed_law_fields.h"

namespace stanok::jobs {
namespace {

constexpr auto feed_mode_names = enum_names<lang::FeedMode>({
    {lang::FeedMode::per_minute, "per_minute"},
    {lang::FeedMode::per_revolution, "per_revolution"},
    {lang::FeedMode::inverse_time, "inverse_time"},
});

constexpr auto plane_names = enum_names<lang::Plane>({
    {lang::Plane::xy, "XY"},
    {lang::Plane::zx, "ZX"},
    {lang::Plane::yz, "YZ"},
});

constexpr auto request_names = enum_names<lang::RequestKind>({
    {lang::RequestKind::sync, "sync"},
    {lang::RequestKind::kinematics, "kinematics"},
    {lang::RequestKind::channel_load, "channel_load"},
    {lang::RequestKind::channel_start, "channel_start"},
    {lang::RequestKind::channel_run, "channel_run"},
    {lang::RequestKind::channel_wait, "channel_wait"},
    {lang::RequestKind::channel_stop, "channel_stop"},
    {lang::RequestKind::channel_reset, "channel_reset"},
    {lang::RequestKind::channel_state, "channel_state"},
    {lang::RequestKind::spindle_to_axis, "spindle_to_axis"},
    {lang::RequestKind::tap_out, "tap_out"},
    {lang::RequestKind::axis_to_spindle, "axis_to_spindle"},
    {lang::RequestKind::terminate, "terminate"},
    {lang::RequestKind::tool_table_write, "tool_table_write"},
    {lang::RequestKind::offset_table_write, "offset_table_write"},
    {lang::RequestKind::tool_table_read, "tool_table_read"},
    {lang::RequestKind::offset_table_read, "offset_table_read"},
    {lang::RequestKind::machine_value, "machine_value"},
    {lang::RequestKind::probe_result, "probe_result"},
    {lang::RequestKind::input_wait, "input_wait"},
    {lang::RequestKind::mark_wait, "mark_wait"},
    {lang::RequestKind::mark_state, "mark_state"},
    {lang::RequestKind::shared_read, "shared_read"},
    {lang::RequestKind::shared_write, "shared_write"},
    {lang::RequestKind::shared_combine, "shared_combine"},
    {lang::RequestKind::program_restart, "program_restart"},
});

constexpr auto orient_way_names = enum_names<lang::OrientWay>({
    {lang::OrientWay::shortest, "shortest"},
    {lang::OrientWay::clockwise, "clockwise"},
    {lang::OrientWay::counter_clockwise, "counter_clockwise"},
});

constexpr auto transformation_names = enum_names<lang::Transformation>({
    {lang::Transformation::off, "off"},
    {lang::Transformation::polar_face, "polar_face"},
    {lang::Transformation::cylinder, "cylinder"},
});

constexpr auto mark_names = enum_names<lang::MarkCommand::Kind>({
    {lang::MarkCommand::Kind::set, "mark_set"},
    {lang::MarkCommand::Kind::clear, "mark_clear"},
    {lang::MarkCommand::Kind::wait_soft, "mark_wait_soft"},
});

constexpr auto force_names = enum_names<lang::ForceControl::Kind>({
    {lang::ForceControl::Kind::off, "off"},
    {lang::ForceControl::Kind::force, "force"},
    {lang::ForceControl::Kind::oscillate, "oscillate"},
    {lang::ForceControl::Kind::vibration_on, "vibration_on"},
    {lang::ForceControl::Kind::vibration_off, "vibration_off"},
    {lang::ForceControl::Kind::depth, "depth"},
});

constexpr auto length_mode_names = enum_names<lang::LengthMode>({
    {lang::LengthMode::off, "off"},
    {lang::LengthMode::length, "length"},
    {lang::LengthMode::tip, "tip"},
});

// One overload per payload: adds the fields behind "line".
struct RecordFields {
  Fields& fields;
  const motion::PathBlock* block;
  const Words& words;

  void add(const char* name, FieldValue value) const { fields.push_back({name, std::move(value)}); }
  void count(const char* name, std::integral auto number) const { add(name, count_field(number)); }
  void kind(const char* name) const { add("kind", name); }
  void name(const char* what, std::string_view value) const { add(what, text_field(value)); }
  void add_end() const { add("end", axis_fields(words, block->end)); }

  void operator()(const lang::Move& move) const {
    const bool arc = move.kind == lang::MoveKind::arc;
    const bool rapid = move.kind == lang::MoveKind::rapid;
    kind(arc ? "arc" : rapid ? "rapid" : "feed");
    add_end();
    if (arc) add_arc(move);
    if (rapid) return;
    add("feed", move.feed);
    name("feed_mode", feed_mode_names[move.feed_mode]);
  }

  void add_arc(const lang::Move& move) const {
    const auto word = [&](std::size_t side) { return words[checked_size(block->plane[side])]; };
    add("centre", Fields{{word(0), move.centre[0]}, {word(1), move.centre[1]}});
    name("plane", plane_names[move.plane]);
    count("turns", move.turns);
    add("ccw", move.counter_clockwise);
  }

  void operator()(const lang::SplineMove& spline) const {
    kind("spline");
    add_end();
    add("feed", spline.base.feed);
    name("feed_mode", feed_mode_names[spline.base.feed_mode]);
    name("plane", plane_names[spline.base.plane]);
    count("degree", spline.degree);
    add("points",
        field_list(spline.points, [](const auto& point) { return FieldList{point[0], point[1]}; }));
    add("weights", number_list(spline.weights));
  }
  void operator()(const lang::SynchronousMove& move) const {
    const bool is_tap = move.kind == lang::SynchronousMove::Kind::rigid_tap;
    kind(move.kind == lang::SynchronousMove::Kind::thread ? "thread" : "rigid_tap");
    add_end();
    count("spindle", move.spindle);
    add("lead", move.lead_mm_per_rev);
    add("start_angle", move.start_angle_deg);
    if (!is_tap) return;
    add("dwell", move.dwell_s);
    add("return_speed", move.return_speed_factor);
  }
  void operator()(const lang::ProbeMove& probe) const {
    kind("probe");
    add_end();
    add("feed", probe.line.feed);
    add("until_contact", probe.until_contact);
    add("alarm_when_missed", probe.alarm_when_missed);
  }
  void operator()(const lang::FeedLawChange& change) const {
    kind("feed_law");
    add("of_next_block", change.of_next_block);
    add("feed_law", feed_law_fields(change.law));
  }
  void operator()(const lang::TransformationChange& change) const {
    kind("offset");
    add("what", "transformation");
    name("mode", transformation_names[change.kind]);
    add("radius", change.radius_mm);
  }
  void operator()(const lang::Dwell& dwell) const {
    kind("dwell");
    add("seconds", dwell.seconds);
  }
  void operator()(const lang::SpindleCommand& spindle) const {
    kind("spindle");
    count("spindle", spindle.spindle);
    name("action", spindle_action_names[spindle.action]);
    if (spindle.cutting_speed_m_per_min > 0.0) {
      add("cutting_speed", spindle.cutting_speed_m_per_min);
    } else {
      add("speed", spindle.speed_rev_per_min);
    }
    if (spindle.action != lang::SpindleAction::orient) return;
    add("angle", spindle.angle_deg);
    name("way", orient_way_names[spindle.way]);
    if (spindle.timeout_s >= 0.0) add("timeout", spindle.timeout_s);
  }
  void operator()(const lang::CuttingSpeedMode& mode) const {
    kind("spindle");
    count("spindle", mode.spindle);
    name("action", mode.constant ? "cutting_speed" : "constant_speed");
    add("speed", mode.speed_m_per_min);
    add("limit", mode.limit_rev_per_min);
  }
  void operator()(const lang::CoolantCommand& coolant) const {
    kind("coolant");
    add("mist", coolant.mist);
    add("flood", coolant.flood);
  }
  void operator()(const lang::ToolPrepare& tool) const {
    kind("tool");
    add("action", "prepare");
    count("tool", tool.tool);
  }
  void operator()(const lang::ToolChange& tool) const {
    kind("tool");
    add("action", tool.by_number_only ? "set" : "change");
    count("tool", tool.tool);
  }
  void operator()(const lang::ToolLength& length) const {
    kind("offset");
    add("what", "tool_length");
    name("mode", length_mode_names[length.mode]);
    count("tool", length.tool);
    add("offset", number_list(length.offset_mm));
  }
  void operator()(const lang::FrameChange& frame) const {
    kind("offset");
    add("what", "frame");
    count("work_offset", frame.work_offset);
    add("rotation",
        field_list(frame.rotation.rows(), [](const auto& row) { return number_list(row); }));
    add("offset", axis_fields(words, frame.offset));
  }
  void operator()(const lang::OverrideControl& control) const {
    kind("sync");
    add("what", "override");
    add("feed", control.feed_enabled);
    add("spindle", control.spindle_enabled);
  }
  void operator()(const lang::ForceControl& force) const {
    kind("force_control");
    name("order", force_names[force.kind]);
    add("force", force.force_n);
    add("feed_min", force.feed_min);
    add("feed_max", force.feed_max);
    add("per_revolution", force.per_revolution);
    add("oscillation", force.oscillation_n);
    add("frequency", force.oscillation_hz);
    add("level", force.level_um);
    add("mass", force.reduced_mass_kg);
    add("depth", force.depth_mm);
  }
  void operator()(const lang::OutputCommand& output) const {
    kind("output");
    add("analog", output.analog);
    add("with_motion", output.with_motion);
    count("number", output.number);
    add("value", output.value);
  }
  void operator()(const lang::MachineFunction& function) const {
    kind("sync");
    add("what", "machine_function");
    count("code", function.code);
    add("p", function.p);
    add("q", function.q);
  }
  void operator()(const lang::MarkCommand& mark) const {
    kind("channel");
    name("what", mark_names[mark.kind]);
    count("number", mark.id);
    count("channels", mark.channels);
  }
  void operator()(const lang::WorkpieceAnnouncement& announcement) const {
    const lang::WorkpieceShape& workpiece = announcement.shape;
    kind("sync");
    add("what", "workpiece");
    count("type", workpiece.type);
    count("machining_type", workpiece.machining_type);
    add("size", number_list(workpiece.size_mm));
    add("zero", number_list(workpiece.zero_mm));
    add("cell", workpiece.screen_resolution_mm);
    if (announcement.file.empty()) return;
    name("file", announcement.file);
    add("scale", workpiece.scale);
  }
  void operator()(const lang::WorkpiecePosition& position) const {
    kind("sync");
    add("what", "workpiece_position");
    add("position", number_list(position.position_mm));
    add("angles", number_list(position.angles_deg));
  }
  void operator()(const lang::Message& message) const {
    kind("message");
    name("text", message.text);
  }
  void operator()(const lang::ModalReport& report) const {
    kind("sync");
    add("what", "modal");
    name("text", report.text);
  }
  void operator()(const lang::ProgramStop& stop) const {
    kind("sync");
    add("what", "program_stop");
    count("code", static_cast<int>(stop.kind));
  }
  void operator()(const lang::ProgramEnd& ending) const {
    kind("end");
    count("code", static_cast<int>(ending.kind));
  }
  void operator()(const lang::ProgramRequest& request) const {
    const bool dispatch = request.kind != lang::RequestKind::sync;
    kind(dispatch ? "channel" : "sync");
    name("what", request_names[request.kind]);
    if (!dispatch) return;
    count("channel", request.channel);
    count("number", request.number);
    name("text", request.text);
  }
};

}  // namespace

Fields record_fields(const lang::Command& command, const motion::PathBlock* block,
                     const Words& words) {
  Fields fields{{"line", count_field(command.origin.line)}};
  std::visit(RecordFields{fields, block, words}, command.payload);
  return fields;
}

}  // namespace stanok::jobs

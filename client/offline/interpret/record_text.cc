#include "client/offline/interpret/record_text.h"

#include "base/enum_names.h"
#include "base/place.h"
#include "client/offline/interpret/feed_law_text.h"
#include "client/offline/interpret/record_parts.h"

namespace stanok::client {
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
});

constexpr auto length_mode_names = enum_names<lang::LengthMode>({
    {lang::LengthMode::off, "off"},
    {lang::LengthMode::length, "length"},
    {lang::LengthMode::tip, "tip"},
});

// One overload per payload: appends the fields after "line".
struct Fields {
  std::string& text;
  const motion::PathBlock* block;
  const Words& words;

  void kind(const char* name) const { append(text, R"(,"kind":"{}")", name); }

  void operator()(const lang::Move& move) const {
    const bool arc = move.kind == lang::MoveKind::arc;
    const bool rapid = move.kind == lang::MoveKind::rapid;
    kind(arc ? "arc" : rapid ? "rapid" : "feed");
    text += R"(,"end":)";
    append_axes(text, words, block->end);
    if (arc) arc_fields(move);
    if (!rapid)
      append(text, R"(,"feed":{},"feed_mode":"{}")", move.feed, feed_mode_names[move.feed_mode]);
  }

  void arc_fields(const lang::Move& move) const {
    const auto word = [&](std::size_t side) { return words[checked_size(block->plane[side])]; };
    append(text, R"(,"centre":{{"{}":{},"{}":{}}})", word(0), move.centre[0], word(1),
           move.centre[1]);
    append(text, R"(,"plane":"{}","turns":{},"ccw":{})", plane_names[move.plane], move.turns,
           move.counter_clockwise);
  }

  void end_fields() const {
    text += R"(,"end":)";
    append_axes(text, words, block->end);
  }

  void operator()(const lang::SplineMove& spline) const {
    kind("spline");
    end_fields();
    append(text, R"(,"feed":{},"feed_mode":"{}","plane":"{}","degree":{},"points":[)",
           spline.base.feed, feed_mode_names[spline.base.feed_mode], plane_names[spline.base.plane],
           spline.degree);
    for (std::size_t k = 0; k < spline.points.size(); ++k) {
      append(text, "{}[{},{}]", k == 0 ? "" : ",", spline.points[k][0], spline.points[k][1]);
    }
    append(text, R"(],"weights":[{}])", fmt::join(spline.weights, ","));
  }
  void operator()(const lang::SynchronousMove& move) const {
    kind(move.kind == lang::SynchronousMove::Kind::thread ? "thread" : "rigid_tap");
    end_fields();
    append(text, R"(,"spindle":{},"lead":{},"start_angle":{})", move.spindle, move.lead_mm_per_rev,
           move.start_angle_deg);
    if (move.kind == lang::SynchronousMove::Kind::rigid_tap) {
      append(text, R"(,"dwell":{},"return_speed":{})", move.dwell_s, move.return_speed_factor);
    }
  }
  void operator()(const lang::ProbeMove& probe) const {
    kind("probe");
    end_fields();
    append(text, R"(,"feed":{},"until_contact":{},"alarm_when_missed":{})", probe.line.feed,
           probe.until_contact, probe.alarm_when_missed);
  }
  void operator()(const lang::FeedLawChange& change) const {
    kind("feed_law");
    append(text, R"(,"of_next_block":{},"feed_law":)", change.of_next_block);
    append_feed_law(text, change.law);
  }
  void operator()(const lang::TransformationChange& change) const {
    kind("offset");
    append(text, R"(,"what":"transformation","mode":"{}","radius":{})",
           transformation_names[change.kind], change.radius_mm);
  }
  void operator()(const lang::Dwell& dwell) const {
    kind("dwell");
    append(text, R"(,"seconds":{})", dwell.seconds);
  }
  void operator()(const lang::SpindleCommand& spindle) const {
    kind("spindle");
    append(text, R"(,"spindle":{},"action":"{}")", spindle.spindle,
           spindle_action_names[spindle.action]);
    if (spindle.cutting_speed_m_per_min > 0.0) {
      append(text, R"(,"cutting_speed":{})", spindle.cutting_speed_m_per_min);
    } else {
      append(text, R"(,"speed":{})", spindle.speed_rev_per_min);
    }
    if (spindle.action != lang::SpindleAction::orient) return;
    append(text, R"(,"angle":{},"way":"{}")", spindle.angle_deg, orient_way_names[spindle.way]);
    if (spindle.timeout_s >= 0.0) append(text, R"(,"timeout":{})", spindle.timeout_s);
  }
  void operator()(const lang::CuttingSpeedMode& mode) const {
    kind("spindle");
    append(text, R"(,"spindle":{},"action":"{}","speed":{},"limit":{})", mode.spindle,
           mode.constant ? "cutting_speed" : "constant_speed", mode.speed_m_per_min,
           mode.limit_rev_per_min);
  }
  void operator()(const lang::CoolantCommand& coolant) const {
    kind("coolant");
    append(text, R"(,"mist":{},"flood":{})", coolant.mist, coolant.flood);
  }
  void operator()(const lang::ToolPrepare& tool) const {
    kind("tool");
    append(text, R"(,"action":"prepare","tool":{})", tool.tool);
  }
  void operator()(const lang::ToolChange& tool) const {
    kind("tool");
    append(text, R"(,"action":"{}","tool":{})", tool.by_number_only ? "set" : "change", tool.tool);
  }
  void operator()(const lang::ToolLength& length) const {
    kind("offset");
    append(text, R"(,"what":"tool_length","mode":"{}","tool":{},"offset":[{},{},{}])",
           length_mode_names[length.mode], length.tool, length.offset_mm[0], length.offset_mm[1],
           length.offset_mm[2]);
  }
  void operator()(const lang::FrameChange& frame) const {
    kind("offset");
    const auto& rows = frame.rotation.rows();
    append(text, R"(,"what":"frame","work_offset":{},"rotation":[[{}],[{}],[{}]],"offset":)",
           frame.work_offset, fmt::join(rows[0], ","), fmt::join(rows[1], ","),
           fmt::join(rows[2], ","));
    append_axes(text, words, frame.offset);
  }
  void operator()(const lang::OverrideControl& control) const {
    kind("sync");
    append(text, R"(,"what":"override","feed":{},"spindle":{})", control.feed_enabled,
           control.spindle_enabled);
  }
  void operator()(const lang::ForceControl& force) const {
    kind("force_control");
    append(text,
           R"(,"order":"{}","force":{},"feed_min":{},"feed_max":{},"per_revolution":{})"
           R"(,"oscillation":{},"frequency":{},"level":{},"mass":{})",
           force_names[force.kind], force.force_n, force.feed_min, force.feed_max,
           force.per_revolution, force.oscillation_n, force.oscillation_hz, force.level_um,
           force.reduced_mass_kg);
  }
  void operator()(const lang::OutputCommand& output) const {
    kind("output");
    append(text, R"(,"analog":{},"with_motion":{},"number":{},"value":{})", output.analog,
           output.with_motion, output.number, output.value);
  }
  void operator()(const lang::MachineFunction& function) const {
    kind("sync");
    append(text, R"(,"what":"machine_function","code":{},"p":{},"q":{})", function.code, function.p,
           function.q);
  }
  void operator()(const lang::MarkCommand& mark) const {
    kind("channel");
    append(text, R"(,"what":"{}","number":{},"channels":{})", mark_names[mark.kind], mark.id,
           mark.channels);
  }
  void operator()(const lang::WorkpieceAnnouncement& announcement) const {
    const lang::WorkpieceShape& workpiece = announcement.shape;
    kind("sync");
    append(text,
           R"(,"what":"workpiece","type":{},"machining_type":{},"size":[{}],"zero":[{}],"cell":{})",
           workpiece.type, workpiece.machining_type, fmt::join(workpiece.size_mm, ","),
           fmt::join(workpiece.zero_mm, ","), workpiece.screen_resolution_mm);
    if (announcement.file.empty()) return;
    text += R"(,"file":)";
    append_string(text, announcement.file);
    append(text, R"(,"scale":{})", workpiece.scale);
  }
  void operator()(const lang::WorkpiecePosition& position) const {
    kind("sync");
    append(text, R"(,"what":"workpiece_position","position":[{}],"angles":[{}])",
           fmt::join(position.position_mm, ","), fmt::join(position.angles_deg, ","));
  }
  void operator()(const lang::Message& message) const {
    kind("message");
    text += R"(,"text":)";
    append_string(text, message.text);
  }
  void operator()(const lang::ModalReport& report) const {
    kind("sync");
    text += R"(,"what":"modal","text":)";
    append_string(text, report.text);
  }
  void operator()(const lang::ProgramStop& stop) const {
    kind("sync");
    append(text, R"(,"what":"program_stop","code":{})", static_cast<int>(stop.kind));
  }
  void operator()(const lang::ProgramEnd& end) const {
    kind("end");
    append(text, R"(,"code":{})", static_cast<int>(end.kind));
  }
  void operator()(const lang::Request& request) const {
    const bool dispatch = request.kind != lang::RequestKind::sync;
    kind(dispatch ? "channel" : "sync");
    append(text, R"(,"what":"{}")", request_names[request.kind]);
    if (!dispatch) return;
    append(text, R"(,"channel":{},"number":{},"text":)", request.channel, request.number);
    append_string(text, request.text);
  }
};

}  // namespace

void append_record(std::string& text, const lang::Command& command, const motion::PathBlock* block,
                   const Words& words) {
  append(text, R"({{"line":{})", command.origin.line);
  std::visit(Fields{text, block, words}, command.payload);
  text += "}\n";
}

}  // namespace stanok::client

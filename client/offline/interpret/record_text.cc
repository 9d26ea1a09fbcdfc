#include "client/offline/interpret/record_text.h"

#include "client/offline/interpret/feed_law_text.h"
#include "client/offline/interpret/record_parts.h"

namespace stanok::client {
namespace {

const char* name_of(lang::FeedMode mode) {
  switch (mode) {
    case lang::FeedMode::per_minute:
      return "per_minute";
    case lang::FeedMode::per_revolution:
      return "per_revolution";
    case lang::FeedMode::inverse_time:
      return "inverse_time";
  }
  return "";
}

const char* name_of(lang::Plane plane) {
  switch (plane) {
    case lang::Plane::xy:
      return "XY";
    case lang::Plane::zx:
      return "ZX";
    case lang::Plane::yz:
      return "YZ";
  }
  return "";
}

const char* name_of(lang::RequestKind kind) {
  using lang::RequestKind;
  switch (kind) {
    case RequestKind::sync:
      return "sync";
    case RequestKind::kinematics:
      return "kinematics";
    case RequestKind::channel_load:
      return "channel_load";
    case RequestKind::channel_start:
      return "channel_start";
    case RequestKind::channel_run:
      return "channel_run";
    case RequestKind::channel_wait:
      return "channel_wait";
    case RequestKind::channel_stop:
      return "channel_stop";
    case RequestKind::channel_reset:
      return "channel_reset";
    case RequestKind::channel_state:
      return "channel_state";
    case RequestKind::spindle_to_axis:
      return "spindle_to_axis";
    case RequestKind::axis_to_spindle:
      return "axis_to_spindle";
    case RequestKind::terminate:
      return "terminate";
    case RequestKind::tool_table_write:
      return "tool_table_write";
    case RequestKind::offset_table_write:
      return "offset_table_write";
    case RequestKind::tool_table_read:
      return "tool_table_read";
    case RequestKind::offset_table_read:
      return "offset_table_read";
    case RequestKind::machine_value:
      return "machine_value";
    case RequestKind::probe_result:
      return "probe_result";
    case RequestKind::input_wait:
      return "input_wait";
    case RequestKind::mark_wait:
      return "mark_wait";
    case RequestKind::mark_state:
      return "mark_state";
    case RequestKind::shared_read:
      return "shared_read";
    case RequestKind::shared_write:
      return "shared_write";
    case RequestKind::shared_combine:
      return "shared_combine";
    case RequestKind::program_restart:
      return "program_restart";
  }
  return "";
}

const char* name_of(lang::OrientWay way) {
  switch (way) {
    case lang::OrientWay::shortest:
      return "shortest";
    case lang::OrientWay::clockwise:
      return "clockwise";
    case lang::OrientWay::counter_clockwise:
      return "counter_clockwise";
  }
  return "";
}

const char* name_of(lang::Transformation transformation) {
  switch (transformation) {
    case lang::Transformation::off:
      return "off";
    case lang::Transformation::polar_face:
      return "polar_face";
    case lang::Transformation::cylinder:
      return "cylinder";
  }
  return "";
}

const char* name_of(lang::MarkCommand::Kind kind) {
  switch (kind) {
    case lang::MarkCommand::Kind::set:
      return "mark_set";
    case lang::MarkCommand::Kind::clear:
      return "mark_clear";
    case lang::MarkCommand::Kind::wait_soft:
      return "mark_wait_soft";
  }
  return "";
}

const char* name_of(lang::ForceControl::Kind kind) {
  switch (kind) {
    case lang::ForceControl::Kind::off:
      return "off";
    case lang::ForceControl::Kind::force:
      return "force";
    case lang::ForceControl::Kind::oscillate:
      return "oscillate";
    case lang::ForceControl::Kind::vibration_on:
      return "vibration_on";
    case lang::ForceControl::Kind::vibration_off:
      return "vibration_off";
  }
  return "";
}

const char* name_of(lang::LengthMode mode) {
  switch (mode) {
    case lang::LengthMode::off:
      return "off";
    case lang::LengthMode::length:
      return "length";
    case lang::LengthMode::tip:
      return "tip";
  }
  return "";
}

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
    if (!rapid) append(text, R"(,"feed":{},"feed_mode":"{}")", move.feed, name_of(move.feed_mode));
  }

  void arc_fields(const lang::Move& move) const {
    const auto word = [&](int side) {
      return words[static_cast<std::size_t>(block->plane[static_cast<std::size_t>(side)])];
    };
    append(text, R"(,"centre":{{"{}":{},"{}":{}}})", word(0), move.centre[0], word(1),
           move.centre[1]);
    append(text, R"(,"plane":"{}","turns":{},"ccw":{})", name_of(move.plane), move.turns,
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
           spline.base.feed, name_of(spline.base.feed_mode), name_of(spline.base.plane),
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
    append(text, R"(,"what":"transformation","mode":"{}","radius":{})", name_of(change.kind),
           change.radius_mm);
  }
  void operator()(const lang::Dwell& dwell) const {
    kind("dwell");
    append(text, R"(,"seconds":{})", dwell.seconds);
  }
  void operator()(const lang::SpindleCommand& spindle) const {
    kind("spindle");
    append(text, R"(,"spindle":{},"action":"{}")", spindle.spindle, action_name(spindle.action));
    if (spindle.cutting_speed_m_per_min > 0.0) {
      append(text, R"(,"cutting_speed":{})", spindle.cutting_speed_m_per_min);
    } else {
      append(text, R"(,"speed":{})", spindle.speed_rev_per_min);
    }
    if (spindle.action != lang::SpindleAction::orient) return;
    append(text, R"(,"angle":{},"way":"{}")", spindle.angle_deg, name_of(spindle.way));
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
           name_of(length.mode), length.tool, length.offset_mm[0], length.offset_mm[1],
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
           name_of(force.kind), force.force_n, force.feed_min, force.feed_max, force.per_revolution,
           force.oscillation_n, force.oscillation_hz, force.level_um, force.reduced_mass_kg);
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
    append(text, R"(,"what":"{}","number":{},"channels":{})", name_of(mark.kind), mark.id,
           mark.channels);
  }
  void operator()(const lang::WorkpieceAnnouncement& workpiece) const {
    kind("sync");
    append(text,
           R"(,"what":"workpiece","type":{},"machining_type":{},"size":[{}],"zero":[{}],"cell":{})",
           workpiece.type, workpiece.machining_type, fmt::join(workpiece.size_mm, ","),
           fmt::join(workpiece.zero_mm, ","), workpiece.screen_resolution_mm);
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
    append(text, R"(,"what":"{}")", name_of(request.kind));
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

#include "client/record_text.h"

#include <fmt/format.h>

#include <iterator>

namespace stanok::client {
namespace {

using Words = std::vector<std::string>;

template <class... Arguments>
void append(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

// A JSON string: quotes, backslashes and control characters escaped.
void append_string(std::string& text, std::string_view value) {
  text += '"';
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      append(text, "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  text += '"';
}

void append_axes(std::string& text, const Words& words, const motion::Point& point) {
  text += '{';
  for (std::size_t k = 0; k < words.size(); ++k) {
    append(text, R"({}"{}":{})", k == 0 ? "" : ",", words[k], point[k]);
  }
  text += '}';
}

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
    case RequestKind::machine_value:
      return "machine_value";
  }
  return "";
}

const char* name_of(lang::SpindleAction action) {
  switch (action) {
    case lang::SpindleAction::set_speed:
      return "speed";
    case lang::SpindleAction::clockwise:
      return "clockwise";
    case lang::SpindleAction::counter_clockwise:
      return "counter_clockwise";
    case lang::SpindleAction::stop:
      return "stop";
    case lang::SpindleAction::orient:
      return "orient";
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

  void operator()(const lang::Dwell& dwell) const {
    kind("dwell");
    append(text, R"(,"seconds":{})", dwell.seconds);
  }
  void operator()(const lang::SpindleCommand& spindle) const {
    kind("spindle");
    append(text, R"(,"spindle":{},"action":"{}","speed":{})", spindle.spindle,
           name_of(spindle.action), spindle.speed_rev_per_min);
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
    append(text, R"(,"action":"change","tool":{})", tool.tool);
  }
  void operator()(const lang::ToolLength& length) const {
    kind("offset");
    append(text, R"(,"what":"tool_length","mode":"{}","tool":{},"offset":[{},{},{}])",
           name_of(length.mode), length.tool, length.offset_mm[0], length.offset_mm[1],
           length.offset_mm[2]);
  }
  void operator()(const lang::FrameChange& frame) const {
    kind("offset");
    append(text, R"(,"what":"frame","work_offset":{},"rotation":{},"offset":)", frame.work_offset,
           frame.rotation_deg);
    append_axes(text, words, frame.offset);
  }
  void operator()(const lang::OverrideControl& control) const {
    kind("sync");
    append(text, R"(,"what":"override","feed":{},"spindle":{})", control.feed_enabled,
           control.spindle_enabled);
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

// The programs of programs/conformance, one test each: what they say about themselves must be true.
//
//   ; expect: line X10 Y2 F100       the commands of the run, in order, all of them
//   ; expect error 3:7 E4031         the errors of the load or the error of the run
//   ; expect warning W211            the warnings of the load, in order
//   ; channel lathe                  mill (X Y Z B C; C modulo 360), lathe (X Z C) or master
//
// The machine: tools 1 to 9 of length 10 x number and radius 1, G55 at X100 Y200 Z300, all else 0.
// Requests are answered with success and the number 2.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lang/source.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(STANOK_SOURCE_DIR) / "programs" / "conformance";

std::vector<std::string> program_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".nc") continue;
    const std::string name = std::filesystem::relative(entry.path(), folder).generic_string();
    if (name.find("included/") == std::string::npos) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string number_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", std::abs(number) < 1e-12 ? 0.0 : number);
  return text;
}

// Names commands in the words of programs.
class Describer {
 public:
  explicit Describer(const ChannelDescription& channel) : channel_(channel) {}

  std::string operator()(const Move& move) const {
    std::string text = move.kind == MoveKind::rapid  ? "rapid"
                       : move.kind == MoveKind::line ? "line"
                                                     : arc_text(move);
    text += axes_text(move.end, move.words);
    if (move.kind != MoveKind::rapid) text += " F" + number_text(move.feed);
    if (move.feed_mode == FeedMode::per_revolution) text += " per revolution";
    if (move.feed_mode == FeedMode::inverse_time) text += " inverse time";
    if (move.machine_coordinates) text += " machine";
    if (move.stop_at_end) text += " stop";
    if (move.path.mode == PathMode::exact_path) text += " exact path";
    if (move.path.mode == PathMode::exact_stop) text += " exact stop";
    if (move.path.tolerance_mm >= 0.0) text += " tolerance " + number_text(move.path.tolerance_mm);
    return text;
  }
  std::string operator()(const Dwell& dwell) const { return "dwell " + number_text(dwell.seconds); }
  std::string operator()(const SpindleCommand& spindle) const {
    static const char* const names[] = {"speed", "clockwise", "counter-clockwise", "stop",
                                        "orient"};
    std::string text = std::string("spindle ") + names[static_cast<int>(spindle.action)] + " " +
                       number_text(spindle.speed_rev_per_min);
    if (spindle.spindle != 0) text += " $" + std::to_string(spindle.spindle);
    if (spindle.action == SpindleAction::orient) text += " R" + number_text(spindle.angle_deg);
    return text;
  }
  std::string operator()(const CoolantCommand& coolant) const {
    return std::string("coolant") + (coolant.mist ? " mist" : "") +
           (coolant.flood ? " flood" : "") + (!coolant.mist && !coolant.flood ? " off" : "");
  }
  std::string operator()(const ToolPrepare& tool) const {
    return "prepare T" + std::to_string(tool.tool);
  }
  std::string operator()(const ToolChange& tool) const {
    return "change T" + std::to_string(tool.tool);
  }
  std::string operator()(const ToolLength& length) const {
    if (length.mode == LengthMode::off) return "length off";
    std::string text = length.mode == LengthMode::tip ? "tip H" : "length H";
    text += std::to_string(length.tool);
    for (const double part : length.offset_mm) text += " " + number_text(part);
    return text;
  }
  std::string operator()(const FrameChange& frame) const {
    return "frame " + std::to_string(frame.work_offset) + axes_text(frame.offset, 0xFF);
  }
  std::string operator()(const OverrideControl& control) const {
    return control.feed_enabled ? "overrides on" : "overrides off";
  }
  std::string operator()(const Message& message) const {
    static const char* const names[] = {"message", "warning", "log"};
    return std::string(names[static_cast<int>(message.kind)]) + " " + message.text;
  }
  std::string operator()(const ModalReport& report) const { return "modal " + report.text; }
  std::string operator()(const ProgramStop& stop) const {
    static const char* const names[] = {"program stop", "optional stop", "pallet stop"};
    return names[static_cast<int>(stop.kind)];
  }
  std::string operator()(const ProgramEnd& end) const {
    static const char* const names[] = {"end", "end and rewind", "end of text", "restart"};
    return names[static_cast<int>(end.kind)];
  }
  std::string operator()(const Request& request) const {
    static const char* const names[] = {"sync",
                                        "kinematics",
                                        "channel_load",
                                        "channel_start",
                                        "channel_run",
                                        "channel_wait",
                                        "channel_stop",
                                        "channel_reset",
                                        "channel_state",
                                        "spindle_to_axis",
                                        "axis_to_spindle",
                                        "terminate",
                                        "write tool",
                                        "write offset",
                                        "read"};
    std::string text = std::string("request ") + names[static_cast<int>(request.kind)];
    if (request.channel != 0) text += " channel " + std::to_string(request.channel);
    if (request.number != 0) text += " " + std::to_string(request.number);
    if (!request.text.empty()) text += " " + request.text;
    if (request.kind == RequestKind::offset_table_write) text += " " + number_text(request.value);
    if (request.seconds >= 0.0) text += " timeout " + number_text(request.seconds);
    return text;
  }

 private:
  static std::string arc_text(const Move& move) {
    static const char* const planes[] = {"xy", "zx", "yz"};
    std::string text = std::string("arc ") + (move.counter_clockwise ? "ccw " : "cw ") +
                       planes[static_cast<int>(move.plane)] + " centre " +
                       number_text(move.centre[0]) + "," + number_text(move.centre[1]);
    if (move.turns != 1) text += " turns " + std::to_string(move.turns);
    return text;
  }
  std::string axes_text(const AxisValues& values, AxisSet set) const {
    std::string text;
    for (std::size_t i = 0; i < channel_.axes.size(); ++i) {
      if ((set >> i & 1U) == 0) continue;
      text += " " + channel_.axes[i].word + number_text(values[i]);
    }
    return text;
  }

  const ChannelDescription& channel_;
};

struct Expectations {
  std::vector<std::string> commands;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  std::string channel = "mill";
};

Expectations expectations_of(std::string text) {
  std::replace(text.begin(), text.end(), '\r', '\n');
  Expectations all;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line)) {
    const auto rest = [&](std::string_view prefix) {
      return line.starts_with(prefix) ? std::optional(line.substr(prefix.size())) : std::nullopt;
    };
    if (const auto command = rest("; expect: ")) all.commands.push_back(*command);
    if (const auto error = rest("; expect error ")) all.errors.push_back(*error);
    if (const auto warning = rest("; expect warning ")) all.warnings.push_back(*warning);
    if (const auto channel = rest("; channel ")) all.channel = *channel;
  }
  return all;
}

std::string place_text(const Diagnostic& diagnostic) {
  return std::to_string(diagnostic.place.line) + ":" + std::to_string(diagnostic.place.column) +
         " " + diagnostic.code;
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

class Conformance : public ProgramTest, public ::testing::WithParamInterface<std::string> {
 protected:
  void prepare_machine(const std::string& kind) {
    if (kind == "master") channel = master_channel();
    if (kind == "lathe") {
      channel.kind = ChannelKind::lathe;
      channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}, {"C", true, 0.0, -1}};
    }
    for (int number = 1; number <= 9; ++number) {
      tables.tools[number] = {number, {0.0, 0.0, 10.0 * number}, 1.0};
    }
    tables.offsets[2] = {100.0, 200.0, 300.0};
    answering = [](const Request&) {
      Answer answer;
      answer.number = 2.0;
      return answer;
    };
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().parent_path().filename() != "included") continue;
      files.texts[entry.path().filename().string()] = file_text(entry.path());
    }
  }
};

TEST_P(Conformance, DoesWhatItSays) {
  const std::string text = file_text(folder / GetParam());
  const Expectations expected = expectations_of(text);
  prepare_machine(expected.channel);
  std::vector<std::string> errors;
  for (const Diagnostic& one : load_errors(text)) errors.push_back(place_text(one));
  std::vector<std::string> warning_codes;
  for (const Diagnostic& one : warnings) warning_codes.push_back(one.code);
  std::vector<std::string> described;
  if (errors.empty()) {
    for (const Command& command : run(text)) {
      described.push_back(std::visit(Describer(channel), command.payload));
    }
    if (!error.code.empty()) errors.push_back(place_text(error));
  }
  EXPECT_EQ(described, expected.commands);
  EXPECT_EQ(errors, expected.errors);
  EXPECT_EQ(warning_codes, expected.warnings);
}

INSTANTIATE_TEST_SUITE_P(
    Programs, Conformance, ::testing::ValuesIn(program_names()), [](const auto& one) {
      std::string name = one.param.substr(0, one.param.size() - 3);
      std::replace_if(name.begin(), name.end(), [](char c) { return !is_name_part(c); }, '_');
      return name;
    });

}  // namespace
}  // namespace stanok::lang::testing

// The programs of programs/conformance, one test each: what they say about themselves must be true.
//
//   ; expect: line X10 Y2 F100       the commands of the run, in order, all of them
//   ; expect error 3:7 E4031         the errors of the load or the error of the run
//   ; expect warning W211            the warnings of the load, in order
//   ; channel lathe                  mill (X Y Z B C; C modulo 360), grind (the same axes), lathe
//                                  (X Z C), master; two spindles: the mill with spindle 1, which
//                                  has a position, and 2; spindle axis: the mill whose spindle
//                                  becomes C; table A, table B: a mill (X Y Z) with
//                                  that axis; letters: E is dS, V is dl; plain corners: a lathe (X
//                                  Z) whose A, C and R need no comma
//
// The machine: tools 1 to 9 of length 10 x number and radius 1, G55 at X100 Y200 Z300, all else 0.
// The files of programs/cycles are found by their names there; box_40_30_10.stl is a box of that
// size over the origin.
// Requests are answered with success and the number 2; M99 in the main program begins it again
// once.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lang/contract/blank_file.h"
#include "lang/feed_law/law_types.h"
#include "lang/text/source.h"
#include "tests/lang/program_support.h"
#include "tests/support/project_folders.h"

namespace stanok::lang::testing {
namespace {

const std::filesystem::path conformance_folder =
    std::filesystem::path(stanok::testing::source_folder()) / "programs" / "conformance";

std::vector<std::string> program_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(conformance_folder)) {
    if (entry.path().extension() != ".nc") continue;
    const std::string name =
        std::filesystem::relative(entry.path(), conformance_folder).generic_string();
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
    if (spindle.cutting_speed_m_per_min != 0.0)
      text += " at cutting speed " + number_text(spindle.cutting_speed_m_per_min);
    if (spindle.spindle != 0) text += " $" + std::to_string(spindle.spindle);
    if (spindle.action != SpindleAction::orient) return text;
    static const char* const ways[] = {"", " clockwise", " counter-clockwise"};
    text += " R" + number_text(spindle.angle_deg) + ways[static_cast<int>(spindle.way)];
    if (spindle.timeout_s >= 0.0) text += " within " + number_text(spindle.timeout_s);
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
    return (tool.by_number_only ? "set T" : "change T") + std::to_string(tool.tool);
  }
  std::string operator()(const ToolLength& length) const {
    if (length.mode == LengthMode::off) return "length off";
    std::string text = length.mode == LengthMode::tip ? "tip H" : "length H";
    text += std::to_string(length.tool);
    for (const double part : length.offset_mm) text += " " + number_text(part);
    return text;
  }
  std::string operator()(const FrameChange& frame) const {
    std::string text = "frame " + std::to_string(frame.work_offset);
    text += axes_text(frame.offset, 0xFF);
    if (frame.rotation.is_identity()) return text;
    text += " turned";
    for (const auto& row : frame.rotation.rows()) {
      text +=
          " (" + number_text(row[0]) + " " + number_text(row[1]) + " " + number_text(row[2]) + ")";
    }
    return text;
  }
  std::string operator()(const OverrideControl& control) const {
    std::string text =
        control.feed_enabled == control.spindle_enabled
            ? (control.feed_enabled ? "overrides on" : "overrides off")
            : (control.feed_enabled ? "feed override only" : "spindle override only");
    if (control.adaptive_enabled) text += " adaptive";
    if (!control.feed_stop_enabled) text += " no feed stop";
    return text;
  }
  std::string operator()(const ForceControl& force) const {
    static const char* const names[] = {"off",          "force",         "oscillate",
                                        "vibration on", "vibration off", "depth"};
    std::string text = std::string("adaptive ") + names[static_cast<int>(force.kind)];
    const auto add = [&](const char* name, double value) {
      if (value != 0.0) text += std::string(" ") + name + number_text(value);
    };
    add("P_z=", force.force_n);
    add("S_min=", force.feed_min);
    add("S_max=", force.feed_max);
    if (force.per_revolution) text += " per revolution";
    add("P_osc=", force.oscillation_n);
    add("f=", force.oscillation_hz);
    add("level=", force.level_um);
    add("m_d=", force.reduced_mass_kg);
    add("t=", force.depth_mm);
    return text;
  }
  std::string operator()(const SplineMove& spline) const {
    std::string text = "spline " + std::to_string(spline.degree);
    text += axes_text(spline.base.end, spline.base.words);
    for (const auto& point : spline.points)
      text += " (" + number_text(point[0]) + " " + number_text(point[1]) + ")";
    for (const double weight : spline.weights) text += " w" + number_text(weight);
    if (spline.base.plane != Plane::xy) text += spline.base.plane == Plane::zx ? " ZX" : " YZ";
    return text + " F" + number_text(spline.base.feed);
  }
  std::string operator()(const SynchronousMove& move) const {
    const bool thread = move.kind == SynchronousMove::Kind::thread;
    std::string text = thread ? "thread" : "rigid tap";
    text +=
        axes_text(move.line.end, move.line.words) + " lead " + number_text(move.lead_mm_per_rev);
    if (move.start_angle_deg != 0.0) text += " angle " + number_text(move.start_angle_deg);
    if (move.spindle != 0) text += " $" + std::to_string(move.spindle);
    if (move.return_speed_factor != 1.0) text += " return " + number_text(move.return_speed_factor);
    return text;
  }
  std::string operator()(const ProbeMove& probe) const {
    return std::string("probe ") + (probe.until_contact ? "contact" : "loss") +
           (probe.alarm_when_missed ? " or alarm" : "") +
           axes_text(probe.line.end, probe.line.words) + " F" + number_text(probe.line.feed);
  }
  std::string operator()(const FeedLawChange& change) const {
    const FeedLaw& law = change.law;
    const LawType* const type = find_law_type(law.kind);
    std::string text = "law " + std::string(type == nullptr ? "off" : type->name);
    const auto add = [&](const char* name, double value) {
      if (value != 0.0) text += std::string(" ") + name + number_text(value);
    };
    add("S_n=", law.feed_first);
    add("S_k=", law.feed_last);
    add(law.falls ? "dS=-" : "dS=", law.feed_step);
    add("dl=", law.path_step_mm);
    add("n_s=", law.steps);
    add("L_A=", law.stand_mm);
    add("L_B=", law.cut_mm);
    const char* const unit = law.speed == FeedLaw::Speed::m_per_min ? "v_n=" : "n_n=";
    add(unit, law.speed_first);
    add("step ", law.speed_step);
    add("to ", law.speed_last);
    for (const FeedLaw::CurvePoint& point : law.curve) {
      text += " (" + number_text(point.path_mm) + " " + number_text(point.feed) + " " +
              number_text(point.speed) + ")";
    }
    if (law.gives_feed() && law.feed_mode == FeedMode::per_revolution) text += " per revolution";
    return text + (change.of_next_block ? " for the block" : "");
  }
  std::string operator()(const TransformationChange& change) const {
    static const char* const names[] = {"off", "polar face", "cylinder"};
    std::string text = std::string("transformation ") + names[static_cast<int>(change.kind)];
    if (change.radius_mm != 0.0) text += " " + number_text(change.radius_mm);
    if (change.rotary_axis < 0) return text;
    return text + " " + channel_.axes[static_cast<std::size_t>(change.rotary_axis)].word;
  }
  std::string operator()(const CuttingSpeedMode& mode) const {
    if (!mode.constant) return "cutting speed off";
    std::string text = "cutting speed " + number_text(mode.speed_m_per_min);
    if (mode.limit_rev_per_min > 0.0) text += " limit " + number_text(mode.limit_rev_per_min);
    if (mode.spindle != 0) text += " $" + std::to_string(mode.spindle);
    return text;
  }
  std::string operator()(const OutputCommand& output) const {
    return std::string(output.analog ? "analog output " : "output ") +
           std::to_string(output.number) + " " + number_text(output.value) +
           (output.with_motion ? " with motion" : "");
  }
  std::string operator()(const MachineFunction& function) const {
    std::string text = "machine function " + std::to_string(function.code);
    if (function.p != 0.0) text += " P" + number_text(function.p);
    if (function.q != 0.0) text += " Q" + number_text(function.q);
    return text;
  }
  std::string operator()(const MarkCommand& mark) const {
    static const char* const names[] = {"mark set ", "mark clear ", "mark wait soft "};
    std::string text = names[static_cast<int>(mark.kind)] + std::to_string(mark.id);
    for (int k = 0; k < 32; ++k)
      if ((mark.channels >> k & 1U) != 0) text += " " + std::to_string(k);
    return text;
  }
  std::string operator()(const WorkpieceAnnouncement& announcement) const {
    static const char* const names[] = {"box", "cylinder", "file "};
    const WorkpieceShape& workpiece = announcement.shape;
    std::string text = std::string("workpiece ") + names[workpiece.type];
    text += std::filesystem::path(announcement.file).filename().string();
    text += workpiece.machining_type == 0 ? " milling" : " turning";
    text += " " + number_text(workpiece.screen_resolution_mm);
    for (const double part : workpiece.size_mm) text += " " + number_text(part);
    for (const double part : workpiece.zero_mm) text += " " + number_text(part);
    return text;
  }
  std::string operator()(const WorkpiecePosition& position) const {
    std::string text = "workpiece position";
    for (const double part : position.position_mm) text += " " + number_text(part);
    for (const double part : position.angles_deg) text += " " + number_text(part);
    return text;
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
  std::string operator()(const ProgramRequest& request) const {
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
                                        "take the tap out",
                                        "terminate",
                                        "write tool",
                                        "write offset",
                                        "read tool",
                                        "read offset",
                                        "read",
                                        "probe result",
                                        "wait for input",
                                        "mark wait",
                                        "mark state",
                                        "read shared",
                                        "write shared",
                                        "program restart",
                                        "combine shared"};
    std::string text = std::string("request ") + names[static_cast<int>(request.kind)];
    if (request.channel != 0) text += " channel " + std::to_string(request.channel);
    if (request.number != 0) text += " " + std::to_string(request.number);
    if (!request.text.empty()) text += " " + request.text;
    const bool combines = request.kind == RequestKind::shared_combine;
    const bool writes = combines || request.kind == RequestKind::shared_write;
    if (request.kind == RequestKind::shared_read || writes)
      text += "[" + std::to_string(request.index) + "]";
    if (combines) text += std::string(" ") + "+-*/"[static_cast<int>(request.combination)];
    if (writes)
      text += request.value_text.empty() ? " " + number_text(request.value)
                                         : " \"" + request.value_text + "\"";
    for (int k = 0; k < 32; ++k)
      if ((request.channels >> k & 1U) != 0) text += " with " + std::to_string(k);
    if (request.kind == RequestKind::offset_table_write ||
        request.kind == RequestKind::tool_table_write)
      text += " " + number_text(request.value);
    if (request.kind == RequestKind::input_wait)
      text += (request.analog ? " analog mode " : " mode ") + std::to_string(request.index);
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
    if (kind == "grind") channel.kind = ChannelKind::grind;
    if (kind == "two spindles") {
      channel.spindles = {1, 2};
      channel.spindles_with_position = {1};
    }
    if (kind == "lathe") {
      channel.kind = ChannelKind::lathe;
      channel.has_force_control = true;
      channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}, {"C", true, 0.0, -1}};
    }
    if (kind == "plain corners") {
      channel.kind = ChannelKind::lathe;
      channel.plain_corners = true;
      channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
    }
    if (kind.starts_with("table ")) {
      channel.axes = {{"X", false, 0.0, 0}, {"Y", false, 0.0, 1}, {"Z", false, 0.0, 2}};
      channel.axes.push_back({kind.substr(6), true, 0.0, -1});
    }
    if (kind == "spindle axis") channel.axes.back().spindle = 1;
    if (kind == "letters") channel.address_alias = {{'E', "dS"}, {'V', "dl"}};
    for (int number = 1; number <= 9; ++number) {
      tables.tools[number] = {number, {0.0, 0.0, 10.0 * number}, 1.0};
    }
    tables.offsets[2] = {100.0, 200.0, 300.0};
    answering = [passes = 1](const ProgramRequest& request) mutable {
      Answer answer;
      if (request.kind == RequestKind::program_restart) answer.ok = passes++ == 1;
      answer.number = 2.0;
      return answer;
    };
    for (const auto& entry : std::filesystem::recursive_directory_iterator(conformance_folder)) {
      if (entry.path().parent_path().filename() != "included") continue;
      files.texts[entry.path().filename().string()] = file_text(entry.path());
    }
    files.texts["box_40_30_10.stl"] =
        text_of(BlankFile{.fingerprint = 1, .low = {}, .high = {40.0, 30.0, 10.0}});
    const std::filesystem::path cycles = conformance_folder.parent_path() / "cycles";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(cycles)) {
      if (entry.path().extension() != ".nc") continue;
      const auto name = std::filesystem::relative(entry.path(), cycles);
      files.texts[name.generic_string()] = file_text(entry.path());
    }
  }
};

TEST_P(Conformance, DoesWhatItSays) {
  const std::string text = file_text(conformance_folder / GetParam());
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

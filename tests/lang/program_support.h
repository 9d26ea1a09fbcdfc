// Runs program texts in tests: files in memory, tables in memory, all commands of a run in a list.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lang/run/interpreter.h"
#include "lang/text/source.h"

namespace stanok::lang::testing {

using Texts = std::vector<std::string>;

// A text so many times, one behind the other.
inline std::string repeated(std::string_view text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

// A text as the compiler reads it.
inline Source source_of(const std::string& name, std::string_view text) {
  return Source(std::make_shared<const SourceText>(SourceText{name, name, std::string(text)}));
}

// A text that is refused, when it is loaded or when it runs, and the code that says why.
struct FaultCase {
  const char* text;
  const char* code;
};

class MemoryFiles : public Files {
 public:
  std::map<std::string, std::string> texts;

  [[nodiscard]] Expected<std::shared_ptr<const SourceText>, Diagnostic> read(
      std::string_view name, std::string_view) const override {
    const auto found = texts.find(std::string(name));
    if (found != texts.end()) {
      return std::make_shared<const SourceText>(
          SourceText{found->first, found->first, found->second});
    }
    Diagnostic missing;
    missing.code = "E7001";
    missing.message = "the file was not found: " + std::string(name);
    return tl::unexpected(missing);
  }
};

class MemoryTables : public Tables {
 public:
  std::map<int, AxisValues> offsets;
  std::map<int, double> rotations;
  std::map<int, AxisValues> reference;
  std::map<int, Tool> tools;
  MachineReading reading;
  AxisSet in_scheme = static_cast<AxisSet>(~0U);
  AxisSet led = static_cast<AxisSet>(~0U);

  [[nodiscard]] std::optional<AxisValues> work_offset(int number) const override {
    const auto found = offsets.find(number);
    if (found != offsets.end()) return found->second;
    return number >= 1 && number <= 309 ? std::optional(AxisValues{}) : std::nullopt;
  }
  [[nodiscard]] std::optional<Tool> tool(int number) const override {
    const auto found = tools.find(number);
    return found == tools.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] MachineReading machine_reading() const override { return reading; }
  [[nodiscard]] AxisSet axes_of_scheme() const override { return in_scheme; }
  [[nodiscard]] AxisSet leading_axes() const override { return led; }
  // A head that B tilts about Y over a table that C turns about Z: the tool points to
  // (sin B cos C, -sin B sin C, cos B). B reaches 100 deg to both sides.
  [[nodiscard]] Alignment alignment(const AlignmentWish& wish) const override {
    constexpr std::size_t b = 3;
    constexpr std::size_t c = 4;
    constexpr double limit = 100.0;
    const double deg = 45.0 / std::atan(1.0);
    const auto [x, y, z] = wish.tool_B;
    const double tilt = deg * std::atan2(std::hypot(x, y), z);
    const bool upright = tilt < 1e-9;
    Alignment found;
    found.axes = axis_bit(b) | axis_bit(c);
    found.angles_B = wish.from_B;
    if (tilt > limit) {
      found.outcome = Alignment::Outcome::beyond_limit;
      found.axis = b;
      found.needed_deg = tilt;
      found.limit_deg = limit;
      return found;
    }
    found.outcome = Alignment::Outcome::found;
    const bool back = wish.first == FirstRotary::negative;
    found.angles_B[b] = upright ? 0.0 : back ? -tilt : tilt;
    if (!upright) found.angles_B[c] = deg * std::atan2(-y, x) + (back ? 180.0 : 0.0);
    return found;
  }
  [[nodiscard]] std::array<Direction, 3> spindle_axes(const AxisValues& position_B) const override {
    const double rad = std::atan(1.0) / 45.0;
    const double sb = std::sin(position_B[3] * rad);
    const double cb = std::cos(position_B[3] * rad);
    const double sc = std::sin(position_B[4] * rad);
    const double cc = std::cos(position_B[4] * rad);
    return {Direction{cb * cc, -cb * sc, -sb}, Direction{sc, cc, 0.0},
            Direction{sb * cc, -sb * sc, cb}};
  }
  // The table turns about X100 Y0.
  [[nodiscard]] std::optional<AxisValues> carried_by_table(
      const AxisValues& point_B, const AxisValues& position_B) const override {
    constexpr double centre = 100.0;
    const double turn = (position_B[4] - point_B[4]) * std::atan(1.0) / 45.0;
    const double x = point_B[0] - centre;
    AxisValues carried = point_B;
    carried[0] = centre + std::cos(turn) * x - std::sin(turn) * point_B[1];
    carried[1] = std::sin(turn) * x + std::cos(turn) * point_B[1];
    return carried;
  }
  [[nodiscard]] double work_offset_rotation(int number) const override {
    const auto found = rotations.find(number);
    return found == rotations.end() ? 0.0 : found->second;
  }
  std::map<int, double> common_variables;
  [[nodiscard]] double common_variable(int number) const override {
    const auto found = common_variables.find(number);
    return found == common_variables.end() ? std::nan("") : found->second;
  }
  void set_common_variable(int number, double value) override { common_variables[number] = value; }
  [[nodiscard]] AxisValues reference_point(int which) const override {
    const auto found = reference.find(which);
    return found == reference.end() ? AxisValues{} : found->second;
  }
  void store_reference_point(int which, const AxisValues& point_M) override {
    reference[which] = point_M;
  }
};

inline ChannelDescription mill_xyzbc() {
  ChannelDescription channel;
  channel.name = "work";
  channel.axes = {{"X", false, 0.0, 0},
                  {"Y", false, 0.0, 1},
                  {"Z", false, 0.0, 2},
                  {"B", true, 0.0, -1},
                  {"C", true, 360.0, -1}};
  channel.spindles = {1};
  channel.channels = {1, 2};
  channel.schemes = {{1, 1}, {1, 2}};
  channel.finest_resolution_mm = 0.001;
  return channel;
}

inline ChannelDescription master_channel() {
  ChannelDescription channel;
  channel.id = 2;
  channel.name = "master";
  channel.kind = ChannelKind::master;
  channel.channels = {1, 2};
  channel.schemes = {{1, 1}, {1, 2}};
  return channel;
}

// A program that is compiled and run to its end (or its failure).
class ProgramTest : public ::testing::Test {
 protected:
  // What the channel answers to a request; ok without a position by default, but the main program
  // does not begin again.
  using Answering = std::function<Answer(const ProgramRequest&)>;
  static Answer usual_answer(const ProgramRequest& request) {
    Answer answer;
    answer.ok = request.kind != RequestKind::program_restart;
    return answer;
  }

  std::vector<Diagnostic> load_errors(const std::string& text) {
    files.texts["main.nc"] = text;
    warnings.clear();
    auto program = compile("main.nc", files, &channel, warnings);
    return program ? Diagnostics{} : program.error();
  }

  // All commands behind FrameChange and ToolLength of the default state. Fails the test when the
  // program does not load.
  std::vector<Command> run(const std::string& text) {
    files.texts["main.nc"] = text;
    warnings.clear();
    commands.clear();
    error = {};
    auto program = compile("main.nc", files, &channel, warnings);
    if (!program) {
      for (const Diagnostic& diagnostic : program.error()) ADD_FAILURE() << to_text(diagnostic);
      return {};
    }
    interpreter = std::make_unique<Interpreter>(channel, tables, files);
    interpreter->start(*program, start_B);
    drain();
    EXPECT_GE(commands.size(), 2u);
    if (commands.size() >= 2) commands.erase(commands.begin(), commands.begin() + 2);
    return commands;
  }

  void drain() {
    Command command;
    for (int steps = 0; steps < 1000000; ++steps) {
      last_step = interpreter->next(command);
      if (last_step == Step::ended) return;
      if (last_step == Step::failed) {
        error = interpreter->error();
        return;
      }
      if (last_step == Step::command) commands.push_back(command);
      if (last_step == Step::waiting) {
        const auto* request = std::get_if<ProgramRequest>(&commands.back().payload);
        ASSERT_NE(request, nullptr);
        interpreter->answer(answering ? answering(*request) : usual_answer(*request));
      }
    }
    ADD_FAILURE() << "the program does not end";
  }

  template <class Wanted>
  std::vector<Wanted> all() const {
    std::vector<Wanted> list;
    for (const Command& command : commands) {
      if (const auto* payload = std::get_if<Wanted>(&command.payload)) list.push_back(*payload);
    }
    return list;
  }

  std::vector<Move> moves(const std::string& text) {
    run(text);
    EXPECT_EQ(error.code, "") << to_text(error);
    return all<Move>();
  }

  // Texts of all messages of a run.
  std::vector<std::string> messages(const std::string& text) {
    run(text);
    EXPECT_EQ(error.code, "") << to_text(error);
    std::vector<std::string> list;
    for (const Message& message : all<Message>()) list.push_back(message.text);
    return list;
  }

  // Code of the only load error, or of the failure of the run; "" when there is none.
  std::string error_code(const std::string& text) {
    const auto errors = load_errors(text);
    if (!errors.empty()) {
      error = errors.front();
      return error.code;
    }
    run(text);
    return error.code;
  }

  ChannelDescription channel = mill_xyzbc();
  MemoryFiles files;
  MemoryTables tables;
  AxisValues start_B{};
  Answering answering;
  Diagnostics warnings;
  std::unique_ptr<Interpreter> interpreter;
  std::vector<Command> commands;
  Diagnostic error;
  Step last_step = Step::ended;
};

}  // namespace stanok::lang::testing

// Blocks per second of the interpreter: plain text of 3 and 5 axes, blocks with expressions.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "lang/run/interpreter.h"

namespace stanok::lang {
namespace {

constexpr int lines = 200000;

class OneFile : public Files {
 public:
  explicit OneFile(std::string text)
      : text_(std::make_shared<const SourceText>(
            SourceText{"program.nc", "program.nc", std::move(text)})) {}

  [[nodiscard]] Expected<std::shared_ptr<const SourceText>, Diagnostic> read(
      std::string_view, std::string_view) const override {
    return text_;
  }

 private:
  std::shared_ptr<const SourceText> text_;
};

class EmptyTables : public Tables {
 public:
  [[nodiscard]] std::optional<AxisValues> work_offset(int) const override { return AxisValues{}; }
  [[nodiscard]] std::optional<Tool> tool(int) const override { return Tool{}; }
  [[nodiscard]] MachineReading machine_reading() const override { return {}; }
  [[nodiscard]] AxisValues reference_point(int) const override { return {}; }
  [[nodiscard]] double common_variable(int) const override { return 0.0; }
  void set_common_variable(int, double) override {}
  void store_reference_point(int, const AxisValues&) override {}
};

ChannelDescription five_axes() {
  ChannelDescription channel;
  channel.axes = {{"X", false, 0.0, 0},
                  {"Y", false, 0.0, 1},
                  {"Z", false, 0.0, 2},
                  {"B", true, 0.0, -1},
                  {"C", true, 0.0, -1}};
  channel.channels = {1};
  return channel;
}

std::string plain_text(bool rotary, bool motion_code) {
  std::string text = "G21 G90 G94\nG1 F1000\n";
  for (int i = 0; i < lines; ++i) {
    const double t = 0.001 * i;
    char line[160];
    std::snprintf(line, sizeof line, "%sX%.4f Y%.4f Z%.4f", motion_code ? "G1 " : "",
                  80.0 * std::cos(t), 80.0 * std::sin(t), -0.01 * t);
    text += line;
    if (rotary) {
      std::snprintf(line, sizeof line, " B%.5f C%.5f", 30.0 * std::sin(3.0 * t), 100.0 * t);
      text += line;
    }
    text += '\n';
  }
  return text + "M30\n";
}

void run(benchmark::State& state, const std::string& text) {
  const OneFile files(text);
  EmptyTables tables;
  const ChannelDescription channel = five_axes();
  Diagnostics warnings;
  const auto program = compile("program.nc", files, &channel, warnings);
  if (!program) return state.SkipWithError(program.error().front().message.c_str());
  Interpreter interpreter(channel, tables, files);
  std::uint64_t blocks = 0;
  for ([[maybe_unused]] auto _ : state) {
    interpreter.start(*program, {});
    Command command;
    for (Step step = interpreter.next(command); step != Step::ended;
         step = interpreter.next(command)) {
      benchmark::DoNotOptimize(command);
    }
    blocks += interpreter.blocks();
  }
  state.counters["blocks"] =
      benchmark::Counter(static_cast<double>(blocks), benchmark::Counter::kIsRate);
}

void plain_three_axes(benchmark::State& state) {
  run(state, plain_text(false, false));
}
BENCHMARK(plain_three_axes)->Unit(benchmark::kMillisecond);

void plain_three_axes_with_code(benchmark::State& state) {
  run(state, plain_text(false, true));
}
BENCHMARK(plain_three_axes_with_code)->Unit(benchmark::kMillisecond);

void plain_five_axes(benchmark::State& state) {
  run(state, plain_text(true, false));
}
BENCHMARK(plain_five_axes)->Unit(benchmark::kMillisecond);

void computed_blocks(benchmark::State& state) {
  run(state,
      "num angle;\nF1000\nwhile (angle < 200000) {\nG1 X=80*cos (angle) Y=80*sin (angle)\n"
      "angle += 1;\n}\nM30\n");
}
BENCHMARK(computed_blocks)->Unit(benchmark::kMillisecond);

// Blocks with an axis word only are counted; each pass computes twice besides.
void loop_of_macro_lines(benchmark::State& state) {
  run(state,
      "(dialect fanuc)\n#1=0\nG1 F1000\nWHILE [#1 LT 200000] DO 1\nX#1 Y[#1*2]\n#1=#1+1\nEND 1\n"
      "M30\n");
}
BENCHMARK(loop_of_macro_lines)->Unit(benchmark::kMillisecond);

void loop_of_jumps(benchmark::State& state) {
  run(state, "(dialect fanuc)\n#1=0\nG1 F1000\nN10 X#1\n#1=#1+1\nIF [#1 LT 200000] GOTO 10\nM30\n");
}
BENCHMARK(loop_of_jumps)->Unit(benchmark::kMillisecond);

void load(benchmark::State& state) {
  const OneFile files(plain_text(false, true));
  const ChannelDescription channel = five_axes();
  for ([[maybe_unused]] auto _ : state) {
    Diagnostics warnings;
    benchmark::DoNotOptimize(compile("program.nc", files, &channel, warnings));
  }
  state.counters["lines"] =
      benchmark::Counter(static_cast<double>(lines) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}
BENCHMARK(load)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stanok::lang

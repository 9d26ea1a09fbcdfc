#include "tests/support/machine/held_program.h"

#include <algorithm>
#include <cmath>

namespace stanok::testing {
namespace {

using namespace channels;  // NOLINT(google-build-using-namespace)

std::string random_program(HeldProgram& chance, const HeldCase& at) {
  std::string text = at.head + "F3000\n";
  for (int n = 0; n < 14; ++n) {
    text += chance.pick(0, 4) == 0 ? "G0" : "G1";
    for (const char* word = at.coordinates; *word != 0; ++word) {
      if (chance.pick(0, 2) != 0)
        text += std::string(" ") + *word + std::to_string(chance.pick(-40, 40));
    }
    text += "\n";
    if (chance.pick(0, 9) == 0) text += "G4 P0.05\n";
    if (chance.pick(0, 9) == 0) text += "M0\n";
  }
  return text + "M30\n";
}

}  // namespace

MachineConfig five_axis_machine() {
  MachineConfig machine = two_channel_machine();
  machine.channels[0].scheme = 2;
  return machine;
}

HeldCase held_mill() {
  return {.name = "mill",
          .machine = two_channel_machine,
          .head = "T1 M6\nG43 H1\nG64 P0.05\nM3 S1000\nM8\n",
          .coordinates = "XYZ",
          .jogged = {"X", "Y", "Z"},
          .keys = {{"length", 2}, {"wear_length", 2}}};
}

HeldCase held_five_axes() {
  return {.name = "five_axes",
          .machine = five_axis_machine,
          .head = "T1 M6\nG43 H1\nG64 P0.05\nM3 S1000\nM8\n",
          .coordinates = "XYZBC",
          .jogged = {"Z", "B", "C"},
          .keys = {{"length", 2}, {"wear_length", 2}}};
}

HeldCase held_led_point() {
  return {.name = "led_point",
          .machine = five_axis_machine,
          .head = "G43.4\nG64 P0.05\nM3 S1000\nM8\n",
          .coordinates = "XYZBC",
          .jogged = {"Z", "B", "C"},
          .keys = {}};
}

HeldCase held_lathe() {
  return {.name = "lathe",
          .machine = turning_machine,
          .head = "T1\nG43 H1\nG64 P0.05\nM3 S1000\nM8\n",
          .coordinates = "XZ",
          .jogged = {"X", "Z", "X"},
          .keys = {{"length", 1}, {"length_x", 0}, {"wear_length", 1}, {"wear_length_x", 0}}};
}

HeldProgram::HeldProgram(const HeldCase& at, unsigned seed)
    : at_(at), random_(seed), bench(at.machine(), {.on_at_start = true, .stops_go_on = false}) {
  for (const auto& [key, axis] : at.keys)
    set(key, std::string_view(key).starts_with("wear") ? 0.125 : 40.0);
  bench.program("p.nc", random_program(*this, at));
}

int HeldProgram::pick(int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random_);
}

double HeldProgram::real(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_);
}

HeldProgram::Places HeldProgram::axes() const {
  const ChannelOutput& channel = bench.channel(1);
  Places places{};
  for (std::size_t k = 0; k < places.size(); ++k)
    if (!channel.drives[k].follows_velocity) places[k] = channel.axes[k].position;
  return places;
}

void HeldProgram::cycle() {
  bench.cycle();
  const Places now = axes();
  if (course_.empty() || course_.back() != now) course_.push_back(now);
  look();
}

// A function whose third derivative is at most j has third differences of at most j h^3, and so on.
void HeldProgram::look() {
  std::ranges::rotate(newest_, newest_.end() - 1);
  newest_[0] = axes();
  if (++cycles_ < 4) return;
  constexpr double h = 1e-3;
  constexpr double rounding = 1e-12;
  const auto& [p0, p1, p2, p3] = newest_;
  for (std::size_t k = 0; k < axis_count; ++k) {
    const bool is_linear = at_.machine == turning_machine ? k < lathe_C : k < 3;
    const double v = is_linear ? 250.0 : 120.0;
    const double a = is_linear ? 2500.0 : 1200.0;
    const double j = is_linear ? 50000.0 : 24000.0;
    EXPECT_LE(std::abs(p0[k] - p1[k]), v * h * (1.0 + 1e-9) + rounding) << k;
    EXPECT_LE(std::abs(p0[k] - 2.0 * p1[k] + p2[k]), a * h * h * (1.0 + 1e-6) + rounding) << k;
    EXPECT_LE(std::abs(p0[k] - 3.0 * p1[k] + 3.0 * p2[k] - p3[k]),
              j * h * h * h * (1.0 + 1e-3) + rounding)
        << k;
  }
}

void HeldProgram::go_on(int cycles) {
  if (std::exchange(has_begun_, true)) {
    bench.ask(OperatorAction::program_start, 1);
  } else {
    bench.run(1, "p.nc");
  }
  cycle();
  for (int n = 0; n < 60000 && (bench.channel(1).running || n < 1000); ++n) {
    const Places before = axes();
    cycle();
    if (before != axes() && --cycles == 0) return;
    const ChannelOutput& channel = bench.channel(1);
    if (channel.state == ChannelState::held && channel.aside) come_back();
    if (channel.state == ChannelState::held) bench.ask(OperatorAction::program_start, 1);
  }
}

void HeldProgram::hold() {
  bench.ask(OperatorAction::program_hold, 1);
  for (int n = 0; n < 5; ++n) cycle();
  rest();
}

void HeldProgram::rest() {
  cycle();
  for (int n = 0; n < 60000 && bench.channel(1).moving; ++n) cycle();
  EXPECT_FALSE(bench.channel(1).moving);
}

std::string HeldProgram::code_of(const OperatorCommand& command) {
  OperatorEvent event;
  event.channel = std::holds_alternative<commands::ToolSet>(command) ? 0 : 1;
  event.command = command;
  const std::size_t before = bench.replies().size();
  bench.ask(event);
  for (int n = 0; n < 60000 && bench.replies().size() == before; ++n) cycle();
  EXPECT_GT(bench.replies().size(), before);
  return std::string(bench.replies().back().code.view());
}

void HeldProgram::set(const char* key, double value, int tool) {
  EXPECT_EQ(code_of(commands::ToolSet{.key = ShortText(key), .value = value, .tool = tool}), "");
  values_[{tool, key}] = value;
}

std::string HeldProgram::change(const char* key, double by, int tool) {
  double& value = values_[{tool, key}];
  const std::string code =
      code_of(commands::ToolSet{.key = ShortText(key), .value = value + by, .tool = tool});
  if (code.empty()) value += by;
  return code;
}

std::string HeldProgram::touch(const char* key, std::size_t axis, double by) {
  if (std::string_view(key).starts_with("wear")) return change(key, by);
  const double shown = bench.channel(1).point_W[axis].value;
  const std::string code = code_of(
      commands::ToolTouch{.key = ShortText(key), .point_W = shown - by, .tool = 1, .edge = 1});
  if (code.empty()) values_[{1, key}] += by;
  return code;
}

void HeldProgram::expect_done_or(std::initializer_list<std::string_view> codes,
                                 const std::string& code, const char* what) {
  EXPECT_TRUE(code.empty() || std::ranges::find(codes, code) != codes.end())
      << what << ": " << code << " " << (code.empty() ? "" : bench.replies().back().text.view())
      << " " << ::testing::PrintToString(bench.alarm_codes());
}

// E6053: out of its travel. E6099: not from this place. E6100: the way back is too long.
void HeldProgram::jog(const char* axis, double way) {
  const commands::Jog jog{.axis = ShortText(axis),
                          .velocity = std::copysign(std::max(std::abs(way), 5.0), way),
                          .increment = std::abs(way)};
  expect_done_or({"E6053", "E6099", "E6100"}, code_of(jog), "jog");
  rest();
}

void HeldProgram::jog() {
  jog(at_.jogged.at(static_cast<std::size_t>(pick(0, 2))),
      (pick(0, 1) == 0 ? 1.0 : -1.0) * real(0.01, 30.0));
}

// Detents that come fast: several on their way at once.
void HeldProgram::turn_wheel() {
  const char* const axis = at_.jogged.at(static_cast<std::size_t>(pick(0, 2)));
  const double detent = (pick(0, 1) == 0 ? 1.0 : -1.0) * real(0.001, 0.1);
  for (int detents = pick(1, 30); detents > 0; --detents) {
    const std::string code = code_of(commands::Handwheel{.axis = ShortText(axis), .way = detent});
    expect_done_or({"E6053", "E6099", "E6100"}, code, "wheel");
    for (int n = pick(0, 30); n > 0; --n) cycle();
  }
  rest();
}

// Along the path, by a way or as long as it is asked for. E6097: the axes were jogged. E6102: there
// is no way.
void HeldProgram::retrace() {
  commands::ProgramRetrace retrace;
  retrace.direction = pick(0, 2) == 0 ? RetraceDirection::forward : RetraceDirection::back;
  if (pick(0, 1) == 0) retrace.length = real(0.01, 60.0);
  for (int times = retrace.length > 0.0 ? 1 : pick(1, 20); times > 0; --times) {
    const std::string code = code_of(retrace);
    expect_done_or({"E6097", "E6099", "E6102"}, code, "retrace");
    if (code.empty()) ++retraced_;
    if (retrace.length == 0.0)
      for (int n = 0; n < 100; ++n) cycle();
  }
  rest();
}

void HeldProgram::come_back() {
  if (!bench.channel(1).aside) return;
  EXPECT_EQ(code_of(commands::ProgramReturn{.velocity = real(2.0, 80.0)}), "");
  EXPECT_FALSE(bench.channel(1).aside);
}

}  // namespace stanok::testing

#include "tests/support/chain/operator_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "config/files/machine_file.h"
#include "lang/contract/active_codes.h"
#include "tests/support/project_folders.h"

namespace stanok::testing {
namespace {

constexpr int cycles_max = 400000;
constexpr double same = 1e-9;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4f", value);
  return text.data();
}

void compare(std::string& found, const std::string& what, double a, double b) {
  if (std::abs(a - b) <= same) return;
  if (!found.empty()) found += "; ";
  found += what + " " + std::to_string(a) + " and " + std::to_string(b);
}

using Row = std::map<std::string, double>;

Row values_of(const channels::TablesConfig& tables) {
  Row values;
  for (const auto& [name, row] : tables.offsets) {
    for (const auto& [axis, value] : row) values[name + " " + axis] = value;
  }
  for (const auto& [channel, points] : tables.reference_points) {
    for (const auto& [name, row] : points) {
      for (const auto& [axis, value] : row)
        values[name + " of channel " + std::to_string(channel) + " " + axis] = value;
    }
  }
  for (const channels::ToolEdge& tool : tables.tools) {
    const std::string name =
        "tool " + std::to_string(tool.number) + " edge " + std::to_string(tool.edge);
    values[name + " length"] = tool.length;
    values[name + " length_x"] = tool.length_x;
    values[name + " length_y"] = tool.length_y;
    values[name + " wear"] = tool.wear_length;
    values[name + " radius"] = tool.radius;
  }
  return values;
}

}  // namespace

std::vector<std::string> machines_with_tools() {
  std::vector<std::string> names;
  const std::filesystem::path folder = source_folder() + "/config/machines";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem();
    if (!shipped_machine(name).tables.tools.empty()) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

channels::MachineConfig shipped_machine(const std::string& name) {
  return config::read_machine_file(source_folder() + "/config/machines/" + name + ".toml").machine;
}

std::string difference(const ChannelLeft& a, const ChannelLeft& b) {
  std::string found;
  for (std::size_t k = 0; k < a.axes_M.size(); ++k)
    compare(found, "axis " + std::to_string(k), a.axes_M[k], b.axes_M[k]);
  Row values = values_of(a.tables);
  const Row others = values_of(b.tables);
  for (const auto& [name, value] : others) values.try_emplace(name, 0.0);
  for (const auto& [name, value] : values) {
    const auto other = others.find(name);
    compare(found, name, value, other == others.end() ? 0.0 : other->second);
  }
  for (std::size_t k = 0; k < a.frame.offset.size(); ++k)
    compare(found, "zero of axis " + std::to_string(k), a.frame.offset[k], b.frame.offset[k]);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      compare(found, "rotation", a.frame.rotation.rows()[row][column],
              b.frame.rotation.rows()[row][column]);
    }
  }
  for (std::size_t k = 0; k < a.words.size(); ++k)
    compare(found, "word of axis " + std::to_string(k), a.words[k], b.words[k]);
  if (a.length.tool != b.length.tool || a.length.edge != b.length.edge ||
      a.length.row != b.length.row || a.length.mode != b.length.mode)
    found += "; origin of the length";
  for (std::size_t k = 0; k < 3; ++k) {
    compare(found, "length", a.length.offset_mm[k], b.length.offset_mm[k]);
    compare(found, "base of the length", a.length.base_mm[k], b.length.base_mm[k]);
  }
  if (a.mode != b.mode) found += "; mode of the point";
  compare(found, "tool", a.tool, b.tool);
  compare(found, "spindle", a.spindle_rev_per_min, b.spindle_rev_per_min);
  if (a.codes != b.codes) {
    found += "; codes";
    for (std::size_t k = 0; k < std::min(a.codes.size(), b.codes.size()); ++k) {
      if (a.codes[k] != b.codes[k]) found += " " + a.codes[k] + "/" + b.codes[k];
    }
  }
  return found;
}

LineSource::LineSource(const channels::MachineConfig& machine, Choices& choices)
    : machine_(machine), channel_(machine.channels[0]), choices_(choices) {}

std::string LineSource::first() const {
  return "G21 G90 G94 F6000 S500";
}

std::size_t LineSource::place_of(const std::string& word) const {
  const auto& words = channel_.words;
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

int LineSource::any_tool() {
  std::vector<int> numbers;
  for (const auto& tool : machine_.tables.tools) {
    if (tool.edge == 1) numbers.push_back(tool.number);
  }
  return numbers[choices_.below(numbers.size())];
}

// Words of one to all of these letters that the channel has.
std::string LineSource::words(const std::string& letters, double low, double high) {
  std::string text;
  for (const char letter : letters) {
    const std::string word(1, letter);
    const auto& all = channel_.words;
    if (std::find(all.begin(), all.end(), word) == all.end()) continue;
    if (!text.empty() && choices_.chance(0.5)) continue;
    text += " " + word + number(choices_.between(low, high));
  }
  return text;
}

std::string LineSource::any_of(const std::vector<std::string>& texts) {
  return texts[choices_.below(texts.size())];
}

// From where the axes stand, mostly in their travel whatever the frame is.
std::string LineSource::move(const lang::AxisValues& shown) {
  const std::string code = choices_.chance(0.5) ? " G0" : " G1";
  if (choices_.chance(0.4)) {
    count("G91");
    return "G91" + code + words("XYZ", -4.0, 4.0);
  }
  std::string text = "G90" + code;
  for (std::size_t k = 0; k < channel_.words.size(); ++k) {
    const std::string& word = channel_.words[k];
    const bool is_linear = word == "X" || word == "Y" || word == "Z";
    if (!is_linear || choices_.chance(0.4)) continue;
    text += " " + word + number(shown[k] + choices_.between(-4.0, 4.0));
  }
  return text;
}

std::string LineSource::of_offsets() {
  const int page = 1 + static_cast<int>(choices_.below(6));
  const std::string p = " P" + std::to_string(page);
  switch (choices_.below(7)) {
    case 0:
      count("G54");
      return any_of({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1"});
    case 1:
      count("G52");
      return "G52" + words("XYZ", -5.0, 5.0);
    case 2:
      count("G92");
      return "G92" + words("XYZ", -5.0, 5.0);
    case 3:
      count("G92");
      return any_of({"G92.1", "G92.2", "G92.3"});
    case 4:
      count("G10 L2");
      return "G10 L2" + p + words("XYZ", -5.0, 5.0);
    default:
      count("G10 L20");
      return "G10 L20" + p + words("XYZ", -5.0, 5.0);
  }
}

std::string LineSource::of_tools() {
  const std::string tool = std::to_string(any_tool());
  if (channel_.kind == lang::ChannelKind::lathe) {
    count("T");
    return "T0" + tool + any_of({"01", "01", "00"});
  }
  switch (choices_.below(12)) {
    case 0:
      count("G44");
      return "G44 H" + tool;
    case 1:
      count("G43.1");
      return "G43.1 Z" + number(choices_.between(-5.0, 5.0));
    case 2:
      count("G43.2");
      return "G43.2 H" + tool;
    case 3:
      count("G43 H0");
      return "G43 H0";
    case 4:
      count("G49");
      return "G49";
    case 5:
      count("G10 L1");
      return "G10 L1 P" + tool + " Z" + number(choices_.between(1.0, 60.0));
    case 6:
      count("G10 L10");
      return "G10 L10 P" + tool + " Z" + number(choices_.between(-9.0, 9.0));
    case 7:
      count("G10 L11");
      return "G10 L11 P" + tool + " Z" + number(choices_.between(-9.0, 9.0));
    case 8:
    case 9:
      count("G43");
      return "G43 H" + tool;
    default:
      count("T");
      return "T" + tool + " M6";
  }
}

std::string LineSource::of_frames() {
  if (channel_.kind != lang::ChannelKind::mill) return "G4 P0.01";
  switch (choices_.below(9)) {
    case 0:
      count("G68");
      return "G68 X" + number(choices_.between(-5.0, 5.0)) + " Y" +
             number(choices_.between(-5.0, 5.0)) + " R" + number(choices_.between(-60.0, 60.0));
    case 1:
    case 2:
      count("G69");
      return "G69";
    case 3:
      count("plane");
      return "G68.2 X" + number(choices_.between(-5.0, 5.0)) + " Z" +
             number(choices_.between(-5.0, 5.0)) + " I" + number(choices_.between(-30.0, 30.0)) +
             " J" + number(choices_.between(-20.0, 20.0));
    case 4:
      count("G51");
      return "G51 X0 Y0 P" + number(choices_.between(0.5, 2.0));
    case 5:
      count("G51.1");
      return "G51.1 X" + number(choices_.between(-5.0, 5.0));
    default:
      count("G50");
      return "G50 G50.1";
  }
}

std::string LineSource::of_cycles(const lang::AxisValues& shown) {
  const double z = shown[place_of("Z")];
  switch (choices_.below(6)) {
    case 0:
      count("probe");
      return "G91 G38.3 Z-2 F600";
    case 1:
      count("cycle");
      return "G90 G81" + words("XY", -3.0, 3.0) + " Z" + number(z - 3.0) + " R" + number(z - 1.0);
    case 2:
      count("cycle");
      return "G80";
    case 3:
      count("stored point");
      return any_of({"G28.1", "G30.1"});
    case 4:
      count("stored point");
      return any_of({"G91 G28 Z0", "G91 G30 Z0"});
    default:
      count("G53");
      return "G53 G0 Z" + number(machine_.axes[channel_.axes[place_of("Z")]].start +
                                 choices_.between(-3.0, 3.0));
  }
}

std::string LineSource::of_modes() {
  count("mode");
  return any_of({"G20", "G21", "G21", "G17", "G90", "G91", "M8", "M9", "M7", "S600 M3", "M5", "G64",
                 "G61", "F5000"});
}

std::string LineSource::next(const lang::AxisValues& shown) {
  const double drawn = choices_.between(0.0, 1.0);
  if (drawn < 0.35) return move(shown);
  if (drawn < 0.55) return of_tools();
  if (drawn < 0.75) return of_offsets();
  if (drawn < 0.85) return of_frames();
  if (drawn < 0.93 && channel_.kind == lang::ChannelKind::mill) return of_cycles(shown);
  return of_modes();
}

HandBench::HandBench(channels::MachineConfig machine)
    : machine_(std::move(machine)), bench_(machine_, {.on_at_start = true, .stops_go_on = false}) {
  settle();
}

void HandBench::settle() {
  for (int n = 0; n < cycles_max; ++n) {
    bench_.cycle();
    if (bench_.machine().is_idle()) return;
  }
  ADD_FAILURE() << "the machine does not come to rest";
}

std::string HandBench::wait(const std::function<bool()>& is_over) {
  const std::size_t alarms = bench_.machine().alarms().size();
  const std::size_t replies = bench_.replies().size();
  for (int n = 0; n < cycles_max && !is_over(); ++n) {
    bench_.cycle();
    for (std::size_t k = replies; k < bench_.replies().size(); ++k) {
      const channels::OperatorReply& reply = bench_.replies()[k];
      if (!reply.ok) return reply.code.view().empty() ? "E7005" : std::string(reply.code.view());
    }
    const auto all = bench_.machine().alarms();
    if (all.size() > alarms && bench_.machine().is_idle()) return all.back().diagnostic.code;
  }
  return is_over() ? "" : "no end";
}

std::string HandBench::type(const std::string& line) {
  bench_.ask(channels::OperatorAction::mdi, 1, line);
  bench_.cycle();
  const std::uint32_t run = now().run;
  return wait([&] { return now().run != run && bench_.machine().is_idle(); });
}

std::string HandBench::run_to_stop(const std::string& text) {
  bench_.program("lines.nc", text + "\nM0\nM2\n");
  bench_.run(1, "lines.nc");
  return wait([&] {
    return now().hold_cause == channels::HoldCause::program_stop &&
           bench_.machine().waits_for_operator();
  });
}

lang::AxisValues HandBench::shown() {
  lang::AxisValues point{};
  for (std::size_t k = 0; k < point.size(); ++k) point[k] = now().point_W[k].value;
  return lang::words_at(bench_.machine().situation(now()).meaning, point);
}

std::string HandBench::typed_back() {
  constexpr double inch = 25.4;
  const lang::Meaning meaning = bench_.machine().situation(now()).meaning;
  const channels::ChannelConfig& channel = machine_.channels[0];
  const auto scheme = std::find_if(channel.schemes.begin(), channel.schemes.end(),
                                   [&](const auto& one) { return one.id == now().scheme; });
  const lang::AxisValues words = shown();
  std::string line = "G90 G40 G80 G0";
  for (std::size_t k = 0; k < channel.words.size(); ++k) {
    const auto& axes = scheme->axes;
    if (std::find(axes.begin(), axes.end(), static_cast<int>(k)) == axes.end()) continue;
    if (now().drives[k].follows_velocity) continue;
    const bool is_rotary = machine_.axes[channel.axes[k]].rotary;
    std::array<char, 40> value{};
    std::snprintf(value.data(), value.size(), "%.13f",
                  words[k] / (meaning.inches() && !is_rotary ? inch : 1.0));
    line += " " + channel.words[k] + value.data();
  }
  return line;
}

ChannelLeft HandBench::left() {
  const channels::SituationReport situation = bench_.machine().situation(now());
  ChannelLeft left;
  const lang::AxisValues words = shown();
  for (std::size_t k = 0; k < machine_.channels[0].axes.size(); ++k) {
    const bool turns =
        now().drives[k].follows_velocity;  // a spindle: how long it does is no matter
    left.axes_M.push_back(turns ? 0.0 : now().axes[k].position);
    if (turns) continue;
    left.words.push_back(words[k]);
  }
  left.tables = bench_.machine().tables();
  left.frame = now().work_frame;
  left.mode = now().point_mode;
  lang::ActiveCodes codes = situation.meaning.codes;
  for (const lang::Group passing :
       {lang::Group::stop, lang::Group::state, lang::Group::input_output})
    codes[passing] = 0;
  for (const char letter : {'G', 'M'}) {
    for (const std::string& code : lang::names_of(codes, letter)) left.codes.push_back(code);
  }
  left.length = situation.meaning.terms->length;
  left.tool = now().tool.number;
  left.spindle_rev_per_min = now().process.spindles[0].rev_per_min;
  return left;
}

}  // namespace stanok::testing

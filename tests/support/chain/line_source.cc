#include "tests/support/chain/line_source.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace stanok::testing {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4f", value);
  return text.data();
}

const channels::ChannelConfig& channel_of(const channels::MachineConfig& machine, int id) {
  return *std::find_if(machine.channels.begin(), machine.channels.end(),
                       [id](const auto& channel) { return channel.id == id; });
}

}  // namespace

LineSource::LineSource(const channels::MachineConfig& machine, Choices& choices, int channel,
                       WordCounts counts)
    : machine_(machine),
      channel_(channel_of(machine, channel)),
      choices_(choices),
      counts_(std::move(counts)) {
  add_moves();
  add_offsets();
  add_tools();
  add_frames();
  add_modes();
}

void LineSource::add(std::string name, std::function<std::string()> line, std::string ends_with,
                     std::string within) {
  counts_.try_emplace(name, 0);
  classes_.push_back({std::move(name), std::move(line), std::move(ends_with), std::move(within)});
}

bool LineSource::is_in(const std::string& mode) const {
  return mode.empty() ||
         std::ranges::any_of(modes_, [&](const WordClass* const one) { return one->name == mode; });
}

// In the scheme with which the channel starts.
bool LineSource::has(const std::string& word) const {
  const auto& all = channel_.words;
  const auto place = static_cast<int>(std::ranges::find(all, word) - all.begin());
  const auto scheme =
      std::ranges::find(channel_.schemes, channel_.scheme, &kinematics::SchemeConfig::id);
  return std::ranges::find(scheme->axes, place) != scheme->axes.end();
}

double LineSource::shown(const std::string& word) const {
  const auto& all = channel_.words;
  return shown_[static_cast<std::size_t>(std::find(all.begin(), all.end(), word) - all.begin())];
}

const channels::AxisConfig& LineSource::axis_of(const std::string& word) const {
  const auto& all = channel_.words;
  const auto place =
      static_cast<std::size_t>(std::find(all.begin(), all.end(), word) - all.begin());
  return machine_.axes[channel_.axes[place]];
}

double LineSource::middle_of(const std::string& word) const {
  const channels::AxisConfig& axis = axis_of(word);
  const double travel = axis.limits.position_max - axis.limits.position_min;
  return std::clamp(axis.start, axis.limits.position_min + 0.3 * travel,
                    axis.limits.position_max - 0.3 * travel);
}

std::string LineSource::first() const {
  std::string line = "G21 G90 G94 F6000";
  const bool is_radius = channel_.kind == lang::ChannelKind::lathe && channel_.rules.is_linuxcnc();
  if (is_radius) line += " G7";
  if (!channel_.spindles.empty()) line += " S500";
  line += " G53 G0";
  for (const char* word : {"X", "Y", "Z"}) {
    if (!has(word)) continue;
    const bool doubles = channel_.kind == lang::ChannelKind::lathe && *word == 'X';
    line += std::string(" ") + word + number(middle_of(word) * (doubles ? 2.0 : 1.0));
  }
  return line;
}

std::string LineSource::words(const std::string& letters, double low, double high) {
  std::string text;
  for (const char letter : letters) {
    const std::string word(1, letter);
    if (!has(word)) continue;
    if (!text.empty() && choices_.chance(0.5)) continue;
    text += " " + word + number(choices_.between(low, high));
  }
  return text;
}

std::string LineSource::any_of(const std::vector<std::string>& texts) {
  return texts[choices_.below(texts.size())];
}

std::string LineSource::any_tool() {
  std::vector<std::string> numbers;
  for (const auto& tool : machine_.tables.tools) {
    if (tool.edge == 1) numbers.push_back(std::to_string(tool.number));
  }
  return any_of(numbers);
}

std::string LineSource::any_page() {
  return " P" + std::to_string(1 + choices_.below(7));
}

std::string LineSource::move(const std::string& code) {
  std::string text = "G90 " + code;
  for (const char* word : {"X", "Y", "Z"}) {
    if (has(word) && choices_.chance(0.6))
      text += std::string(" ") + word + number(shown(word) + choices_.between(-4.0, 4.0));
  }
  return text;
}

std::string LineSource::increments() {
  if (channel_.kind == lang::ChannelKind::lathe && choices_.chance(0.5)) {
    const std::string code = any_of({"G0", "G1"});
    return code + " U" + number(choices_.between(-3.0, 3.0)) + " W" +
           number(choices_.between(-3.0, 3.0));
  }
  return "G91 " + any_of({"G0", "G1"}) + words("XYZ", -4.0, 4.0);
}

void LineSource::add_moves() {
  const bool is_mill = channel_.kind == lang::ChannelKind::mill;
  add("G0 G1", [this] { return move(any_of({"G0", "G1"})); });
  add("G91", [this] { return increments(); });
  add("G53", [this] {
    if (!has("Z")) return "G90 G53 G0 X" + number(middle_of("X") * 2.0);
    return "G90 G53 G0 Z" + number(middle_of("Z") + choices_.between(-3.0, 3.0));
  });
  const std::string word = has("Z") ? "Z" : "X";
  add("stored point", [this, word] {
    return any_of({"G28.1", "G30.1", "G91 G28 " + word + "0", "G91 G30 " + word + "0"});
  });
  for (const char* rotary : {"A", "B", "C"}) {
    if (!is_mill || !has(rotary)) continue;
    add("rotary axis", [this, rotary] {
      return any_of({"G90 G0 ", "G90 G1 "}) + rotary + number(choices_.between(-25.0, 25.0));
    });
  }
  if (!is_mill) return;
  add("arc", [this] {
    return any_of({"G17 G2", "G17 G3"}) + " G91 X" + number(choices_.between(-2.0, 2.0)) + " Y" +
           number(choices_.between(1.0, 2.0)) + " R4";
  });
  add(
      "cycle",
      [this] {
        const double z = shown("Z");
        return "G90 G17 G81" + words("XY", -3.0, 3.0) + " Z" + number(z - 3.0) + " R" +
               number(z - 1.0);
      },
      "G80");
  if (channel_.probe_input >= 0)
    add("probe", [this] {
      return any_of({"G91 G38.3 Z-2 F600", "G91 G38.5 Z-1 F600", "G91 G38.3 X1 F600"});
    });
}

void LineSource::add_offsets() {
  add("G54", [this] { return any_of({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1"}); });
  add("G52", [this] { return "G52" + words("XYZ", -5.0, 5.0); });
  add("G92", [this] { return "G92" + words("XYZ", -5.0, 5.0); });
  add("G92.1", [this] { return any_of({"G92.1", "G92.2", "G92.3"}); });
  add("G10 L2", [this] { return "G10 L2" + any_page() + words("XYZ", -5.0, 5.0); });
  add("G10 L20", [this] { return "G10 L20" + any_page() + words("XYZ", -5.0, 5.0); });
  add("settable_zs", [this] {
    return "settable_zs (1, " + std::to_string(1 + choices_.below(7)) + ", " + any_of({"X", "Z"}) +
           ", " + number(choices_.between(-5.0, 5.0)) + ");";
  });
  if (channel_.kind != lang::ChannelKind::mill || channel_.rules.is_fanuc()) return;
  add("G10 L2 R",
      [this] { return "G10 L2" + any_page() + " R" + number(choices_.between(-20.0, 20.0)); });
}

std::string LineSource::row_of_tool(const std::string& code, double low, double high) {
  const bool is_lathe = channel_.kind == lang::ChannelKind::lathe;
  return "G10 " + code + " P" + any_tool() + words(is_lathe ? "XZ" : "Z", low, high);
}

void LineSource::add_tools() {
  const bool is_lathe = channel_.kind == lang::ChannelKind::lathe;
  add("T", [this, is_lathe] {
    if (is_lathe) return "T0" + any_tool() + any_of({"01", "01", "00"});
    return "T" + any_tool() + " M6";
  });
  add("settable_tool", [this] {
    return "settable_tool (" + any_tool() + ", 1, \"" +
           any_of({"length", "length_x", "length_y", "wear_length", "radius"}) + "\", " +
           number(choices_.between(0.1, 9.0)) + ");";
  });
  if (!channel_.rules.is_fanuc()) add_rows_of_tools();
  if (!is_lathe) add_lengths();
}

void LineSource::add_rows_of_tools() {
  add("G10 L1", [this] { return row_of_tool("L1", 1.0, 60.0); });
  add("G10 L10", [this] { return row_of_tool("L10", -9.0, 9.0); });
  add("G10 L11", [this] { return row_of_tool("L11", -9.0, 9.0); });
}

void LineSource::add_lengths() {
  add("G43", [this] { return "G43 H" + any_tool(); });
  add("G43 H0", [this] { return any_of({"G43 H0", "G44 H0"}); });
  add("G44", [this] { return "G44 H" + any_tool(); });
  add("G43.1", [this] { return "G43.1 Z" + number(choices_.between(-5.0, 5.0)); });
  add("G43.2", [this] { return "G43.2 H" + any_tool(); });
  add("G49", [] { return std::string("G49"); });
}

void LineSource::add_frames() {
  if (channel_.kind == lang::ChannelKind::lathe) {
    if (!has("C")) return;
    // Where the spindle comes to rest is a matter of time.
    add(
        "C axis",
        [this] {
          then_ = "G90 G0 C" + number(choices_.between(-25.0, 25.0));
          return std::string("M902");
        },
        "M903");
    add("C", [this] { return "G90 G0 C" + number(choices_.between(-25.0, 25.0)); }, "", "C axis");
    add("face", [] { return std::string("G12.1"); }, "G13.1", "C axis");
    add(
        "cylinder", [this] { return "G7.1 C" + number(choices_.between(10.0, 40.0)); }, "G13.1",
        "C axis");
    return;
  }
  if (channel_.kind != lang::ChannelKind::mill) return;
  add(
      "G68",
      [this] {
        return "G17 G68 X" + number(choices_.between(-5.0, 5.0)) + " Y" +
               number(choices_.between(-5.0, 5.0)) + " R" + number(choices_.between(-60.0, 60.0));
      },
      "G69");
  add(
      "G68.2",
      [this] {
        return "G17 G68.2 X" + number(choices_.between(-5.0, 5.0)) + " Z" +
               number(choices_.between(-5.0, 5.0)) + " I" + number(choices_.between(-30.0, 30.0)) +
               " J" + number(choices_.between(-20.0, 20.0));
      },
      "G69");
  add("G51", [this] { return "G51 X0 Y0 P" + number(choices_.between(0.5, 2.0)); }, "G50");
  add("G51.1", [this] { return "G51.1 X" + number(choices_.between(-5.0, 5.0)); }, "G50.1");
  add("G16", [] { return std::string("G17 G16"); }, "G15");
  const bool turns = (has("A") || has("B")) && has("C");
  if (turns) add("G43.4", [this] { return "G43.4 H" + any_tool(); }, "G49");
}

void LineSource::add_modes() {
  add("G20 G21", [this] { return any_of({"G20", "G21"}); });
  add("G90 G91", [this] { return any_of({"G90", "G91"}); });
  add("M7 M8 M9", [this] { return any_of({"M7", "M8", "M9"}); });
  add("G61 G64 F", [this] { return any_of({"G61", "G64", "F5000"}); });
  if (!channel_.spindles.empty()) add("M3 M5", [this] { return any_of({"S600 M3", "M4", "M5"}); });
  if (channel_.kind == lang::ChannelKind::lathe)
    add("G7 G8", [this] { return any_of({"G7", "G8"}); });
  if (channel_.kind == lang::ChannelKind::mill)
    add("G17 G18 G19", [this] { return any_of({"G17", "G18", "G19"}); });
}

// In a mode with classes of its own, these are drawn more often than all others. Of the rest, a
// quarter moves, and half of what remains is of the class that was taken least often.
const LineSource::WordClass& LineSource::drawn_class() {
  std::vector<const WordClass*> possible;
  std::vector<const WordClass*> of_mode;
  for (const WordClass& one : classes_) {
    if (!is_in(one.within)) continue;
    possible.push_back(&one);
    if (!one.within.empty()) of_mode.push_back(&one);
  }
  if (!of_mode.empty() && choices_.chance(0.75)) return *of_mode[choices_.below(of_mode.size())];
  if (choices_.chance(0.25)) return classes_[choices_.below(2)];
  if (choices_.chance(0.5)) return *possible[choices_.below(possible.size())];
  return **std::ranges::min_element(
      possible, {}, [this](const WordClass* const one) { return counts_.at(one->name); });
}

std::string LineSource::next(const lang::AxisValues& shown) {
  shown_ = shown;
  then_.clear();
  if (!next_.empty()) {
    last_ = nullptr;
    return std::exchange(next_, "");
  }
  last_is_end_ = !modes_.empty() && choices_.chance(0.15);
  if (last_is_end_) {
    last_ = modes_.back();
    return last_->ends_with;
  }
  last_ = &drawn_class();
  return last_->line();
}

void LineSource::taken() {
  if (last_ == nullptr) return;
  if (last_is_end_) return modes_.pop_back();
  next_ = then_;
  ++counts_.at(last_->name);
  if (!last_->ends_with.empty()) modes_.push_back(last_);
}

}  // namespace stanok::testing

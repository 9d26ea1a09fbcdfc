#include "tests/support/chain/random_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string_view>

#include "tests/support/chain/shop_program.h"

namespace stanok::testing {
namespace {

constexpr double reach_mm = 60.0;  // from where a program begins
constexpr double reach_deg = 80.0;

std::string text_of(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

// One program, block after block. It follows where the tip is, roughly: frames are left out.
class Writer {
 public:
  Writer(MachineKind machine, Choices& choices) : machine_(machine), choices_(choices) {}

  std::string write() {
    begin();
    const std::size_t count = 1 + choices_.below(24);
    for (std::size_t n = 0; n < count; ++n) block();
    return text_ + "M30\n" + (calls_ ? "O900\nG91 G1 X#1\nX-#1\nG90\nM99\n" : "");
  }

 private:
  [[nodiscard]] bool turns() const { return machine_ == MachineKind::lathe; }
  [[nodiscard]] bool has_rotary() const { return machine_ == MachineKind::five_axes; }

  void line(const std::string& block) { text_ += block + "\n"; }

  void begin() {
    constexpr std::array<const char*, 3> dialects{"(dialect fanuc)", "(dialect haas)",
                                                  "(dialect linuxcnc)"};
    if (choices_.chance(0.4)) line(dialects[choices_.below(dialects.size())]);
    if (turns()) line("G18 G97 S600 M3");
    if (choices_.chance(0.1)) line("G20");
    if (choices_.chance(0.6)) path_mode();
    if (has_rotary() && choices_.chance(0.6)) line("G43.4 H1");
    line("G1 F" + text_of(choices_.between(200.0, 9000.0), 1));
  }

  void path_mode() {
    constexpr std::array<const char*, 6> modes{"G61",        "G61.1",          "G64",
                                               "G64 P0.001", "G64 P0.1 Q0.01", "G64 P1"};
    line(modes[choices_.below(modes.size())]);
  }

  // How far a move goes: ordinary, short, tiny, hardly at all, not at all; either way.
  double step() {
    constexpr std::array<double, 9> exponents{1.5, 1.0, 0.5, -1.0, -2.0, -3.0, -6.0, -9.5, -12.0};
    if (choices_.chance(0.1)) return 0.0;
    const double size = std::pow(10.0, exponents[choices_.below(exponents.size())]);
    return (choices_.chance(0.5) ? 1.0 : -1.0) * size * choices_.between(0.1, 1.0);
  }

  // A number as programs write it: few digits, all digits, computed.
  std::string number(double value) {
    switch (choices_.below(5)) {
      case 0:
        return text_of(value, 15);
      case 1:
        return "[" + text_of(3.0 * value, 12) + "/3]";
      case 2:
        return text_of(value, 4);
      default:
        return text_of(value, 3);
    }
  }

  void block() {
    switch (choices_.below(20)) {
      case 0:
      case 1:
        return arc();
      case 2:
        return full_circle();
      case 3:
        return mode();
      case 4:
        return feed_mode();
      case 5:
        return spline();
      case 6:
        return cycle();
      case 7:
        return law();
      case 8:
        return line("G4 P" + text_of(choices_.between(0.0, 0.02), 4));
      case 9:
        return repeated();
      case 10:
        return sum();
      case 11:
        return frame();
      case 12:
        return turns() ? thread() : compensated();
      case 13:
        return output();
      case 14:
      case 15:
        return macro();
      default:
        return straight();
    }
  }

  // The feed of a block in G93 belongs to it; else it stays.
  std::string feed_word() {
    if (inverse_time_) return " F" + text_of(choices_.between(20.0, 6000.0), 2);
    if (choices_.chance(0.2)) {
      const double feed =
          per_revolution_ ? choices_.between(0.02, 1.0) : choices_.between(60.0, 20000.0);
      return " F" + text_of(feed, 3);
    }
    return "";
  }

  [[nodiscard]] std::size_t axis_count() const { return turns() ? 2 : has_rotary() ? 5 : 3; }

  std::string axis_words() {
    constexpr std::array<const char*, 5> mill{"X", "Y", "Z", "B", "C"};
    constexpr std::array<const char*, 2> lathe{"X", "Z"};
    std::string words;
    for (std::size_t k = 0; k < axis_count(); ++k) {
      if (!choices_.chance(k < 2 ? 0.7 : 0.4)) continue;
      const bool rotary = k > 2;
      const double limit = rotary ? reach_deg : reach_mm;
      double by = step();
      if (std::abs(at_[k] + by) > limit) by = -by;
      at_[k] += by;
      words +=
          std::string(" ") + (turns() ? lathe[k] : mill[k]) + number(incremental_ ? by : at_[k]);
    }
    return words;
  }

  void straight() {
    const bool rapid = choices_.chance(0.15);
    const std::string words = axis_words();
    if (words.empty()) return;
    line((rapid ? "G0" : "G1") + words + (rapid ? "" : feed_word()));
  }

  void repeated() {
    if (incremental_) return;
    const char* const second = turns() ? " Z" : " Y";
    const std::string words = " X" + text_of(at_[0], 6) + second + text_of(at_[1], 6);
    at_[0] = std::round(at_[0] * 1e6) / 1e6;
    at_[1] = std::round(at_[1] * 1e6) / 1e6;
    for (int n = 0; n < 3; ++n) line("G1" + words + feed_word());
  }

  // Steps that are added up with their rounding, and the whole number behind them.
  void sum() {
    if (incremental_) return;
    line("#1=" + text_of(at_[0], 3));
    line("O100 repeat [10]");
    line("#1=[#1+0.1]");
    line("G1 X#1" + feed_word());
    line("O100 endrepeat");
    at_[0] = std::round(at_[0] * 1e3) / 1e3 + 1.0;
    line("G1 X" + text_of(at_[0], 3) + feed_word());
  }

  // X and Y, or, where G18 is active, X and Z; Z is the first axis of that plane.
  std::string end_in_plane(double first, double second) {
    return turns() ? " Z" + number(second) + " X" + number(first)
                   : " X" + number(first) + " Y" + number(second);
  }

  void arc() {
    const double radius = std::abs(step()) + (choices_.chance(0.8) ? 0.01 : 0.0);
    const double from = choices_.between(-std::numbers::pi, std::numbers::pi);
    const double sweep = choices_.between(-6.2, 6.2);
    const double along = -radius * std::cos(from);
    const double across = -radius * std::sin(from);
    const double by = along + radius * std::cos(from + sweep);
    const double aside = across + radius * std::sin(from + sweep);
    if (std::abs(at_[0] + by) > reach_mm || std::abs(at_[1] + aside) > reach_mm) return;
    at_[0] += by;
    at_[1] += aside;
    std::string words = end_in_plane(incremental_ ? by : at_[0], incremental_ ? aside : at_[1]);
    if (choices_.chance(0.25)) {
      words += " R" + number(std::abs(sweep) > std::numbers::pi ? -radius : radius);
    } else {
      words += " I" + number(along) + (turns() ? " K" : " J") + number(across);
    }
    if (!turns() && choices_.chance(0.2)) {
      const double rise = step();
      if (std::abs(at_[2] + rise) < reach_mm) {
        at_[2] += rise;
        words += " Z" + number(incremental_ ? rise : at_[2]);
      }
    }
    line((sweep > 0.0 ? "G3" : "G2") + words + feed_word());
  }

  // Flow, calls, polar words and pockets; all but the pocket come back to where they begin.
  void macro() {
    if (inverse_time_ || incremental_) return;
    const std::string out = number(choices_.between(-5.0, 5.0));
    const std::string label = std::to_string(10 * ++labels_);
    switch (choices_.below(turns() ? 3 : 5)) {
      case 0:
        line("#1=0\nG91\nWHILE [#1 LT 3] DO 1\nG1 X" + out + feed_word() + "\nX[0-[" + out + "]]");
        return line("#1=#1+1\nEND 1\nG90");
      case 1:
        line("#2=0\nN" + label + " #2=#2+1\nG91 G1 X" + out + feed_word() + "\nX[0-[" + out + "]]");
        return line("G90\nIF [#2 LT 3] GOTO " + label);
      case 2:
        calls_ = true;
        return line("G65 P900 A" + out + (choices_.chance(0.3) ? " L2" : ""));
      case 3:
        return polar();
      default:
        at_[2] -= choices_.between(0.01, 2.0);
        return line("G1" + feed_word() + "\n" + (choices_.chance(0.5) ? "G12" : "G13") + " I" +
                    number(choices_.between(0.5, 3.0)) + " K3.5 Q0.7 D0 Z" + number(at_[2]));
    }
  }

  void polar() {
    const double radius = choices_.between(0.5, 0.5 * reach_mm);
    const double angle_deg = choices_.between(-180.0, 180.0);
    line("G16 G1 X" + text_of(radius, 4) + " Y" + text_of(angle_deg, 4) + feed_word());
    line("Y" + text_of(angle_deg + 30.0, 4));
    line("G15");
    line("G1" + axis_pair());
  }

  void full_circle() {
    const double radius = std::abs(step()) * (choices_.chance(0.1) ? 1e-6 : 1.0);
    if (radius > 0.5 * reach_mm) return;
    line(std::string(choices_.chance(0.5) ? "G2" : "G3") + " I" + number(radius) +
         (choices_.chance(0.2) ? " P2" : "") + feed_word());
  }

  void spline() {
    if (turns() || inverse_time_ || incremental_) return;
    const double a = step();
    const double b = step();
    const double by = std::clamp(at_[0] + a + b, -reach_mm, reach_mm) - at_[0];
    at_[0] += by;
    at_[1] = std::clamp(at_[1] + b, -reach_mm, reach_mm);
    line("G5 I" + number(a) + " J" + number(b) + " P" + number(-b) + " Q" + number(a) + " X" +
         number(at_[0]) + " Y" + number(at_[1]) + feed_word());
  }

  void cycle() {
    if (turns() || inverse_time_ || incremental_) return;
    constexpr std::array<const char*, 4> cycles{"G81", "G82 P0.01", "G83 Q1.5", "G73 Q0.7"};
    const double top = at_[2] + std::abs(step());
    line(std::string(choices_.chance(0.5) ? "G98 " : "G99 ") + cycles[choices_.below(4)] +
         axis_pair() + " Z" + number(at_[2] - std::abs(step())) + " R" + number(top));
    if (choices_.chance(0.5)) line(axis_pair());
    line("G80");
    line("G0 Z" + text_of(at_[2], 6));
    at_[2] = std::round(at_[2] * 1e6) / 1e6;
  }

  std::string axis_pair() {
    for (const std::size_t k : {0U, 1U}) {
      const double by = step();
      at_[k] += std::abs(at_[k] + by) > reach_mm ? -by : by;
    }
    return " X" + number(at_[0]) + " Y" + number(at_[1]);
  }

  void law() {
    if (inverse_time_) return;
    const std::string words = axis_words();
    if (words.empty()) return;
    const double dl = choices_.between(0.05, 2.0);
    switch (choices_.below(3)) {
      case 0:
        return line("G1" + words + " S_n=" + text_of(choices_.between(100.0, 2000.0), 2) +
                    " dS=" + text_of(choices_.between(-20.0, 50.0), 3) + " dl=" + text_of(dl, 3));
      case 1:
        return line("G1" + words + " Smin=" + text_of(choices_.between(100.0, 2000.0), 2) +
                    " dS=" + text_of(choices_.between(1.0, 50.0), 3) + " dl=" + text_of(dl, 3) +
                    " n_s=" + std::to_string(1 + choices_.below(6)));
      default:
        return line("G1" + words + " L_A=" + text_of(choices_.between(0.01, 1.0), 3) +
                    " L_B=" + text_of(choices_.between(0.5, 5.0), 3));
    }
  }

  // A pass of a contour beside which the tool's centre runs.
  void compensated() {
    if (incremental_ || inverse_time_) return;
    line(std::string(choices_.chance(0.5) ? "G41.1" : "G42.1") + " D" +
         text_of(choices_.between(0.1, 4.0), 3));
    const std::size_t count = 1 + choices_.below(4);
    for (std::size_t n = 0; n < count; ++n) line("G1" + axis_pair() + feed_word());
    line("G40");
    line("G1" + axis_pair() + feed_word());
  }

  void thread() {
    if (inverse_time_ || incremental_) return;
    const double by = choices_.between(2.0, 12.0) * (choices_.chance(0.5) ? 1.0 : -1.0);
    at_[1] += std::abs(at_[1] + by) > reach_mm ? -by : by;
    line("G33 Z" + number(at_[1]) + " K" + text_of(choices_.between(0.25, 2.0), 3));
  }

  void output() {
    line((choices_.chance(0.5) ? "M62 P" : "M64 P") + std::to_string(choices_.below(4)));
  }

  void mode() {
    switch (choices_.below(5)) {
      case 0:
        return path_mode();
      case 1:
        incremental_ = !incremental_;
        return line(incremental_ ? "G91" : "G90");
      case 2:
        return line(choices_.chance(0.5) ? "M49" : "M48");
      case 3:
        if (!has_rotary()) return;
        return line(choices_.chance(0.5) ? "G49" : "G43.4 H1");
      default:
        return line("G9 G1 X" + text_of(incremental_ ? 0.0 : at_[0], 9) + feed_word());
    }
  }

  void feed_mode() {
    const std::size_t which = choices_.below(turns() ? 3 : 2);
    inverse_time_ = which == 0;
    per_revolution_ = which == 2;
    if (inverse_time_) return line("G93");
    line(per_revolution_ ? "G95 F0.3" : "G94 F" + text_of(choices_.between(200.0, 9000.0), 0));
  }

  void frame() {
    if (turns()) return;
    constexpr std::array<const char*, 7> frames{"G55",     "G54", "G52 X1.5 Y-2", "G52 X0 Y0",
                                                "G68 R10", "G69", "G92.1"};
    line(frames[choices_.below(frames.size())]);
  }

  MachineKind machine_;
  Choices& choices_;
  std::string text_;
  std::array<double, 5> at_{};  // X Y Z B C, X Z on a lathe
  bool incremental_ = false;
  bool inverse_time_ = false;
  bool per_revolution_ = false;
  bool calls_ = false;
  int labels_ = 0;
};

}  // namespace

std::size_t Choices::below(std::size_t count) {
  const auto chosen = static_cast<std::size_t>(between(0.0, static_cast<double>(count)));
  return std::min(chosen, count - 1);
}

ChoicesOfBytes::ChoicesOfBytes(const std::uint8_t* bytes, std::size_t size)
    : bytes_(bytes),
      left_(size),
      then_(std::hash<std::string_view>{}({reinterpret_cast<const char*>(bytes), size})) {}

double ChoicesOfBytes::between(double low, double high) {
  if (left_ == 0) return then_.between(low, high);
  const double part = static_cast<double>(*bytes_++) / 256.0;
  --left_;
  return low + (high - low) * part;
}

std::string random_program(MachineKind machine, Choices& choices) {
  if (machine != MachineKind::five_axes && choices.chance(0.35))
    return random_shop_program(machine, choices);
  return Writer(machine, choices).write();
}

}  // namespace stanok::testing

#include "tests/support/chain/shop_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace stanok::testing {
namespace {

std::string text_of(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

class ShopWriter {
 public:
  ShopWriter(MachineKind machine, Choices& choices)
      : turns_(machine == MachineKind::lathe), haas_(choices.chance(0.5)), choices_(choices) {}

  std::string write() {
    line(std::string(haas_ ? "(dialect haas" : "(dialect fanuc") + (turns_ ? " A)" : ")"));
    line("O1000 (SHOP)");
    turns_ ? begin_turning() : begin_milling();
    const std::size_t count = 1 + choices_.below(14);
    for (std::size_t n = 0; n < count; ++n) {
      if (choices_.chance(0.05)) text_ += choices_.chance(0.5) ? "/" : "/2 ";
      turns_ ? turning() : milling();
    }
    line("M30");
    for (const std::string& subprogram : subprograms_) text_ += subprogram;
    return text_;
  }

 private:
  void line(const std::string& block) { text_ += block + "\n"; }

  // With a point, without, with many digits, computed, from a variable.
  std::string number(double value) {
    switch (choices_.below(6)) {
      case 0:
        return text_of(value, 0);
      case 1:
        return "[" + text_of(value, 3) + "*1.]";
      case 2:
        return "-[" + text_of(-value, 2) + "]";
      case 3:
        return text_of(value, 6);
      default:
        return text_of(value, 1) + (choices_.chance(0.2) ? "00" : "");
    }
  }

  std::string word(const char* letter, double low, double high) {
    return std::string(" ") + letter + number(choices_.between(low, high));
  }

  // Some of the words, so that others are missing or stay from before.
  std::string maybe(double probability, const std::string& words) {
    return choices_.chance(probability) ? words : "";
  }

  template <std::size_t n>
  std::string one_of(const std::array<const char*, n>& texts) {
    return texts[choices_.below(n)];
  }

  std::string place() { return word("X", -60.0, 60.0) + maybe(0.7, word("Y", -60.0, 60.0)); }

  std::string label() { return std::to_string(10 * ++labels_); }

  void begin_milling() {
    line("G21 G17 G90 G40 G80 G94" + maybe(0.5, " G49"));
    line("T1 M6");
    line("S1200 M3");
    line("G0 G54" + place());
    line(maybe(0.5, "G43 H1") + " Z40.");
    line("G1 F" + number(choices_.between(100.0, 4000.0)) + " Z30.");
  }

  void milling() {
    switch (choices_.below(12)) {
      case 0:
      case 1:
      case 2:
        return drill();
      case 3:
        return corners();
      case 4:
        return contour();
      case 5:
        return flow();
      case 6:
        return call();
      case 7:
        return modal_call();
      case 8:
        return offsets();
      case 9:
        return pattern();
      case 10:
        return reference();
      default:
        return line(one_of<2>({"G0", "G1"}) + place() + maybe(0.2, word("Z", 0.0, 60.0)));
    }
  }

  std::string cycle() {
    constexpr std::array<const char*, 10> cycles{"G81", "G82", "G83", "G73", "G84",
                                                 "G85", "G86", "G89", "G76", "G74"};
    const std::string code = one_of(cycles);
    std::string words = maybe(0.4, one_of<2>({"G98 ", "G99 "})) + code;
    words += maybe(0.9, word("Z", -20.0, 5.0)) + maybe(0.9, word("R", 5.0, 25.0));
    words += maybe(0.6, word("Q", 0.3, 6.0)) +
             maybe(0.3, " P" + text_of(choices_.between(1.0, 90.0), 0));
    if (haas_) words += maybe(0.2, " I4. J1. K1.");
    return words + maybe(0.5, " F" + text_of(choices_.between(50.0, 900.0), 1));
  }

  void drill() {
    const bool repeats = choices_.chance(0.2);
    if (repeats) line("G91");
    line(
        cycle() + maybe(0.6, place()) +
        (repeats ? std::string(haas_ ? " L" : " K") + text_of(choices_.between(0.0, 5.0), 0) : ""));
    if (repeats) line("G90");
    const std::size_t holes = choices_.below(3);
    for (std::size_t n = 0; n < holes; ++n) line(place());
    line(one_of<3>({"G80", "G80 G0 Z40.", "G0 Z40."}));
  }

  void pattern() {
    if (!haas_) return drill();
    line(cycle() + maybe(0.8, " L0"));
    line(one_of<3>({"G70", "G71", "G72"}) + word("I", 1.0, 20.0) +
         maybe(0.8, word("J", 0.0, 90.0)) + maybe(0.5, word("K", -90.0, 90.0)) + " L" +
         std::to_string(1 + choices_.below(6)));
    line("G80");
  }

  void corners() {
    line("G1" + place());
    const std::size_t count = 1 + choices_.below(3);
    for (std::size_t n = 0; n < count; ++n) {
      line("G1" + place() + "," + one_of<2>({"C", "R"}) + text_of(choices_.between(0.0, 4.0), 2));
    }
    line("G1" + place());
  }

  void contour() {
    line(one_of<2>({"G41", "G42"}) + maybe(0.8, " D" + std::to_string(1 + choices_.below(3))) +
         " G1" + place());
    const std::size_t count = choices_.below(4);
    for (std::size_t n = 0; n < count; ++n) {
      line(choices_.chance(0.7) ? "G1" + place()
                                : one_of<2>({"G2", "G3"}) + place() + word("R", 20.0, 200.0));
    }
    line("G40 G1" + place());
  }

  std::string there_and_back(const std::string& way) {
    if (turns_) return "G1 U" + way + "\nU-[" + way + "]";
    return "G91 G1 X" + way + "\nX-[" + way + "]\nG90";
  }

  void flow() {
    const std::string end = label();
    const std::string way = text_of(choices_.between(-6.0, 6.0), 2);
    switch (choices_.below(5)) {
      case 0:
        return line("#1=0\nWHILE[#1LT" + std::to_string(choices_.below(4)) + "]DO1\n" +
                    there_and_back(way) + "\n#1=#1+1\nEND1");
      case 1:
        return line("#2=0\nN" + end + " #2=#2+1\n" + there_and_back(way) + "\nIF[#2LT3]GOTO" + end);
      case 2:
        return line("#500=" + way + "\nIF[#500 GT 0]THEN #501=1\nIF[#501 EQ #0]GOTO" + end +
                    "\nG1 X#500\nN" + end);
      case 3:
        return line("#100=#5001\n#101=" + number(choices_.between(-4.0, 4.0)) +
                    "\nG1 X[#100+#101]\nX#100");
      default:
        return line("#33=#4001+#4109*0\nG#33 X" + way);
    }
  }

  // Subprograms stand behind M30.
  std::string subprogram(const std::string& body) {
    const std::string number = std::to_string(9000 + subprograms_.size());
    subprograms_.push_back("O" + number + "\n" + body + "\nM99\n");
    return number;
  }

  void call() {
    const std::string way = turns_ ? "G1 U2. W-1.\nU-2. W1." : "G91 G1 X2. Y1.\nX-2. Y-1.\nG90";
    switch (choices_.below(4)) {
      case 0:
        return line("M98 P" + subprogram(way) + maybe(0.5, " L3"));
      case 1:
        return line("G65 P" + subprogram(there_and_back("#1")) + " A" +
                    number(choices_.between(-5.0, 5.0)) + maybe(0.3, " L2"));
      case 2: {
        const std::string inner = subprogram(way);
        return line("M98 P" + subprogram("M98 P" + inner + "\nIF[#0EQ#1]GOTO5\nN5"));
      }
      default:
        if (!haas_) return line("M98 P2" + subprogram(way));
        inner_ = label();
        subprograms_.push_back("N" + inner_ + " " + way + "\nM99\n");
        return line("M97 P" + inner_ + maybe(0.4, " L2"));
    }
  }

  void modal_call() {
    line("G66 P" + subprogram("G91 G1 Z-[#26]\nZ#26\nG90") + " Z" +
         text_of(choices_.between(0.1, 5.0), 1));
    line("G0" + place());
    line("G0" + place());
    line("G67");
  }

  void offsets() {
    constexpr std::array<const char*, 12> codes{"G52 X2. Y-3.",
                                                "G52 X0 Y0",
                                                "G68 X0 Y0 R30.",
                                                "G69",
                                                "G51 X0 Y0 Z0 P2.",
                                                "G50",
                                                "G51.1 X0",
                                                "G50.1 X0",
                                                "G55",
                                                "G54.1 P3",
                                                "G10 L2 P2 X5. Y-4. Z1.",
                                                "G10 L12 P1 R2.5"};
    line(one_of(codes));
  }

  void reference() {
    constexpr std::array<const char*, 6> codes{"G91 G28 Z0\nG90", "G28 G91 Z0.\nG90",
                                               "G53 G0 Z100.",    "G0 G53 Z100.",
                                               "G91 G30 Z0\nG90", "G4 P20"};
    line(one_of(codes));
  }

  void begin_turning() {
    line("G21 G18 G40 G99");
    line("T0" + std::to_string(choices_.below(3)) + "0" + std::to_string(choices_.below(3)));
    line("G50 S2000");
    line(one_of<2>({"G97 S600 M3", "G96 S120 M3"}));
    line("G0 X84. Z4.");
    line("G1 F" + text_of(choices_.between(0.05, 0.4), 2) + " X82.");
  }

  void turning() {
    switch (choices_.below(11)) {
      case 0:
      case 1:
        return single_cycle();
      case 2:
        return rough();
      case 3:
        return grooves();
      case 4:
        return thread();
      case 5:
        return flow();
      case 6:
        return call();
      case 7:
        line("G0 X84. Z4.");
        return line("G32" + word("Z", -30.0, 0.0) + word("F", 0.5, 2.0));
      case 8:
        return line(one_of<6>({"G98 G1 U1. F150.\nG99 F0.2", "G99 F0.2", "G97 S500", "G96 S100",
                               "G50 S1500", "T0101"}));
      case 9:
        return nose();
      default:
        return line(one_of<2>({"G0", "G1"}) + word(one_of<2>({"X", "U"}).c_str(), 10.0, 60.0) +
                    maybe(0.7, word("Z", -40.0, 5.0)));
    }
  }

  void single_cycle() {
    line("G0 X84. Z4.");
    line(one_of<3>({"G90", "G94", "G92"}) + word("X", 40.0, 80.0) + word("Z", -30.0, -1.0) +
         maybe(0.3, word("R", -2.0, 2.0)) + maybe(0.6, word("F", 0.1, 1.5)));
    line(word("X", 30.0, 80.0));
    line("G0 X84. Z4.");
  }

  void rough() {
    const std::string first = label();
    const std::string last = label();
    const std::string code = one_of<3>({"G71", "G72", "G73"});
    const std::string from_to = " P" + first + " Q" + last;
    line("G0 X84. Z4.");
    if (haas_ && choices_.chance(0.7)) {
      const std::string depth =
          code == "G73" ? " I4. K2. D3" : " D" + text_of(choices_.between(0.5, 3.0), 2);
      line(code + from_to + " U0.4 W0.1" + depth + maybe(0.7, " F0.2"));
    } else {
      line(code + (code == "G73" ? " U4. W2. R3"
                                 : (code == "G71" ? " U" : " W") + std::string("2. R0.5")));
      line(code + from_to + maybe(0.8, " U0.4") + maybe(0.8, " W0.1") + " F0.2");
    }
    const bool facing = code == "G72";
    line("N" + first + (facing ? " G0 Z-30." : " G0 X30.") + maybe(0.3, facing ? " G41" : " G42"));
    const double step = choices_.between(4.0, 12.0);
    for (int n = 1; n <= 2; ++n) {
      const std::string x =
          " X" + text_of(30.0 + n * step * (choices_.chance(0.1) ? -1.0 : 1.0), 2);
      const std::string z = " Z" + text_of(-n * step, 2);
      line(facing ? "G1" + x + " Z" + text_of(-30.0 + n * step, 2)
                  : one_of<2>({"G1", "G1"}) + x + z + maybe(0.3, ",R1."));
    }
    line("N" + last + (facing ? " G1 X82. Z2." : " G1 X82.") + maybe(0.3, " G40"));
    if (choices_.chance(0.6)) line("G70" + from_to + maybe(0.5, " F0.1"));
  }

  void grooves() {
    line("G0 X84. Z-5.");
    const std::string code = one_of<2>({"G74", "G75"});
    if (!haas_) line(code + " R0.5");
    line(code + word("X", 60.0, 84.0) + word("Z", -25.0, -5.0) +
         (haas_ ? maybe(0.8, word("I", 0.5, 4.0)) + maybe(0.8, word("K", 0.5, 4.0))
                : maybe(0.8, " P2000") + maybe(0.8, " Q3000")) +
         maybe(0.6, " F0.1"));
    line("G0 X84. Z4.");
  }

  void thread() {
    line("G0 X84. Z4.");
    if (haas_) {
      line("G76" + word("X", 70.0, 82.0) + word("Z", -30.0, -5.0) + " K1.2" + " D" +
           text_of(choices_.between(0.1, 0.6), 2) + maybe(0.4, " A60") + " F1.5");
    } else {
      line("G76 P010060 Q" + text_of(choices_.between(20.0, 200.0), 0) + " R0.05");
      line("G76" + word("X", 70.0, 82.0) + word("Z", -30.0, -5.0) + " P1200 Q" +
           text_of(choices_.between(100.0, 600.0), 0) + " F1.5");
    }
  }

  void nose() {
    line("G0 X40. Z4.");
    line(one_of<2>({"G41", "G42"}) + " G1 X36. Z2.");
    line("G1 Z" + text_of(choices_.between(-30.0, -2.0), 2));
    line("G1 X60.");
    line("G40 G0 X84. Z4." + maybe(0.3, " T0100"));
  }

  bool turns_;
  bool haas_;
  Choices& choices_;
  std::string text_;
  std::string inner_;
  std::vector<std::string> subprograms_;
  int labels_ = 0;
};

}  // namespace

std::string random_shop_program(MachineKind machine, Choices& choices) {
  return ShopWriter(machine, choices).write();
}

}  // namespace stanok::testing

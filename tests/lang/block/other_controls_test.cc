// What a control that a code is known from understands differently is refused, and its neighbours
// that mean the same everywhere are not. Sources of the other meanings:
// lang/block/other_controls.h.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

struct Meaning {
  ChannelKind kind = ChannelKind::mill;
  const char* text = "";
  const char* code = "";  // "" where the text runs
};

class OtherControls : public ProgramTest, public ::testing::WithParamInterface<Meaning> {};

TEST_P(OtherControls, NeverGiveABlockAnotherMeaning) {
  channel.kind = GetParam().kind;
  channel.spindles_with_position = {1};
  if (channel.kind == ChannelKind::lathe)
    channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}, {"C", true, 360.0, -1}};
  tables.tools[4] = {4, {}, 1.0, 0, 0.0};
  EXPECT_EQ(error_code(GetParam().text + std::string("\nM30\n")), GetParam().code)
      << GetParam().text << "\n"
      << to_text(error);
}

constexpr auto mill = ChannelKind::mill;
constexpr auto lathe = ChannelKind::lathe;
constexpr auto grind = ChannelKind::grind;

INSTANTIATE_TEST_SUITE_P(
    Codes, OtherControls,
    ::testing::Values(
        // Speed limits of lathes.
        Meaning{lathe, "G50 S1500", ""}, Meaning{lathe, "G92 S1500", ""},
        Meaning{lathe, "G50 S2=1500", "E4016"}, Meaning{lathe, "G50 S-1", "E4022"},
        Meaning{mill, "G50 S1500", "E4016"}, Meaning{grind, "G50 S1500", "E4016"},
        Meaning{mill, "G92 S1500", "E4016"}, Meaning{mill, "G92 X0 S1500", "E4016"},
        Meaning{mill, "G50", ""}, Meaning{mill, "G92 X0", ""},
        // Cycles and feeds of code systems A and C.
        Meaning{lathe, "G90 X48 Z-30 F0.2", "E4016"}, Meaning{lathe, "G90 U-2 W-30", "E4016"},
        Meaning{lathe, "G1 X50 F1\nG90 X48 Z-30", "E4016"},
        Meaning{lathe, "G91 X1\nG90 X48 Z-30", ""}, Meaning{lathe, "G90 G0 X48", ""},
        Meaning{lathe, "G90 G4 X1", ""}, Meaning{mill, "G90 X48 Y-30", ""},
        Meaning{lathe, "G94 X20 Z-1", "E4016"}, Meaning{lathe, "G94 G1 X20 F100", ""},
        Meaning{lathe, "G21 X20 Z-1", "E4016"}, Meaning{lathe, "G21 G0 X20", ""},
        Meaning{lathe, "G92 X20 Z-9 F1", "E4016"}, Meaning{lathe, "G92 X20 Z-9", ""},
        Meaning{lathe, "G98", "E4016"}, Meaning{lathe, "G99", "E4016"}, Meaning{mill, "G98", ""},
        Meaning{grind, "G99", ""},
        // Codes that take axis words elsewhere.
        Meaning{mill, "G92.1 X0 Y0", "E4016"}, Meaning{mill, "G92.1", ""},
        Meaning{mill, "G30.1 X0", "E4016"}, Meaning{mill, "G28.1 X0", "E4016"},
        Meaning{mill, "G60 X5", "E4016"}, Meaning{mill, "G60 G0 X5", ""},
        // Numbers in thousandths.
        Meaning{mill, "G51 X0 P500", "E4016"}, Meaning{mill, "G51 X0 P2", ""},
        Meaning{mill, "G51 X0 I500 J500", "E4016"},
        Meaning{lathe, "S100 M3\nG33 Z-5 F1 Q180000", "E4016"},
        Meaning{lathe, "S100 M3\nG33 Z-5 F1 Q180", ""},
        Meaning{lathe, "G76 P020060 Q100 R0.1", "E4016"},
        Meaning{lathe, "G76 P020060 Q0.1 R0.1", ""},
        Meaning{lathe, "S100 M3\nG0 X30 Z5\nG76 X20 Z-20 P1300 Q0.4 F1.5", "E4016"},
        Meaning{lathe, "S100 M3\nG0 X30 Z5\nG76 X20 Z-20 P1.3 Q400 F1.5", "E4016"},
        Meaning{lathe, "S100 M3\nG0 X30 Z5\nG76 X20 Z-20 P1.3 Q0.4 F1.5", ""},
        Meaning{lathe, "S100 M3\nG0 X30 Z5\nG76 P10060 Q1.5\nG76 X20 Z-20 P1.3 Q0.4 F1.5", "E4008"},
        // Letters with two uses.
        Meaning{mill, "G10 L10 P4 R50", "E4016"}, Meaning{mill, "G10 L11 P4 R50", "E4016"},
        Meaning{mill, "G10 L10 P4 Z5 R5", ""}, Meaning{mill, "G10 L1 P4 R5", ""},
        Meaning{mill, "S1000 M3\nG84 Z-9 R1 F1000 K3", "E4016"},
        Meaning{mill, "S1000 M3\nG84 Z-9 R1 F1250 K1.25", ""},
        Meaning{mill, "S1000 M3\nG84 Z-9 R1 F1000 K0", "E4016"},
        Meaning{mill, "S1000 M3\nF300\nG84 Z-9 R1 K1.25", ""}));

// A word that a form of a cycle has no use for was left out without a word.
INSTANTIATE_TEST_SUITE_P(
    UnusedWords, OtherControls,
    ::testing::Values(Meaning{mill, "S100 M3\nG76 Z-9 R1 Q0.2 F60 I1", "E4003"},
                      Meaning{lathe, "G76 P020060 Q0.1 R0.1 I1", "E4003"},
                      Meaning{lathe, "S100 M3\nG76 Z-9 P1.5 I-1 J0.3 K0.9 F1.5", "E4003"},
                      Meaning{lathe, "G71 U2 R1 W1", "E4003"},
                      Meaning{lathe, "G72 W2 R1 U1", "E4003"},
                      Meaning{lathe, "G71 U2 R1\nG71 P1 Q2 R1", "E4003"}));

TEST_F(OtherControls, WordsOfMillisecondsInCyclesAreWarnedOf) {
  for (const char* text : {"G82 Z-1 R1 P500 F60", "G89 Z-1 R1 P500 F60", "G4 X500", "G4 U500"}) {
    channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
    EXPECT_TRUE(load_errors(text + std::string("\nM30\n")).empty()) << text;
    ASSERT_EQ(warnings.size(), 1u) << text;
    EXPECT_EQ(warnings[0].code, "W410") << text;
  }
  EXPECT_TRUE(load_errors("G82 Z-1 R1 P500.0 F60\nM30\n").empty());
  EXPECT_TRUE(warnings.empty());
}

}  // namespace
}  // namespace stanok::lang::testing

// Wrong feed laws: every kind of fault is found where it stands, with address, value and remedy.
#include <gmock/gmock.h>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

using ::testing::HasSubstr;

struct WrongValue {
  const char* name;
  const char* text;  // last block
  const char* code;
  const char* word;     // where the error points to
  const char* message;  // a part of it: address and value
  const char* remedy;
};

void PrintTo(const WrongValue& wrong, std::ostream* stream) {
  *stream << wrong.text;
}

class WrongFeedLaws : public ProgramTest, public ::testing::WithParamInterface<WrongValue> {};

TEST_P(WrongFeedLaws, AreRefusedWithAddressValueAndRemedy) {
  const WrongValue& wrong = GetParam();
  channel.finest_resolution_mm = 0.001;
  const std::string text = wrong.text;
  EXPECT_EQ(error_code(text + "\nM30\n"), wrong.code) << to_text(error);
  EXPECT_THAT(error.message, HasSubstr(wrong.message));
  ASSERT_FALSE(error.help.empty()) << error.message;
  EXPECT_THAT(error.help.front(), HasSubstr(wrong.remedy));
  const std::size_t line_start = text.rfind('\n') + 1;
  const std::size_t word = text.find(wrong.word, line_start);
  EXPECT_EQ(error.place.column, static_cast<int>(word - line_start) + 1) << error.message;
}

INSTANTIATE_TEST_SUITE_P(
    Programs, WrongFeedLaws,
    ::testing::Values(
        WrongValue{"MissingStep", "G1 X1 S_n=60 dl=1", "E4330", "S_n", "`S_n` = 60 needs `dS`",
                   "`S_n dS dl` or `S_n S_k dS`"},
        WrongValue{"MissingLength", "L_A=0.4", "E4330", "L_A", "`L_A` = 0.4 needs `L_B`",
                   "`L_A L_B`"},
        WrongValue{"MissingOfComputedValue", "num first = 60;\nG1 X1 S_n=first dl=1", "E4330",
                   "S_n", "with `S_n` needs `dS`", "`S_n dS dl`"},
        WrongValue{"OneTooMany", "Smin=1 Smax=3 n_s=4 dS=0.5 dl=1", "E4331", "Smax",
                   "`Smax` = 3 is one too many", "`Smin dS dl n_s`"},
        WrongValue{"TwoLaws", "S_n=60 dS=1 dl=1 Smin=30", "E4332", "Smin",
                   "`Smin` = 30 belongs to the modulated law", "the linear law is written"},
        WrongValue{"TwoSpeeds", "n_n=500 dn=1 v_n=100 S_n=60 dS=1 dl=1", "E4332", "v_n",
                   "`v_n` = 100 belongs to the cutting speed law", "`n_n dn S_n dS dl`"},
        WrongValue{"Rapid", "G0 X1 S_n=60 dS=1 dl=1", "E4333", "S_n", "in a block of `G0`",
                   "program it with G1"},
        WrongValue{"RapidByMode", "G0\nX1 S_n=60 dS=1 dl=1", "E4333", "S_n", "in a block of `G0`",
                   "program it with G1"},
        WrongValue{"Thread", "S100 M3\nG33 Z-1 K1 S_n=60 dS=1 dl=1", "E4333", "S_n",
                   "in a block of `G33`", "program it with G1"},
        WrongValue{"Drilling", "F100 G81 Z-1 R1 S_n=60 dS=1 dl=1", "E4333", "S_n",
                   "in a block of `G81`", "program it with G1"},
        WrongValue{"DrillingByMode", "F100 G81 X0 Z-1 R1\nX1 S_n=60 dS=1 dl=1", "E4333", "S_n",
                   "in a block of `G81`", "program it with G1"},
        WrongValue{"Probing", "F100 G38.2 Z-1 S_n=60 dS=1 dl=1", "E4333", "S_n",
                   "in a block of `G38.2`", "program it with G1"},
        WrongValue{"ComputedCode", "num code = 0;\nG=code X1 S_n=60 dS=1 dl=1", "E4333", "S_n",
                   "in a block of `G0`", "program it with G1"},
        WrongValue{"SetPosition", "G92 X1 S_n=60 dS=1 dl=1", "E4333", "S_n", "in a block of `G92`",
                   "program it with G1"},
        WrongValue{"RotaryAxisAlone", "G1 F100 B10 S_n=60 dS=1 dl=1", "E4333", "S_n",
                   "rotary axes alone", "program it with G1"},
        WrongValue{"InverseTime", "G93 G1 X1 F2 S_n=60 dS=1 dl=1", "E4334", "S_n", "inverse time",
                   "`G94` or `G95`"},
        WrongValue{"NoFeedStep", "S_n=60 dS=0 dl=1", "E4335", "dS", "`dS` = 0 must be above 0",
                   "above 0"},
        WrongValue{"NegativeFeedStep", "S_n=60 dS=-0.1 dl=1", "E4335", "dS",
                   "`dS` = -0.1 must be above 0", "above 0"},
        WrongValue{"NoFirstFeed", "S_n=0 dS=1 dl=1", "E4335", "S_n", "`S_n` = 0", "above 0"},
        WrongValue{"NoSmallestFeed", "Smin=0 dS=1 dl=1 n_s=4", "E4335", "Smin", "`Smin` = 0",
                   "above 0"},
        WrongValue{"NegativeLastFeed", "G1 X1 S_n=60 S_k=-60 dS=1", "E4335", "S_k", "`S_k` = -60",
                   "above 0"},
        WrongValue{"NoWayStep", "S_n=60 dS=1 dl=0", "E4335", "dl", "`dl` = 0 must not be 0",
                   "length"},
        WrongValue{"ModulatedBackwards", "Smin=60 dS=1 dl=-1 n_s=4", "E4335", "dl",
                   "`dl` = -1 must be above 0", "above 0"},
        WrongValue{"NegativeStand", "F100 L_A=-1 L_B=2", "E4335", "L_A", "`L_A` = -1", "above 0"},
        WrongValue{"NegativeCut", "F100 L_A=1 L_B=-2", "E4335", "L_B", "`L_B` = -2", "above 0"},
        WrongValue{"NoSpeed", "S100 M3 n_n=0 dn=1 S_n=60 dS=1 dl=1", "E4335", "n_n", "`n_n` = 0",
                   "above 0"},
        WrongValue{"NegativeLastCuttingSpeed", "S100 M3\nG1 X1 v_n=100 v_k=-1 S_n=60 S_k=70 dS=1",
                   "E4335", "v_k", "`v_k` = -1", "above 0"},
        WrongValue{"FeedBetweenSteps", "S_n=60 dS=0.17 dl=1", "E4336", "dS",
                   "`dS` = 0.17 is not a multiple of 0.1 mm/min", "`dS=0.2`"},
        WrongValue{"FeedBelowOneStep", "S_n=60 dS=0.04 dl=1", "E4336", "dS", "`dS` = 0.04",
                   "`dS=0.1`"},
        WrongValue{"FeedPerRevolutionBetweenSteps", "G95 S_n=0.1 dS=0.0025 dl=1", "E4336", "dS",
                   "`dS` = 0.0025 is not a multiple of 0.001 mm/rev", "`dS=0.003`"},
        WrongValue{"InchesBetweenSteps", "G20 S_n=10 dS=0.017 dl=0.5", "E4336", "dS",
                   "`dS` = 0.017 is not a multiple of 0.01 in/min", "`dS=0.02`"},
        WrongValue{"WayBetweenMachineIncrements", "S_n=60 dS=1 dl=-0.0105", "E4336", "dl",
                   "`dl` = -0.0105 is not a multiple of 0.001 mm", "`dl=-0.01"},
        WrongValue{"StandBetweenMachineIncrements", "F100 L_A=0.0004 L_B=2", "E4336", "L_A",
                   "`L_A` = 0.0004", "`L_A=0.001`"},
        WrongValue{"CutBetweenMachineIncrements", "F100 L_A=1 L_B=2.00051", "E4336", "L_B",
                   "`L_B` = 2.00051", "`L_B=2.001`"},
        WrongValue{"RangeBetweenSteps", "Smin=30 Smax=31.1 dS=0.5 dl=1", "E4336", "Smax",
                   "`Smax` = 31.1 lies 2.2 steps of `dS` = 0.5 above `Smin` = 30", "`Smax=31`"},
        WrongValue{"HalfAStepCount", "Smin=30 dS=0.5 dl=1 n_s=2.5", "E4337", "n_s", "`n_s` = 2.5",
                   "n_s=10"},
        WrongValue{"NoStepCount", "Smin=30 dS=0.5 dl=1 n_s=0", "E4337", "n_s", "`n_s` = 0",
                   "n_s=10"},
        WrongValue{"TooManySteps", "Smin=1 Smax=200000 dS=0.1 dl=1", "E4337", "Smax",
                   "`Smax` = 200000", "larger `dS`"},
        WrongValue{"NoRange", "Smin=30 Smax=30 dS=0.5 dl=1", "E4338", "Smax",
                   "`Smax` = 30 must be above `Smin` = 30", "swap"},
        WrongValue{"SameFeedWithoutWay", "G1 X1 S_n=60 S_k=60 dS=1", "E4339", "S_k",
                   "`S_k` = 60 is less than one `dS` away from `S_n` = 60", "add `dl`"},
        WrongValue{"LastFeedWithoutPath", "S_n=60 S_k=70 dS=1", "E4340", "S_k",
                   "`S_k` = 70 without `dl`", "add `dl`"},
        WrongValue{"LastSpeedWithoutPath", "S100 M3\nn_n=500 n_k=800 S_n=60 S_k=60 dS=1 dl=1",
                   "E4340", "n_k", "`n_k` = 800 with `S_k` = 60", "give the step `dn`"},
        WrongValue{"WayAwayFromLastFeed", "G1 X1 S_n=60 S_k=70 dS=1 dl=-0.5", "E4341", "dl",
                   "`dl` = -0.5 leads away from `S_k` = 70, which is above `S_n` = 60", "`dl=0.5`"},
        WrongValue{"InterruptedWithoutFeed", "L_A=1 L_B=2", "E4342", "L_A", "has no feed",
                   "program F"},
        WrongValue{"InterruptedWithoutFeedInMode", "F100\nG95 L_A=1 L_B=2", "E4342", "L_A",
                   "has no feed", "program F"},
        WrongValue{"StandingSpindle", "S100 n_n=100 dn=1 S_n=60 dS=1 dl=1", "E4343", "n_n",
                   "`n_n` = 100 needs a spindle that turns", "`M3` or `M4`"},
        WrongValue{"StandingSpindleOfCuttingSpeed", "v_n=100 dv=1 S_n=60 dS=1 dl=1", "E4343", "v_n",
                   "`v_n` = 100", "`M3` or `M4`"},
        WrongValue{"ConstantCuttingSpeed", "G96 S100 M3\nn_n=100 dn=1 S_n=60 dS=1 dl=1", "E4344",
                   "n_n", "`n_n` = 100 is not possible while G96", "`G97`"},
        WrongValue{"ConstantCuttingSpeedLater", "S100 M3 n_n=100 dn=1 S_n=60 dS=1 dl=1\nG96 S100",
                   "E4344", "G96", "a feed law sets the spindle speed", "#feedlaw (off)"},
        WrongValue{"CurveOfOnePoint",
                   "num ways[1] = {0};\nnum feeds[1] = {60};\n#feedlaw (curve, ways, feeds)",
                   "E4345", "#feedlaw", "the curve has 1 points", "2 to 1000"},
        WrongValue{
            "CurveOfUnequalArrays",
            "num ways[2] = {0, 1};\nnum feeds[3] = {60, 1, 1};\n#feedlaw (curve, ways, feeds)",
            "E4345", "#feedlaw", "2 distances, 3 feeds", "each distance"},
        WrongValue{"CurveOfUnequalSpeeds",
                   "num ways[2] = {0, 1};\nnum speeds[3] = {60, 1, 1};\n#feedlaw (curve, ways, "
                   "ways, speeds)",
                   "E4345", "#feedlaw", "2 distances, 2 feeds, 3 speeds", "each distance"},
        WrongValue{
            "CurveThatBeginsLate",
            "num ways[2] = {0.5, 1};\nnum feeds[2] = {60, 1};\n#feedlaw (curve, ways, feeds)",
            "E4345", "#feedlaw", "distance[0] = 0.5", "begin with distance 0"},
        WrongValue{
            "CurveThatTurnsBack",
            "num ways[3] = {0, 2, 2};\nnum feeds[3] = {60, 1, 1};\n#feedlaw (curve, ways, feeds)",
            "E4345", "#feedlaw", "distance[2] = 2 is not greater than distance[1] = 2", "ascend"},
        WrongValue{"CurveThatStops",
                   "num ways[2] = {0, 2};\nnum feeds[2] = {60, 0};\n#feedlaw (curve, ways, feeds)",
                   "E4335", "#feedlaw", "feed[1] = 0", "above 0"},
        WrongValue{"CurveOfStandingSpeed",
                   "num ways[2] = {0, 2};\nnum feeds[2] = {60, 1};\nnum speeds[2] = {1, -1};\n"
                   "#feedlaw (curve, ways, feeds, speeds)",
                   "E4335", "#feedlaw", "speed[1] = -1", "above 0"},
        WrongValue{
            "CurveWithStandingSpindle",
            "num ways[2] = {0, 2};\nnum feeds[2] = {60, 1};\n#feedlaw (curve, ways, feeds, feeds)",
            "E4343", "#feedlaw", "needs a spindle that turns", "`M3` or `M4`"},
        WrongValue{
            "CurveInInverseTime",
            "G93\nnum ways[2] = {0, 2};\nnum feeds[2] = {60, 1};\n#feedlaw (curve, ways, feeds)",
            "E4334", "#feedlaw", "inverse time", "`G94` or `G95`"},
        WrongValue{"UnknownLaw", "#feedlaw (linaer, 60, 0.1, 1)", "E3023", "linaer", "`linaer`",
                   "`linear`"},
        WrongValue{"TooFewValues", "#feedlaw (modulated, 60, 0.1, 1)", "E3005", "#feedlaw",
                   "3 values", "`#feedlaw (modulated, Smin, dS, dl, n_s)`"},
        WrongValue{"WrongValueOfDirective", "#feedlaw (linear, 60, 0.17, 1)", "E4336", "0.17",
                   "`dS` = 0.17", "`dS=0.2`"}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace stanok::lang::testing

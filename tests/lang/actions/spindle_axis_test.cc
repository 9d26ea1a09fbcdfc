// M902 and M903 in programs: what is asked of the channel, and what may be programmed when.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

// X, Z and C, which is spindle 1; spindle 2 becomes no axis.
class SpindleAxis : public ProgramTest {
 protected:
  SpindleAxis() {
    channel = {};
    channel.axes = {{"X", false, 0.0, 0, 0}, {"Z", false, 0.0, 2, 0}, {"C", true, 0.0, -1, 1}};
    channel.spindles = {1, 2};
    channel.channels = {1};
  }
  [[nodiscard]] std::vector<ProgramRequest> requests(RequestKind kind) {
    std::vector<ProgramRequest> found;
    for (const ProgramRequest& request : all<ProgramRequest>()) {
      if (request.kind == kind) found.push_back(request);
    }
    return found;
  }
};

TEST_F(SpindleAxis, IsAskedOfTheChannelAndStopsTheSpindleBefore) {
  ASSERT_EQ(error_code("S500 M3\nM902 H1=1//spindle 1 becomes C\nG1 C90 F600\nM903\nM30\n"), "");
  ASSERT_EQ(requests(RequestKind::spindle_to_axis).size(), 1u);
  EXPECT_EQ(requests(RequestKind::spindle_to_axis)[0].number, 1);
  ASSERT_EQ(requests(RequestKind::axis_to_spindle).size(), 1u);
  EXPECT_EQ(requests(RequestKind::axis_to_spindle)[0].number, 1);
  const auto spindles = all<SpindleCommand>();
  EXPECT_EQ(spindles.back().action, SpindleAction::stop);
}

TEST_F(SpindleAxis, WithoutH1IsTheMasterSpindle) {
  ASSERT_EQ(error_code("M902\nG0 C45\nM30\n"), "");
  EXPECT_EQ(requests(RequestKind::spindle_to_axis).at(0).number, 1);
}

TEST_F(SpindleAxis, CannotBeProgrammedWhileItIsASpindle) {
  for (const char* const block : {"G0 C90", "G1 X1 C1 F100", "G92 C0", "G28 C0", "M902 G0 C1"}) {
    EXPECT_EQ(error_code(std::string(block) + "\nM30\n"), "E4055") << block;
  }
  EXPECT_EQ(error_code("M902\nG0 C1\nM903\nC2\nM30\n"), "E4055");
  EXPECT_EQ(error_code("M902\nG0 C1\nM30\n"), "");
}

TEST_F(SpindleAxis, IsNoSpindleWhileItIsAnAxis) {
  for (const char* const block :
       {"S100", "M3", "M4", "M19", "$-1 M3", "G96 S100", "$1 S5", "G33 Z-5 K1", "S1=100"}) {
    EXPECT_EQ(error_code("S10\nM902\n" + std::string(block) + "\nM30\n"), "E4056") << block;
  }
  for (const char* const block : {"M5", "$2 S100 M3", "$2 M3"}) {
    EXPECT_EQ(error_code("$2 S10\nM902\n" + std::string(block) + "\nM30\n"), "") << block;
  }
  EXPECT_EQ(error_code("M902\nM903\nS100 M3\nM30\n"), "");
}

TEST_F(SpindleAxis, RefusesSpindlesThatDoNotExistOrBecomeNoAxis) {
  EXPECT_EQ(error_code("M902 H1=7\nM30\n"), "E4053");
  EXPECT_EQ(error_code("M902 H1=1.5\nM30\n"), "E4053");
  EXPECT_EQ(error_code("M902 H1=2\nM30\n"), "E4057");
  EXPECT_EQ(error_code("M902 H1=1 H2=2\nM30\n"), "E4008");
  EXPECT_EQ(error_code("M902 H1=1 H2=1\nM30\n"), "");
  EXPECT_EQ(error_code("M903 H2=1\nM30\n"), "E4003");
  EXPECT_EQ(error_code("G0 X1 H1=1\nM30\n"), "E4003");
}

TEST_F(SpindleAxis, BackOfWhatIsNoAxisIsAWarning) {
  ASSERT_EQ(error_code("M903\nM903 H1=1\nM30\n"), "");
  const auto messages = all<Message>();
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0].kind, Message::Kind::warning);
  EXPECT_EQ(messages[1].kind, Message::Kind::warning);
  EXPECT_TRUE(requests(RequestKind::axis_to_spindle).empty());
}

TEST_F(SpindleAxis, TwiceIsAskedOnce) {
  ASSERT_EQ(error_code("M902\nM902 H1=1\nM30\n"), "");
  EXPECT_EQ(requests(RequestKind::spindle_to_axis).size(), 1u);
}

TEST_F(SpindleAxis, AFaceNeedsTheAxis) {
  EXPECT_EQ(error_code("G12.1\nM30\n"), "E4055");
  EXPECT_EQ(error_code("M902\nG12.1\nG13.1\nM903\nM30\n"), "");
  EXPECT_EQ(error_code("M902\nG12.1\nM903\nM30\n"), "E4301");
}

}  // namespace
}  // namespace stanok::lang::testing

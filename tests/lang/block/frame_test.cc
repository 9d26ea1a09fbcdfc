// Frames: whatever the program does to its coordinate system, the point stays where it is in the
// base. Expected positions come from an own model of p_B = rotation * p_W + offset.
#include <cmath>
#include <random>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class Frames : public ProgramTest {
 protected:
  // X, Y, Z of the base where each move of the run ends.
  std::vector<std::array<double, 3>> ends_B(const std::string& text) {
    run(text);
    EXPECT_EQ(error.code, "") << to_text(error) << text;
    FrameChange frame;
    std::vector<std::array<double, 3>> ends;
    for (const Command& command : commands) {
      if (const auto* change = std::get_if<FrameChange>(&command.payload)) frame = *change;
      if (const auto* move = std::get_if<Move>(&command.payload))
        ends.push_back(base(frame, *move));
    }
    return ends;
  }

  static std::array<double, 3> base(const FrameChange& frame, const Move& move) {
    const auto& rows = frame.rotation.rows();
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
      point[i] = frame.offset[i];
      for (std::size_t k = 0; k < 3; ++k) point[i] += rows[i][k] * move.end[k];
    }
    return point;
  }
};

TEST_F(Frames, ChangesOfTheSystemLeaveThePointWhereItIs) {
  constexpr unsigned seed = 77;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const auto number = [&](int from, int to) {
    return std::to_string(std::uniform_int_distribution<int>(from, to)(random));
  };
  tables.offsets[2] = {100.0, 200.0, 300.0};
  const auto change = [&]() -> std::string {
    switch (std::uniform_int_distribution<int>(0, 10)(random)) {
      case 0:
        return "G54";
      case 1:
        return "G55";
      case 2:
        return "G52 X" + number(-9, 9) + " Z" + number(-9, 9);
      case 3:
        return "G92 Y" + number(-9, 9) + " X" + number(-9, 9);
      case 4:
        return "G92.1";
      case 5:
        return "G68 X" + number(-9, 9) + " R" + number(-180, 180);
      case 6:
        return "G68 I" + number(-9, 9) + " J" + number(-9, 9) + " K1 R" + number(-180, 180);
      case 7:
        return "G51 X" + number(-9, 9) + " Y0 P" + number(1, 3);
      case 8:
        return "G51.1 X" + number(-9, 9);
      case 9:
        return "G50.1";
      default:
        return "G69";
    }
  };
  for (int round = 0; round < 200; ++round) {
    std::string text = "G0 X10 Y20 Z30\n";
    for (int i = 0; i < 8; ++i) {
      text += change() + "\nG91 X0 Y0 Z0\n";
      text += "G90 X=$prog_pos[X] Y=$prog_pos[Y] Z=$prog_pos[Z]\n";
    }
    const auto ends = ends_B(text + "M30\n");
    for (const auto& end : ends) {
      for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(end[k], ends.front()[k], 1e-6) << text;
    }
  }
}

// A square of side 10 about the centre (3, 4), turned by any angle, keeps its corners' distance
// from the centre, and the first corner stands at the angle.
TEST_F(Frames, RotationTurnsAboutItsCentre) {
  for (int angle = -360; angle <= 360; angle += 45) {
    const auto ends =
        ends_B("G52 X100 Y50\nG68 X3 Y4 R" + std::to_string(angle) + "\nG0 X8 Y4\nX3 Y9\nM30\n");
    const double radians = angle * std::acos(-1.0) / 180.0;
    EXPECT_NEAR(ends[0][0], 103.0 + 5.0 * std::cos(radians), 1e-9);
    EXPECT_NEAR(ends[0][1], 54.0 + 5.0 * std::sin(radians), 1e-9);
    EXPECT_NEAR(ends[1][0], 103.0 - 5.0 * std::sin(radians), 1e-9);
    EXPECT_NEAR(ends[1][1], 54.0 + 5.0 * std::cos(radians), 1e-9);
  }
}

TEST_F(Frames, RotationOfAWorkOffsetTurnsWhatIsOnTopOfIt) {
  tables.offsets[2] = {100.0, 200.0, 300.0};
  tables.rotations[2] = 90.0;
  const auto ends = ends_B("G55\nG52 X1\nG68 X0 Y0 R-90\nG0 X5 Y7\nM30\n");
  EXPECT_NEAR(ends[0][0], 105.0, 1e-9);
  EXPECT_NEAR(ends[0][1], 208.0, 1e-9);
}

TEST_F(Frames, AWrittenWorkOffsetHoldsAtOnceWhenItIsActive) {
  answering = [this](const ProgramRequest& request) {
    if (request.kind == RequestKind::offset_table_write) {
      tables.offsets[request.number][static_cast<std::size_t>(request.index)] = request.value;
    }
    return Answer{};
  };
  tables.offsets[1] = {};
  const auto ends = ends_B("G0 X1 Y2\nG10 L2 P1 X50 Y60\nG0 X0 Y0\nG10 L20 P1 X8\nX8\nM30\n");
  ASSERT_EQ(ends.size(), 3u);
  EXPECT_EQ(ends[1], (std::array<double, 3>{50.0, 60.0, 0.0}));
  EXPECT_EQ(ends[2], ends[1]);
}

TEST_F(Frames, ReferencePointsOutliveTheProgram) {
  run("G0 X7 Z9\nG28.1\nM30\n");
  files.texts["second.nc"] = "G28\nM30\n";
  const auto second = compile("second.nc", files, &channel, warnings);
  ASSERT_TRUE(second.has_value());
  commands.clear();
  interpreter->start(*second, {});
  drain();
  const auto list = all<Move>();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].end, (AxisValues{7.0, 0.0, 9.0}));
}

TEST_F(Frames, ReferencePointsOfTheMachineFileHoldUntilOneIsStored) {
  tables.reference[2] = {0.0, 0.0, 450.0};
  const auto list = moves("G30 Z0\nM30\n");
  ASSERT_EQ(list.size(), 1u + 1u);
  EXPECT_EQ(list[1].end[2], 450.0);
}

// It has no point, and the program goes on from where the axes are then.
TEST_F(Frames, ATapIsTakenOutByG30P99) {
  run("G30 P99\nM30\n");
  const auto requests = all<ProgramRequest>();
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_EQ(requests[0].kind, RequestKind::tap_out);
  EXPECT_TRUE(all<Move>().empty());
  commands.clear();
  run("M3 S500\nG30 P99\nM30\n");
  EXPECT_EQ(all<SpindleCommand>().back().action, SpindleAction::stop);
  for (const char* const wrong : {"G30 P99 Z0\nM30\n", "G30 P98\nM30\n", "G28 P99\nM30\n"})
    EXPECT_NE(error_code(wrong), "") << wrong;
}

}  // namespace
}  // namespace stanok::lang::testing

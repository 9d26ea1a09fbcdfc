// Touching off: G10 L20 writes the work offset, G10 L10 and L11 the tool length, with which the
// point where the axes stand has the programmed coordinates, whatever turns the system. Expected
// is what the words say; the other coordinates of the system stay what they were in it.
#include <cmath>
#include <random>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class TouchOff : public ProgramTest {
 protected:
  void SetUp() override {
    answering = [this](const ProgramRequest& request) { return write(request); };
  }

  Answer write(const ProgramRequest& request) {
    const auto index = static_cast<std::size_t>(request.index);
    if (request.kind == RequestKind::offset_table_write) {
      if (request.index == rotation_of_offset) {
        tables.rotations[request.number] = request.value;
      } else {
        tables.offsets[request.number][index] = request.value;
      }
    }
    if (request.kind == RequestKind::tool_table_write) {
      Tool& tool = tables.tools[request.number];
      if (request.text == "length_x") tool.length_mm[0] = request.value;
      if (request.text == "length_y") tool.length_mm[1] = request.value;
      if (request.text == "length") tool.length_mm[2] = request.value;
    }
    return usual_answer(request);
  }

  // The numbers that the program shows with msg, one a message.
  std::vector<double> numbers(const std::string& text) {
    std::vector<double> list;
    for (const std::string& message : messages(text)) list.push_back(std::stod(message));
    return list;
  }
};

const std::string show_point =
    "msg (str ($prog_pos[X]));\nmsg (str ($prog_pos[Y]));\nmsg (str ($prog_pos[Z]));\n";

// Any state of everything between the words and the base.
class RandomSystem {
 public:
  explicit RandomSystem(unsigned seed) : random_(seed) {}

  int integer(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  std::string number(int from, int to) { return std::to_string(integer(from, to)); }

  std::string changes() {
    std::string text;
    if (integer(0, 2) == 0) text += "G52 X" + number(-9, 9) + " Z" + number(-9, 9) + "\n";
    if (integer(0, 2) == 0) text += "G92 Y" + number(-9, 9) + " X" + number(-9, 9) + "\n";
    if (integer(0, 2) == 0) text += "G51 X" + number(-9, 9) + " Y0 Z0 P" + number(1, 3) + "\n";
    if (integer(0, 2) == 0) text += "G51.1 X" + number(-9, 9) + "\n";
    switch (integer(0, 2)) {
      case 0:
        return text + "G68 X" + number(-9, 9) + " R" + number(-180, 180) + "\n";
      case 1:
        return text + "G68 I" + number(-9, 9) + " J" + number(-9, 9) + " K1 R" + number(-180, 180) +
               "\n";
      default:
        return text;
    }
  }

 private:
  std::mt19937 random_;
};

TEST_F(TouchOff, InASystemTurnedBy30DegreesTheOffsetIsTheOneOfTheFormula) {
  tables.rotations[1] = 30.0;
  const auto shown = numbers("G10 L20 P1 X5\n" + show_point + "M30\n");
  ASSERT_EQ(shown.size(), 3u);
  EXPECT_NEAR(shown[0], 5.0, 1e-9);
  EXPECT_NEAR(shown[1], 0.0, 1e-9);
  EXPECT_NEAR(tables.offsets[1][0], -5.0 * std::sqrt(0.75), 1e-9);
  EXPECT_NEAR(tables.offsets[1][1], -2.5, 1e-9);
}

TEST_F(TouchOff, AWorkOffsetIsWrittenSoThatThePointHasTheProgrammedCoordinates) {
  constexpr unsigned seed = 1311;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  RandomSystem system(seed);
  for (int round = 0; round < 300; ++round) {
    for (const int page : {1, 2, 3}) {
      tables.offsets[page] = {};
      for (std::size_t axis = 0; axis < 3; ++axis)
        tables.offsets[page][axis] = system.integer(-90, 90);
      tables.rotations[page] = system.integer(0, 1) == 0 ? 0.0 : system.integer(-180, 180);
    }
    const int page = system.integer(1, 3);
    const std::string select = "G" + std::to_string(53 + page) + "\n";
    std::string words;
    std::array<std::optional<double>, 3> wanted;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (system.integer(0, 1) == 0 && (axis < 2 || !words.empty())) continue;
      wanted[axis] = system.integer(-50, 50);
      words += std::string(" ") + "XYZ"[axis] + std::to_string(static_cast<int>(*wanted[axis]));
    }
    const std::string text = "G0 X10 Y20 Z30\n" + system.changes() + select + show_point + "G54\n" +
                             "G10 L20 P" + std::to_string(page) + words + "\n" + select +
                             show_point + "M30\n";
    const auto shown = numbers(text);
    ASSERT_EQ(shown.size(), 6u) << text;
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(shown[3 + axis], wanted[axis].value_or(shown[axis]), 1e-6) << text << axis;
  }
}

TEST_F(TouchOff, AToolLengthIsWrittenSoThatThePointHasTheProgrammedCoordinates) {
  constexpr unsigned seed = 1312;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  RandomSystem system(seed);
  for (int round = 0; round < 200; ++round) {
    tables.tools[4] = {4, {1.0, 2.0, 30.0}, 0.0, 0, 0.0};
    tables.rotations[1] = system.integer(-180, 180);
    tables.rotations[9] = system.integer(-180, 180);
    const bool in_fixture = system.integer(0, 1) == 0;
    const int wanted = system.integer(-50, 50);
    const char axis = "XYZ"[system.integer(0, 2)];
    const std::string changes = in_fixture ? "G59.3\n" : system.changes();
    const std::string text = "G43 H4 G0 X10 Y20 Z30\n" + changes + show_point +
                             (in_fixture ? "G10 L11 P4 " : "G10 L10 P4 ") + axis +
                             std::to_string(wanted) + "\nG43 H4\n" + show_point + "M30\n";
    const auto shown = numbers(text);
    ASSERT_EQ(shown.size(), 6u) << text;
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = "XYZ"[k] == axis ? wanted : shown[k];
      ASSERT_NEAR(shown[3 + k], expected, 1e-6) << text << k;
    }
  }
}

// On the face C is programmed in mm, and the table holds degrees.
TEST_F(TouchOff, OnAFaceAWorkOffsetIsRefused) {
  EXPECT_EQ(error_code("G12.1\nG10 L20 P1 C5\nM30\n"), "E4301");
}

}  // namespace
}  // namespace stanok::lang::testing

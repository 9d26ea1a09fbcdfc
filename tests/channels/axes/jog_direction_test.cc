// Directions of jogs against rotation matrices written by hand.
#include "channels/axes/jog_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/kinematics/test_machines.h"

namespace stanok::channels {
namespace {

using kinematics::Transform;
namespace test_machine = kinematics::test_machine;

constexpr double radians = std::numbers::pi / 180.0;
// What the test machine reads where its angles are 0, deg.
constexpr double zero_b = 1.5;
constexpr double zero_c = -30.0;

// B turns the head about Y, C the table about Z.
class JogDirectionTest : public ::testing::Test {
 protected:
  Transform frame() const {
    Transform frame;
    frame.scheme = scheme.get();
    frame.frame.geometry = {0, 1, 2};
    frame.tool.nose_to_tip_mm = {0.0, 0.0, -80.0};
    return frame;
  }
  static void expect(const std::optional<AxisArray<double>>& direction, double x, double y,
                     double z) {
    ASSERT_TRUE(direction.has_value());
    EXPECT_NEAR((*direction)[0], x, 1e-12);
    EXPECT_NEAR((*direction)[1], y, 1e-12);
    EXPECT_NEAR((*direction)[2], z, 1e-12);
    EXPECT_EQ((*direction)[3], 0.0);
    EXPECT_EQ((*direction)[4], 0.0);
  }

  const std::unique_ptr<const kinematics::Scheme> scheme =
      make_scheme(test_machine::head_table({0, 1, 0}, {0, 0, 1}));
};

// In M only the head turns the spindle: the columns of Ry(B).
TEST_F(JogDirectionTest, TheToolPointsAsTheHeadHasTurnedIt) {
  for (const double b : {-75.0, 0.0, 30.0, 90.0}) {
    for (const double c : {-200.0, 0.0, 45.0}) {
      const AxisArray<double> axes{{12.0, -7.0, 55.0, b + zero_b, c + zero_c}};
      const double sine = std::sin(b * radians);
      const double cosine = std::cos(b * radians);
      expect(jog_direction(JogFrame::tool, 2, frame(), axes), sine, 0.0, cosine);
      expect(jog_direction(JogFrame::tool, 0, frame(), axes), cosine, 0.0, -sine);
      expect(jog_direction(JogFrame::tool, 1, frame(), axes), 0.0, 1.0, 0.0);
    }
  }
}

// Led by its tip (G43.4) the tool keeps to the part, which the table has turned: Rz(C).
TEST_F(JogDirectionTest, ThePlaneTurnsWithTheTableUnderATipThatIsLed) {
  Transform led = frame();
  led.mode = kinematics::PointMode::tip;
  const AxisArray<double> axes{{12.0, -7.0, 55.0, 20.0 + zero_b, 35.0 + zero_c}};
  const double sine = std::sin(35.0 * radians);
  const double cosine = std::cos(35.0 * radians);
  expect(jog_direction(JogFrame::plane, 0, led, axes), cosine, sine, 0.0);
  expect(jog_direction(JogFrame::plane, 1, led, axes), -sine, cosine, 0.0);
  expect(jog_direction(JogFrame::plane, 2, led, axes), 0.0, 0.0, 1.0);
}

// G68.2 with a plane turned about X by 40 deg, the axes riding on the slides.
TEST_F(JogDirectionTest, ThePlaneIsThatOfTheFrameInForce) {
  Transform tilted = frame();
  tilted.frame.rotation = Rotation::about({1.0, 0.0, 0.0}, 40.0);
  const double sine = std::sin(40.0 * radians);
  const double cosine = std::cos(40.0 * radians);
  expect(jog_direction(JogFrame::plane, 1, tilted, {}), 0.0, cosine, sine);
  expect(jog_direction(JogFrame::plane, 2, tilted, {}), 0.0, -sine, cosine);
}

TEST(JogDirection, IsNoneWhereTheSchemeHasNoStraightLine) {
  Transform face;
  const auto scheme = make_scheme(
      face_scheme(test_machine::config_of("cartesian"), 4, kinematics::FaceSide::positive));
  ASSERT_NE(scheme, nullptr);
  face.scheme = scheme.get();
  face.frame.geometry = scheme->config().linear;
  const AxisArray<double> axes{{30.0, 0.0, 10.0, 0.0, 20.0}};
  EXPECT_FALSE(jog_direction(JogFrame::plane, 0, face, axes).has_value());
  EXPECT_FALSE(jog_direction(JogFrame::plane, 0, Transform{}, axes).has_value());
}

}  // namespace
}  // namespace stanok::channels

// The simulated cut against its definitions: depth, chip thickness, force, power, self-oscillation.
#include "plant/cutting/cutting_process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stanok::plant {
namespace {

constexpr double time_step_s = 0.001;

config::CuttingConfig bar() {
  return {.specific_force_n = 1600.0,
          .feed_exponent = 0.75,
          .hardness_hb = 200.0,
          .hardness_exponent = 0.75,
          .efficiency = 0.8,
          .stock = {{.z_mm = 0.0, .radius_mm = 32.0, .hardness_hb = 200.0},
                    {.z_mm = -20.0, .radius_mm = 33.0, .hardness_hb = 260.0}}};
}

// A feed of v is v T thick after one revolution, and on the way there grows with the way.
TEST(ChipThickness, IsTheWayOverOneRevolution) {
  ChipThickness chip;
  const double turns_per_s = 10.0;
  for (int k = 0; k < 50; ++k) chip.advance(2.0 * time_step_s, turns_per_s * time_step_s);
  EXPECT_NEAR(chip.thickness_mm(), 2.0 * 0.05, 1e-12);
  for (int k = 0; k < 200; ++k) chip.advance(2.0 * time_step_s, turns_per_s * time_step_s);
  EXPECT_NEAR(chip.thickness_mm(), 2.0 * 0.1, 1e-12);
  // Twice the feed: half way over after half a revolution.
  for (int k = 0; k < 50; ++k) chip.advance(4.0 * time_step_s, turns_per_s * time_step_s);
  EXPECT_NEAR(chip.thickness_mm(), 3.0 * 0.1, 1e-12);
  for (int k = 0; k < 50; ++k) chip.advance(4.0 * time_step_s, turns_per_s * time_step_s);
  EXPECT_NEAR(chip.thickness_mm(), 4.0 * 0.1, 1e-12);
}

TEST(ChipThickness, RunsOutWhenTheToolRests) {
  ChipThickness chip;
  for (int k = 0; k < 500; ++k) chip.advance(2.0 * time_step_s, 10.0 * time_step_s);
  for (int k = 0; k < 101; ++k) chip.advance(0.0, 10.0 * time_step_s);
  EXPECT_NEAR(chip.thickness_mm(), 0.0, 1e-12);
}

TEST(Stock, HasTheDepthOfItsSectionsAlongZ) {
  Stock stock(bar().stock);
  EXPECT_EQ(stock.move_tool(30.0, 5.0).depth_mm, 0.0);
  double z = 5.0;
  const auto go_to = [&](double end) {
    Stock::Cut cut;
    for (; z > end; z -= 0.002) cut = stock.move_tool(30.0, z);
    return cut;
  };
  EXPECT_EQ(go_to(0.01).depth_mm, 0.0);
  EXPECT_NEAR(go_to(-10.0).depth_mm, 2.0, 1e-12);
  const Stock::Cut second = go_to(-30.0);
  EXPECT_NEAR(second.depth_mm, 3.0, 1e-12);
  EXPECT_EQ(second.hardness_hb, 260.0);
}

TEST(Stock, IsGoneWhereTheToolHasBeen) {
  Stock stock(bar().stock);
  for (double z = 1.0; z > -15.0; z -= 0.002) static_cast<void>(stock.move_tool(30.0, z));
  for (double x = 30.0; x < 40.0; x += 0.1) static_cast<void>(stock.move_tool(x, -15.0));
  static_cast<void>(stock.move_tool(40.0, 1.0));
  for (double z = 1.0; z > -14.0; z -= 0.002)
    ASSERT_EQ(stock.move_tool(30.0, z).depth_mm, 0.0) << "nothing is left there";
  static_cast<void>(stock.move_tool(40.0, 1.0));
  static_cast<void>(stock.move_tool(29.0, 1.0));
  for (double z = 1.0; z > -10.0; z -= 0.002) static_cast<void>(stock.move_tool(29.0, z));
  EXPECT_NEAR(stock.move_tool(29.0, -10.002).depth_mm, 1.0, 1e-9) << "a millimetre below it";
}

// 2 mm of the face are taken off from outside to the centre.
TEST(Stock, HasTheDepthBesideTheToolWhenItFaces) {
  Stock stock(bar().stock);
  static_cast<void>(stock.move_tool(40.0, 5.0));
  static_cast<void>(stock.move_tool(40.0, -2.0));
  for (double x = 40.0; x > 32.01; x -= 0.002) ASSERT_EQ(stock.move_tool(x, -2.0).depth_mm, 0.0);
  for (double x = 31.9; x > 1.0; x -= 0.002)
    ASSERT_NEAR(stock.move_tool(x, -2.0).depth_mm, 2.0, 0.051) << "to one cell";
}

TEST(CuttingProcess, MakesForceAndPowerOfDepthChipAndHardness) {
  CuttingProcess process(bar());
  double z = 1.0;
  const double feed = 2.0;
  const auto go_to = [&](double end) {
    for (; z > end; z -= feed * time_step_s)
      process.advance({.x_mm = 30.0, .z_mm = z}, 600.0, time_step_s);
  };
  go_to(0.01);
  EXPECT_EQ(process.force_n(), 0.0);
  go_to(-15.0);
  const double force = 1600.0 * 2.0 * std::pow(0.2, 0.75);
  EXPECT_NEAR(process.force_n(), force, 1e-6 * force);
  EXPECT_NEAR(process.power_w(), force * 2.0 * std::numbers::pi * 10.0 * 0.03 / 0.8, 1e-3);
  go_to(-30.0);
  EXPECT_NEAR(process.force_n(), 1600.0 * 3.0 * std::pow(0.2, 0.75) * std::pow(1.3, 0.75), 1e-3);
}

TEST(CuttingProcess, TakesNoPowerWhileTheSpindleStands) {
  CuttingProcess process(bar());
  for (double z = 1.0; z > -5.0; z -= 0.002) process.advance({30.0, z}, 0.0, time_step_s);
  EXPECT_EQ(process.force_n(), 0.0);
  EXPECT_EQ(process.power_w(), 0.0);
}

struct Swing {
  double amplitude_um = 0.0;
  double frequency_hz = 0.0;
};
// Over one second.
Swing swing(SelfOscillation& oscillation, Engagement engagement, double force_n = 0.0,
            double hz = 0.0) {
  Swing swing;
  double before = oscillation.displacement_um();
  int crossings = 0;
  constexpr double step_s = 1e-4;
  for (int k = 0; k < 10000; ++k) {
    oscillation.advance(force_n * std::sin(2.0 * std::numbers::pi * hz * k * step_s), engagement,
                        step_s);
    const double now = oscillation.displacement_um();
    if (before < 0.0 && now >= 0.0) ++crossings;
    swing.amplitude_um = std::max(swing.amplitude_um, std::abs(now));
    before = now;
  }
  swing.frequency_hz = crossings;
  return swing;
}

// Van der Pol's equation in the form with 4 x^2 / a^2 swings with a, to second order in its
// damping.
TEST(SelfOscillation, GrowsToItsAmplitudeInTheCutAndDiesOutBehind) {
  SelfOscillation oscillation({.amplitude_um = 15.0, .frequency_hz = 120.0, .mass_kg = 2.0});
  static_cast<void>(swing(oscillation, Engagement::in_cut));
  const Swing in_the_cut = swing(oscillation, Engagement::in_cut);
  EXPECT_NEAR(in_the_cut.amplitude_um, 15.0, 0.02 * 15.0);
  EXPECT_NEAR(in_the_cut.frequency_hz, 120.0, 1.0);
  static_cast<void>(swing(oscillation, Engagement::out_of_cut));
  EXPECT_LT(swing(oscillation, Engagement::out_of_cut).amplitude_um, 0.1);
}

// A force far below its frequency moves the mass by P / (m w^2).
TEST(SelfOscillation, IsMovedByAForceAsAMassOnASpring) {
  SelfOscillation oscillation({.amplitude_um = 15.0, .frequency_hz = 120.0, .mass_kg = 2.0});
  static_cast<void>(swing(oscillation, Engagement::out_of_cut, 20.0, 3.0));
  const double omega = 2.0 * std::numbers::pi * 120.0;
  EXPECT_NEAR(swing(oscillation, Engagement::out_of_cut, 20.0, 3.0).amplitude_um,
              1e6 * 20.0 / (2.0 * omega * omega), 0.05);
}

}  // namespace
}  // namespace stanok::plant

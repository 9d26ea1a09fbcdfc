// Forces of a milling tool against closed forms: mean forces of a tooth that cuts between two
// angles (Altintas, Manufacturing Automation, 2012, eq. 2.79 to 2.83), power against removal rate.
#include "process/milling/milling_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double cutter_mm = 5.0;
constexpr double cut_mm = 2.0;
constexpr double cutting_n_per_mm2 = 800.0;
constexpr double radial_part = 0.3;
constexpr double edge_n = 12.0;
constexpr double edge_radial_n = 20.0;

CuttingProcess end_mill(int teeth) {
  CuttingProcess process;
  process.force_n_per_mm2 = cutting_n_per_mm2;
  process.radial_ratio = radial_part;
  process.teeth = teeth;
  process.edge_n_per_mm = edge_n;
  process.edge_radial_n_per_mm = edge_radial_n;
  return process;
}

// A cylinder that meets material between two angles, over the depth.
std::vector<EngagedSlice> engaged(double from_rad, double to_rad, int slices = 20) {
  constexpr int angles = 720;
  std::vector<EngagedSlice> all;
  for (int k = 0; k < slices; ++k) {
    EngagedSlice slice{.height_mm = cut_mm * (k + 0.5) / slices,
                       .width_mm = cut_mm / slices,
                       .radius_mm = cutter_mm,
                       .slope = 0.0,
                       .meets = std::vector<std::uint8_t>(angles, 0)};
    for (int n = 0; n < angles; ++n) {
      const double angle = 2.0 * half_turn * (n + 0.5) / angles;
      slice.meets[checked_size(n)] = angle > from_rad && angle < to_rad ? 1 : 0;
    }
    all.push_back(slice);
  }
  return all;
}

struct MeanForce {
  double x = 0.0;
  double y = 0.0;
};

// Integrals of dF_x = -F_t cos - F_r sin and dF_y = F_t sin - F_r cos over the angles.
MeanForce closed_form(int teeth, double feed, double from, double to) {
  const auto at = [&](double p) {
    const double chip = cutting_n_per_mm2 * feed;
    return MeanForce{
        .x = chip * (std::cos(2.0 * p) / 4.0 - radial_part * (p / 2.0 - std::sin(2.0 * p) / 4.0)) -
             edge_n * std::sin(p) + edge_radial_n * std::cos(p),
        .y = chip * (p / 2.0 - std::sin(2.0 * p) / 4.0 + radial_part * std::cos(2.0 * p) / 4.0) -
             edge_n * std::cos(p) - edge_radial_n * std::sin(p)};
  };
  const double part = teeth * cut_mm / (2.0 * half_turn);
  return {.x = part * (at(to).x - at(from).x), .y = part * (at(to).y - at(from).y)};
}

TEST(MillingLoad, MeanForcesAreTheClosedForm) {
  struct Case {
    int teeth;
    double from;
    double to;
    double helix;
  };
  for (const Case& cut : {Case{3, 0.0, half_turn, 0.0}, Case{4, 0.0, half_turn / 2.0, 0.0},
                          Case{2, 2.0, half_turn, 0.5}, Case{4, 1.0, 2.0, 0.3}}) {
    CuttingProcess process = end_mill(cut.teeth);
    process.helix_rad = cut.helix;  // has no part in the mean
    const MillingLoad load(process, engaged(cut.from, cut.to), {});
    const double feed = 0.08;
    const MillingForces forces = load.at(feed);
    const MeanForce expected = closed_form(cut.teeth, feed, cut.from, cut.to);
    const double size = std::hypot(expected.x, expected.y);
    EXPECT_NEAR(forces.mean_x_n, expected.x, 0.01 * size) << cut.teeth << " " << cut.from;
    EXPECT_NEAR(forces.mean_y_n, expected.y, 0.01 * size) << cut.teeth << " " << cut.from;
  }
}

// Without edge forces the power is cutting_n_per_mm2 times the volume in a second.
TEST(MillingLoad, PowerIsThatOfTheVolume) {
  CuttingProcess process = end_mill(3);
  process.edge_n_per_mm = process.edge_radial_n_per_mm = 0.0;
  for (const double width : {1.0, 2.5, 5.0, 10.0}) {
    const double angle = std::acos(1.0 - width / cutter_mm);
    const MillingLoad load(process, engaged(half_turn - angle, half_turn), {});
    EXPECT_NEAR(load.area_mm2(), width * cut_mm, 0.01 * width * cut_mm) << width;
    const double feed = 0.1;
    const double per_turn = 2.0 * half_turn * load.at(feed).torque_n_mm;
    EXPECT_NEAR(per_turn, cutting_n_per_mm2 * width * cut_mm * feed * 3, 0.01 * per_turn) << width;
  }
}

// A single straight tooth in a slot: F_t and F_r are the parts of one force, so that the resultant
// is b sqrt((cutting_n_per_mm2 h + edge_n)^2 + (radial_part cutting_n_per_mm2 h +
// edge_radial_n)^2), greatest at h = f.
TEST(MillingLoad, PeakOfOneToothIsAtTheThickestChip) {
  const MillingLoad load(end_mill(1), engaged(0.0, half_turn), {});
  const auto peak = [](double feed) {
    return cut_mm * std::hypot(cutting_n_per_mm2 * feed + edge_n,
                               radial_part * cutting_n_per_mm2 * feed + edge_radial_n);
  };
  for (const double feed : {0.02, 0.1, 0.2}) {
    EXPECT_NEAR(load.at(feed).peak_n, peak(feed), 0.005 * peak(feed));
    EXPECT_NEAR(load.feed_of_peak(peak(feed)), feed, 0.01 * feed);
  }
  EXPECT_EQ(load.feed_of_peak(0.5 * peak(0.0)), 0.0) << "the edges alone take more";
}

TEST(MillingLoad, FeedOfAPeakHasThatPeak) {
  CuttingProcess process = end_mill(4);
  process.helix_rad = 0.6;
  const MillingLoad load(process, engaged(1.8, half_turn), {});
  for (const double peak : {150.0, 300.0, 700.0}) {
    const double feed = load.feed_of_peak(peak);
    ASSERT_GT(feed, 0.0);
    EXPECT_NEAR(load.at(feed).peak_n, peak, 1e-6);
  }
  EXPECT_EQ(MillingLoad(process, {}, {}).feed_of_peak(1.0),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(MillingLoad(process, {}, {}).at(0.1).peak_n, 0.0);
}

TEST(MillingLoad, TheToolGivesWayByItsCompliance) {
  CuttingProcess process = end_mill(1);
  process.modes_x =
      process.modes_y = {{.frequency_hz = 600.0, .damping = 0.03, .stiffness_n_per_mm = 5000.0},
                         {.frequency_hz = 900.0, .damping = 0.03, .stiffness_n_per_mm = 20000.0}};
  const MillingForces forces = MillingLoad(process, engaged(0.0, half_turn), {}).at(0.1);
  EXPECT_NEAR(forces.deflection_mm, forces.peak_n * (1.0 / 5000.0 + 1.0 / 20000.0), 1e-9);
}

// A cone of 45 deg that goes straight down: N is (1, -1)/sqrt 2, so that the chip is f/sqrt 2 thick
// and its edge sqrt 2 dz long; the area across the feed is that of the ring.
TEST(MillingLoad, ALeaningEdgeCutsDownwards) {
  CuttingProcess process = end_mill(2);
  process.edge_n_per_mm = process.edge_radial_n_per_mm = 0.0;
  std::vector<EngagedSlice> cone = engaged(0.0, 2.0 * half_turn);
  for (EngagedSlice& slice : cone) {
    slice.slope = 1.0;
    slice.radius_mm = 3.0 + slice.height_mm;
  }
  const MillingLoad load(process, cone, {.across = 0.0, .along = -1.0});
  EXPECT_NEAR(load.area_mm2(), half_turn * (25.0 - 9.0), 0.01 * half_turn * 16.0);
  EXPECT_NEAR(load.at(0.1).peak_n, 0.0, 1e-9) << "both teeth hold each other up";
}

}  // namespace
}  // namespace stanok::process

#include "tests/support/machine/turning_bench.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/cycle.h"

namespace stanok::testing {
namespace {

constexpr double s_per_min = 60.0;

// Nodes of a part whose feed changes: the trapezium rule is then right to 1e-9 s and better.
constexpr int nodes_of_part = 200;

// What the strong axes need for their ramps, at the ends and in corners.
constexpr double ramps_s = 1e-4;

}  // namespace

channels::MachineConfig lathe_with_spindle(double speed_min, double acceleration) {
  channels::MachineConfig config = turning_machine();
  config.spindles[0].speed_min = speed_min;
  config.spindles[0].acceleration = acceleration;
  return config;
}

channels::MachineConfig strong_lathe(double speed_min) {
  channels::MachineConfig config = lathe_with_spindle(speed_min, 0.0);
  for (channels::AxisConfig& axis : config.axes) {
    if (axis.rotary) continue;
    axis.limits.velocity_max = 1e4;
    axis.limits.rapid_max = 1e4;
    axis.limits.acceleration_max = 1e9;
    axis.limits.jerk_max = 1e13;
  }
  return config;
}

std::vector<CutCycle> cycles_of_cut(MachineBench& bench, const std::string& program) {
  bench.program("cut.nc", program);
  bench.run(1, "cut.nc");
  std::vector<CutCycle> cycles;
  double x = 0.0;
  double z = 0.0;
  bench.run_to_end([&](const channels::CycleOutput& output) {
    const channels::ChannelOutput& channel = output.channels[0];
    const bool cuts = channel.process.feed_mm_per_min > 0.0;
    const bool ends = !cuts && !cycles.empty() && !cycles.back().is_last;
    if (cuts || ends) {
      CutCycle one{.process = channel.process, .is_last = ends};
      const CutCycle before = cycles.empty() ? CutCycle{} : cycles.back();
      one.x = channel.point_W[0].value;
      one.z = channel.point_W[1].value;
      one.time_s = before.time_s + cycle_s;
      one.way = before.way + std::hypot(one.x - x, one.z - z);
      cycles.push_back(one);
    }
    x = channel.point_W[0].value;
    z = channel.point_W[1].value;
  });
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>{});
  EXPECT_FALSE(cycles.empty());
  return cycles;
}

void CutTime::add(double way, const std::function<double(double)>& feed) {
  const Node start = nodes_.back();
  const double step = way / nodes_of_part;
  for (int k = 0; k <= nodes_of_part; ++k) {
    const double next = feed(k * step) / s_per_min;
    if (feed_ > 0.0) variation_ += std::abs(next - feed_);
    if (k > 0) {
      const double slowness = 0.5 / feed_ + 0.5 / next;
      nodes_.push_back({start.way + k * step, nodes_.back().time + step * slowness});
    }
    feed_ = next;
  }
}

double CutTime::at(double way) const {
  const auto next = std::lower_bound(nodes_.begin() + 1, nodes_.end() - 1, way,
                                     [](const Node& node, double at) { return node.way < at; });
  const Node& before = *(next - 1);
  return before.time + (next->time - before.time) * (way - before.way) / (next->way - before.way);
}

void expect_cut(const std::vector<CutCycle>& cycles, const CutTime& wanted, FeedOf feed_of) {
  ASSERT_GE(cycles.size(), 2U);
  EXPECT_TRUE(cycles.back().is_last);
  const double late_s = feed_of == FeedOf::revolution ? cycle_s : 0.0;
  const double late_mm = late_s * wanted.variation();
  const double feed_at_end = cycles[cycles.size() - 2].process.feed_mm_per_min / s_per_min;
  EXPECT_NEAR(cycles.back().way, wanted.way(), increment_mm);  // chords, even over corners
  EXPECT_NEAR(cycles.back().time_s, wanted.total(), cycle_s + ramps_s + late_mm / feed_at_end);
  for (const CutCycle& one : cycles) {
    if (one.is_last) break;
    const double feed = one.process.feed_mm_per_min / s_per_min;
    EXPECT_NEAR(wanted.at(one.way) * feed, one.time_s * feed, increment_mm + late_mm)
        << "after " << one.time_s << " s at " << one.way << " mm";
    if (::testing::Test::HasFailure()) return;
  }
}

std::string word_unless_zero(const char* name, double value) {
  return value == 0.0 ? "" : " " + std::string(name) + "=" + std::to_string(value);
}

double speed_of_cut(double m_per_min, double diameter, double n_min, double n_max) {
  const double wanted = 1000.0 * m_per_min / (std::numbers::pi * diameter);
  return std::max(n_min, std::min(n_max, wanted));
}

}  // namespace stanok::testing

// The feed that force control asks for in place of the programmed one: it is what the path goes at,
// within the limits, and rapid moves do not know of it.
#include <gtest/gtest.h>

#include "tests/motion/path_samples.h"

namespace stanok::motion::testing {
namespace {

FeedControl controlled(double feed_per_s, double feed_max_per_s = 300.0) {
  return {.controlled_per_s = feed_per_s,
          .controlled_max_per_s = feed_max_per_s,
          .controlled_axes = 0b111};
}

std::vector<double> cruising_speeds(const std::vector<Sample>& samples, double from, double to) {
  std::vector<double> speeds;
  for (const Sample& sample : samples)
    if (sample.s > from && sample.s < to) speeds.push_back(sample.out.s_speed);
  return speeds;
}

TEST(ControlledFeed, IsTheFeedOfThePathAboveAndBelowTheProgrammedOne) {
  for (const double feed : {5.0, 60.0, 140.0}) {
    ChainMaker chain(usual_limits);
    for (int k = 0; k < 30; ++k) chain.line(10.0, 60.0);
    chain.end_chain();
    const auto samples =
        run_path(three_axes(usual_limits), chain.built(), [&](int) { return controlled(feed); });
    for (const double speed : cruising_speeds(samples, 100.0, 200.0))
      EXPECT_NEAR(speed, feed, 1e-9);
  }
}

TEST(ControlledFeed, IsMultipliedByOverrideAndLawsOfTheCycle) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 30; ++k) chain.line(10.0, 60.0);
  chain.end_chain();
  const auto samples = run_path(three_axes(usual_limits), chain.built(), [&](int) {
    FeedControl control = controlled(40.0);
    control.feed_override = 1.5;
    control.law_part = 0.5;
    return control;
  });
  for (const double speed : cruising_speeds(samples, 100.0, 200.0)) EXPECT_NEAR(speed, 30.0, 1e-9);
}

TEST(ControlledFeed, DoesNotExceedTheFeedOfALawOfTheBlock) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 30; ++k) chain.line(10.0, 60.0);
  chain.end_chain();
  std::vector<PathBuilder::Built> built = chain.built();
  for (PathBuilder::Built& one : built) one.segment.process.kind = LawKind::linear;
  for (const auto& [asked, expected] : {std::pair{90.0, 60.0}, std::pair{20.0, 20.0}}) {
    const auto samples = run_path(three_axes(usual_limits), built,
                                  [asked = asked](int) { return controlled(asked); });
    for (const double speed : cruising_speeds(samples, 100.0, 200.0))
      EXPECT_NEAR(speed, expected, 1e-9);
  }
}

TEST(ControlledFeed, LeavesOtherAxesAlone) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 10; ++k) chain.line(10.0, 60.0);
  chain.end_chain();
  std::vector<PathBuilder::Built> built = chain.built();
  for (PathBuilder::Built& one : built) one.segment.geometry.metric.axes = 0b1000;  // rotary alone
  const auto samples =
      run_path(three_axes(usual_limits), built, [](int) { return controlled(20.0); });
  for (const double speed : cruising_speeds(samples, 30.0, 70.0)) EXPECT_NEAR(speed, 60.0, 1e-9);
}

// Whatever the control asks for: rapid moves are run as they were planned.
TEST(ControlledFeed, LeavesRapidMovesToTheirPlan) {
  ChainMaker chain(usual_limits);
  chain.line(100.0, 60.0).as_rapid().end_chain();
  const auto plain = run_path(three_axes(usual_limits), chain.built());
  const auto under = run_path(three_axes(usual_limits), chain.built(), [](int) {
    return FeedControl{
        .controlled_per_s = 20.0, .controlled_max_per_s = 300.0, .controlled_axes = 0b111};
  });
  ASSERT_EQ(plain.size(), under.size());
  for (std::size_t k = 0; k < plain.size(); ++k)
    EXPECT_EQ(plain[k].out.axes[0].value, under[k].out.axes[0].value);
}

// A feed that changes in every cycle, on segments of random lengths and limits: within the limits
// of the axis, and exactly to the end.
TEST(ControlledFeed, KeepsTheLimitsWhateverIsAskedFor) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker chain(usual_limits);
    for (int k = 0; k < 120; ++k) {
      const double length = std::pow(10.0, 3.0 * part(random) - 1.5);
      const double kind = part(random);
      if (kind < 0.3) {
        chain.slow_line(length, 60.0, {.v = 20.0 + 300.0 * part(random), .a = 900.0, .j = 2e4});
      } else {
        chain.line(length, 5.0 + 150.0 * part(random));
      }
      if (kind > 0.9) chain.as_rapid();
      if (part(random) < 0.05) chain.end_chain();
    }
    chain.end_chain();
    double asked = 50.0;
    double highest = 300.0;
    const auto samples = run_path(three_axes(usual_limits), chain.built(), [&](int) {
      asked = std::clamp(asked * std::exp(0.02 * (part(random) - 0.5)), 5.0, 290.0);
      if (part(random) < 0.01) asked = 5.0 + 285.0 * part(random);
      highest = std::clamp(highest + part(random) - 0.5, 290.0, 320.0);
      return controlled(asked, highest);
    });
    double speed_max = 0.0;
    double acceleration_max = 0.0;
    double jerk_max = 0.0;
    for (const Sample& sample : samples) {
      speed_max = std::max(speed_max, std::abs(sample.out.axes[0].first));
      acceleration_max = std::max(acceleration_max, std::abs(sample.out.axes[0].second));
      jerk_max = std::max(jerk_max, std::abs(sample.out.axes[0].third));
    }
    EXPECT_LE(speed_max, usual_limits.v * 1.000001);
    EXPECT_LE(acceleration_max, usual_limits.a * 1.000001);
    EXPECT_LE(jerk_max, usual_limits.j * 1.000001);
    EXPECT_EQ(samples.back().out.state, PathState::idle);
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
  }
}

}  // namespace
}  // namespace stanok::motion::testing

// The controller against steady-state errors known in closed form, on drives simple enough to be
// solved by hand.
#include "motion/threads/position_controller.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/motion/path_samples.h"
#include "tests/support/cycle.h"
#include "tests/support/no_allocation.h"

namespace stanok::motion::testing {
namespace {

using stanok::testing::cycle_s;
constexpr double no_limit = 1e9;

// A drive that has the velocity it is asked for at once, or with a lag: v' = (U + drift - v) / lag.
struct LaggingDrive {
  double lag_s = 0.0;
  double drift = 0.0;
  double position = 0.0;
  double velocity = 0.0;

  void run(double demand) {
    const double target = demand + drift;
    const double before = velocity;
    const double remaining = lag_s > 0.0 ? std::exp(-cycle_s / lag_s) : 0.0;
    velocity = target + (before - target) * remaining;
    position += target * cycle_s + (before - target) * lag_s * (1.0 - remaining);
  }
};

// A setpoint with constant jerk that begins at 0.
struct ConstantJerk {
  double velocity = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;

  [[nodiscard]] kinematics::Jet at(double t) const {
    return {t * (velocity + t * (acceleration / 2.0 + t * jerk / 6.0)),
            velocity + t * (acceleration + t * jerk / 2.0), acceleration + t * jerk, jerk};
  }
};

// Following error at the cycle instant after `seconds`.
double error_after(double seconds, PositionController controller, const ConstantJerk& course,
                   LaggingDrive drive) {
  const int cycles = static_cast<int>(std::lround(seconds / cycle_s));
  drive.velocity = course.velocity;
  for (int n = 0; n < cycles; ++n) {
    const kinematics::Jet setpoint = course.at(n * cycle_s);
    const double error = setpoint.value - drive.position;
    drive.run(controller.demand(error, coming_rates(setpoint, cycle_s)));
  }
  return course.at(cycles * cycle_s).value - drive.position;
}

TEST(PositionController, EveryTermIsItsGainTimesItsQuantity) {
  const SetpointRates rates{.velocity = 30.0, .acceleration = -400.0, .jerk = 5000.0};
  struct Case {
    const char* name;
    ControllerGains gains;
    double expected;  // after the errors 0.5 and 0.2
  };
  const Case cases[] = {
      {"kp", {.kp = 40.0, .kv = 0.0}, 40.0 * 0.2},
      {"kd", {.kd = 7.0, .kv = 0.0}, 7.0 * (0.2 - 0.5)},
      {"kint", {.kint = 3.0, .kv = 0.0}, 3.0 * (0.5 + 0.2)},
      {"kv", {.kv = 0.9}, 0.9 * 30.0},
      {"ka", {.kv = 0.0, .ka = 0.002}, 0.002 * -400.0},
      {"kr", {.kv = 0.0, .kr = 1e-5}, 1e-5 * 5000.0},
      {"all",
       {.kp = 40.0, .kd = 7.0, .kint = 3.0, .kv = 0.9, .ka = 0.002, .kr = 1e-5},
       8.0 - 2.1 + 2.1 + 27.0 - 0.8 + 0.05},
  };
  for (const Case& one : cases) {
    PositionController controller(one.gains, no_limit);
    static_cast<void>(controller.demand(0.5, rates));
    EXPECT_NEAR(controller.demand(0.2, rates), one.expected, 1e-12) << one.name;
  }
}

TEST(PositionController, FirstCycleHasNoChangeOfError) {
  PositionController controller({.kd = 1000.0, .kv = 0.0}, no_limit);
  EXPECT_EQ(controller.demand(0.5, {}), 0.0);
}

// v / kp: the error that drives the axis at v.
TEST(PositionController, ProportionalLoopLagsByVelocityOverGain) {
  for (const double v : {0.01, 10.0, 100.0, -200.0}) {
    const PositionController controller({.kp = 40.0, .kv = 0.0}, no_limit);
    EXPECT_NEAR(error_after(2.0, controller, {.velocity = v}, {}), v / 40.0, 1e-9 * std::abs(v));
  }
}

TEST(PositionController, ShareOfVelocityThatIsNotFedForwardIsLeftAsError) {
  const PositionController controller({.kp = 40.0, .kv = 0.9}, no_limit);
  EXPECT_NEAR(error_after(2.0, controller, {.velocity = 100.0}, {}), 0.1 * 100.0 / 40.0, 1e-9);
}

// A drive with the lag L follows a parabola when U = v + L a; what is missing comes from the error:
// L a / kp, whatever the cycle.
TEST(PositionController, ParabolaLeavesLagTimesAccelerationOverGain) {
  const ConstantJerk course{.velocity = -100.0, .acceleration = 500.0};
  const LaggingDrive drive{.lag_s = 0.004};
  const PositionController without({.kp = 40.0}, no_limit);
  EXPECT_NEAR(error_after(1.0, without, course, drive), 0.004 * 500.0 / 40.0, 1e-9);
  const PositionController with({.kp = 40.0, .ka = 0.004}, no_limit);
  EXPECT_NEAR(error_after(1.0, with, course, drive), 0.0, 1e-9);
}

// An error that grows steadily (L J t / kp) needs its own rate to be fed forward: kr stands for
// what drives of higher order ask for beyond ka.
TEST(PositionController, JerkActsThroughItsGain) {
  const ConstantJerk course{.jerk = 2000.0};
  const LaggingDrive drive{.lag_s = 0.004};
  const PositionController without({.kp = 40.0, .ka = 0.004}, no_limit);
  const PositionController with({.kp = 40.0, .ka = 0.004, .kr = 1e-4}, no_limit);
  EXPECT_NEAR(error_after(1.0, with, course, drive) - error_after(1.0, without, course, drive),
              -1e-4 * 2000.0 / 40.0, 1e-9);
}

TEST(PositionController, SumOfErrorsTakesOverWhatADriftLeaves) {
  const LaggingDrive drifting{.drift = 2.0};
  const PositionController without({.kp = 40.0}, no_limit);
  EXPECT_NEAR(error_after(5.0, without, {.velocity = 10.0}, drifting), -2.0 / 40.0, 1e-9);
  const PositionController with({.kp = 40.0, .kint = 0.2}, no_limit);
  EXPECT_NEAR(error_after(5.0, with, {.velocity = 10.0}, drifting), 0.0, 1e-9);
}

// 6 m/min and 1 ms: a setpoint of the end of the cycle against a position of its start keeps the
// axis ahead by one cycle's way, 100 um.
TEST(PositionController, ErrorOfTwoInstantsCostsTheWayOfTheTimeBetween) {
  const ConstantJerk course{.velocity = 100.0};
  const auto lead = [&](int shift) {
    PositionController controller({.kp = 40.0}, no_limit);
    LaggingDrive drive{.velocity = 100.0};
    for (int n = 0; n < 2000; ++n) {
      const double error = course.at((n + shift) * cycle_s).value - drive.position;
      drive.run(controller.demand(error, coming_rates(course.at(n * cycle_s), cycle_s)));
    }
    return drive.position - course.at(2000 * cycle_s).value;
  };
  EXPECT_NEAR(lead(0), 0.0, 1e-9);
  EXPECT_NEAR(lead(1), 0.1, 1e-9);
}

// V of the cycle that is over instead of the one to come: a T is missing in U.
TEST(PositionController, VelocityOfTheCycleBeforeCostsAccelerationTimesCycleOverGain) {
  const ConstantJerk course{.acceleration = 500.0};
  PositionController controller({.kp = 40.0}, no_limit);
  LaggingDrive drive;
  for (int n = 0; n < 1000; ++n) {
    const double error = course.at(n * cycle_s).value - drive.position;
    drive.run(controller.demand(error, coming_rates(course.at((n - 1) * cycle_s), cycle_s)));
  }
  EXPECT_NEAR(course.at(1.0).value - drive.position, 500.0 * cycle_s / 40.0, 1e-9);
}

TEST(PositionController, DemandStaysWithinItsLimit) {
  PositionController controller({.kp = 40.0, .kd = 10.0, .kint = 1.0, .ka = 0.01}, 120.0);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int n = 0; n < 10000; ++n) {
    const SetpointRates rates{.velocity = 200.0 * value(random),
                              .acceleration = 9e3 * value(random)};
    ASSERT_LE(std::abs(controller.demand(5.0 * value(random), rates)), 120.0);
  }
}

// The sum may grow until U is at its limit of 100: to 100 / 1, less what kp gives. An error of -1
// then asks for 100 - 2 * 5 at most; a sum that had wound up to 10000 would stay at the limit.
TEST(PositionController, LeavesItsLimitAsSoonAsTheErrorTurns) {
  for (const double side : {1.0, -1.0}) {
    PositionController controller({.kp = 5.0, .kint = 1.0, .kv = 0.0}, 100.0);
    for (int n = 0; n < 1000; ++n) static_cast<void>(controller.demand(side * 10.0, {}));
    EXPECT_EQ(controller.demand(side * 10.0, {}), side * 100.0);
    const double demand = side * controller.demand(side * -1.0, {});
    EXPECT_LT(demand, 90.0);
    EXPECT_GT(demand, 0.0);  // what was summed up within the limit is kept
  }
}

// A step of 1 mm with U limited to 1 mm/s takes a second of travel; a sum that is wound up
// meanwhile would carry the axis far beyond.
TEST(PositionController, AxisThatTravelsAtTheLimitDoesNotOvershootByItsSum) {
  PositionController controller({.kp = 40.0, .kint = 0.2}, 1.0);
  LaggingDrive drive;
  double highest = 0.0;
  for (int n = 0; n < 3000; ++n) {
    drive.run(controller.demand(1.0 - drive.position, {}));
    highest = std::max(highest, drive.position);
  }
  EXPECT_NEAR(drive.position, 1.0, 1e-6);
  EXPECT_LT(highest, 1.0 + 1.0 / 40.0);  // within the way on which kp alone leaves the limit
}

TEST(PositionController, ResetMakesItNew) {
  const ControllerGains gains{.kp = 31.0, .kd = 2.0, .kint = 0.3, .ka = 0.001};
  PositionController used(gains, 200.0);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> error(-0.1, 0.1);
  for (int n = 0; n < 500; ++n) static_cast<void>(used.demand(0.05 + error(random), {}));
  used.reset();
  PositionController fresh(gains, 200.0);
  for (int n = 0; n < 500; ++n) {
    const double each = error(random);
    ASSERT_EQ(used.demand(each, {.velocity = 1.0}), fresh.demand(each, {.velocity = 1.0}));
  }
}

TEST(PositionController, AllocatesNothing) {
  PositionController controller({.kp = 40.0, .kint = 0.1}, 100.0);
  CodeDifferences differences(0, 0.001, cycle_s);
  const stanok::testing::NoAllocation guard;
  static_cast<void>(controller.demand(0.1, differences.advance(7)));
  controller.reset();
}

// The mean of a derivative over the cycle is the change of the quantity before it.
TEST(ComingRates, AreTheMeansOverTheCycleWhileTheJerkIsConstant) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int n = 0; n < 1000; ++n) {
    const ConstantJerk course{400.0 * value(random), 4000.0 * value(random), 1e5 * value(random)};
    const SetpointRates rates = coming_rates(course.at(0.0), cycle_s);
    const kinematics::Jet end = course.at(cycle_s);
    EXPECT_NEAR(rates.velocity, end.value / cycle_s, 1e-10);
    EXPECT_NEAR(rates.acceleration, (end.first - course.velocity) / cycle_s, 1e-8);
    EXPECT_NEAR(rates.jerk, (end.second - course.acceleration) / cycle_s, 1e-5);
  }
}

// Within one cycle of a run the jerk changes by at most 2 j, where a chain ends included.
TEST(ComingRates, ErrByTheStepOfJerkTimesASixthOfTheSquaredCycleAtMost) {
  const Limits limits;
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  for (int each = 0; each < 20; ++each) {
    ChainMaker chain(limits);
    for (int n = 0; n < 20; ++n) {
      chain.line(0.05 + 8.0 * value(random), 5.0 + 300.0 * value(random));
      if (value(random) < 0.2) chain.end_chain();
    }
    chain.end_chain();
    const auto samples = run_path(three_axes(limits), chain.built());
    for (std::size_t n = 2; n < samples.size(); ++n) {
      const kinematics::Jet& before = samples[n - 1].out.axes[0];
      const kinematics::Jet& now = samples[n].out.axes[0];
      const SetpointRates rates = coming_rates(before, cycle_s);
      ASSERT_NEAR(rates.velocity, (now.value - before.value) / cycle_s,
                  2.0 * limits.j * cycle_s * cycle_s / 6.0 + 1e-9)
          << "chain " << each << ", cycle " << n;
    }
  }
}

// Differences of the cubes 0, 1, 8, 27, ...: 3 n^2 - 3 n + 1, 6 n - 6 and 6.
TEST(CodeDifferences, OfCubesAreThoseOfTheTextbook) {
  CodeDifferences differences(0, 0.5, 0.1);
  for (int n = 1; n < 10; ++n) {
    const SetpointRates rates = differences.advance(std::int64_t{n} * n * n);
    EXPECT_NEAR(rates.velocity, (3 * n * n - 3 * n + 1) * 0.5 / 0.1, 1e-9);
    if (n < 3) continue;
    EXPECT_NEAR(rates.acceleration, (6 * n - 6) * 0.5 / 0.01, 1e-9);
    EXPECT_NEAR(rates.jerk, 6 * 0.5 / 0.001, 1e-6);
  }
}

}  // namespace
}  // namespace stanok::motion::testing

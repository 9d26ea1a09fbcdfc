// Requests that come late, in another order or twice: what begins motion has the age of what its
// asker saw, and a jog under a lease has one session.
#include "channels/coordinator/request_gate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using stanok::testing::MachineBench;

constexpr std::int64_t age_max = 500;  // cycles of 1 ms
constexpr double increment = 0.01;     // mm
constexpr int renewed = 0;

class RequestGateTest : public ::testing::Test {
 protected:
  RequestGateTest() { cycles(20); }

  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  std::int64_t now() { return bench.output().cycle; }
  double x() { return bench.channel(1).axes[0].position; }

  OperatorEvent event(OperatorCommand command, std::int64_t seen, std::int32_t session = 1) {
    OperatorEvent made;
    made.command = std::move(command);
    made.channel = 1;
    made.seen_cycle = seen;
    made.session = session;
    return made;
  }
  static OperatorCommand jog(double way, std::string_view axis = "X", double velocity = 10.0) {
    return commands::Jog{ShortText(axis), velocity, way, JogFrame::machine};
  }
  // Its code, empty where it was taken.
  std::string ask(const OperatorEvent& asked) {
    const std::size_t before = bench.replies().size();
    bench.ask(asked);
    for (int n = 0; n < 3 && bench.replies().size() == before; ++n) bench.cycle();
    return bench.replies().size() == before ? "no reply"
                                            : std::string(bench.replies().back().code.view());
  }

  MachineBench bench;
};

TEST_F(RequestGateTest, WhatBeginsMotionMayBeHalfASecondOld) {
  cycles(1000);
  EXPECT_EQ(ask(event(jog(1.0), now() + 1 - age_max)), "");
  cycles(1000);
  EXPECT_EQ(ask(event(jog(1.0), now() - age_max)), "E6073");
  cycles(1000);
  EXPECT_NEAR(x(), 1.0, 1e-9);
  EXPECT_EQ(ask(event(jog(1.0), -1)), "") << "of event files";
}

// Each way in which an operator lets something move.
TEST_F(RequestGateTest, HoldsForAllThatLetsAxesMove) {
  bench.program("p.nc", "G1 X100 F600\nM30\n");
  cycles(1000);
  const std::int64_t old = now() - age_max - 1;
  EXPECT_EQ(ask(event(commands::MachineOn{}, old)), "E6073");
  EXPECT_EQ(ask(event(commands::Home{}, old)), "E6073");
  EXPECT_EQ(ask(event(commands::Mdi{{}}, old)), "E6073");
  EXPECT_EQ(ask(event(commands::ProgramRun{ShortText("p.nc")}, old)), "E6073");
  EXPECT_EQ(ask(event(commands::ProgramRun{ShortText("p.nc")}, now())), "");
  cycles(500);
  EXPECT_EQ(ask(event(commands::OverrideFeed{0.0}, old)), "") << "that stops";
  cycles(500);
  const double held = x();
  EXPECT_EQ(ask(event(commands::OverrideFeed{0.5}, old)), "E6073");
  EXPECT_EQ(ask(event(commands::ProgramHold{}, old)), "");
  EXPECT_EQ(ask(event(commands::ProgramResume{}, old)), "E6073");
  EXPECT_EQ(ask(event(commands::ProgramStart{}, old)), "E6073");
  cycles(1000);
  EXPECT_EQ(x(), held);
  EXPECT_EQ(ask(event(commands::ProgramReset{}, old)), "");
}

// What was on its way while the control stood still.
TEST_F(RequestGateTest, CountsTimeWithoutCycles) {
  RequestGate gate(0.001, 0.5);
  gate.note_gap(2000, 400);
  EXPECT_FALSE(gate.refusal_of(event(jog(1.0), 1999), 2000, nullptr, -1));
  EXPECT_FALSE(gate.refusal_of(event(jog(1.0), 1999), 2099, nullptr, -1));
  EXPECT_TRUE(gate.refusal_of(event(jog(1.0), 1999), 2100, nullptr, -1));
  EXPECT_FALSE(gate.refusal_of(event(jog(1.0), 2000), 2100, nullptr, -1));
  for (int cycle = 2200; cycle < 2400; ++cycle) gate.note_gap(cycle, 1);
  EXPECT_FALSE(gate.refusal_of(event(jog(1.0), 2200), 2400, nullptr, -1)) << "400 ms at most";
  gate.note_gap(3000, 11'000);
  EXPECT_TRUE(gate.refusal_of(event(jog(1.0), 2999), 3000, nullptr, -1));
  EXPECT_FALSE(gate.refusal_of(event(jog(1.0), 3000), 3001, nullptr, -1));
}

TEST_F(RequestGateTest, AJogBelongsToOneSessionUntilItEnds) {
  EXPECT_EQ(ask(event(jog(renewed), now(), 1)), "");
  cycles(100);
  EXPECT_EQ(ask(event(jog(renewed, "X", -10.0), now(), 2)), "E6056");
  EXPECT_EQ(ask(event(jog(renewed, "Y"), now(), 2)), "E6056");
  EXPECT_EQ(ask(event(jog(renewed), now(), 1)), "") << "its own renewal";
  cycles(1000);
  EXPECT_EQ(ask(event(jog(renewed, "X", -10.0), now(), 2)), "") << "the lease is over";
}

// A renewal begins nothing, so that a slow network does not end a jog; behind its end it is a jog.
TEST_F(RequestGateTest, ARenewalHasNoAgeWhileItsJogLasts) {
  const std::int64_t begun = now();
  for (int n = 0; n < 20; ++n) {
    EXPECT_EQ(ask(event(jog(renewed), begun)), "");
    cycles(100);
  }
  cycles(1000);
  const double at = x();
  EXPECT_GT(at, 15.0);
  EXPECT_EQ(ask(event(jog(renewed), begun)), "E6073");
  EXPECT_EQ(x(), at);
}

// A network that keeps, doubles and reorders: of 10,000 requests none moves an axis that is older.
TEST_F(RequestGateTest, NothingMovesThatIsOlderByChance) {
  std::mt19937_64 random(20261129);
  std::multimap<std::int64_t, std::int64_t> on_the_way;  // when it comes: what was seen
  int sent = 0;
  int taken = 0;
  int refused = 0;
  while (sent < 10'000 || !on_the_way.empty()) {
    if (sent < 10'000 && random() % 4 == 0) {
      const int copies = random() % 10 == 0 ? 2 : 1;
      for (int copy = 0; copy < copies; ++copy)
        on_the_way.emplace(now() + static_cast<std::int64_t>(random() % 1000), now());
      ++sent;
    }
    const auto come = on_the_way.find(now());
    if (come == on_the_way.end()) {
      std::erase_if(on_the_way, [&](const auto& one) { return one.first < now(); });
      bench.cycle();
      continue;
    }
    const std::int64_t seen = come->second;
    on_the_way.erase(come);
    const bool is_old = now() + 1 - seen > age_max;
    const double before = x();
    const std::string code = ask(event(jog(increment, "X", 250.0), seen));
    if (is_old) {
      ASSERT_EQ(code, "E6073");
    } else {
      ASSERT_TRUE(code.empty() || code == "E6056") << code;
    }
    (code.empty() ? taken : refused) += 1;
    if (code.empty()) {
      cycles(30);
      ASSERT_NEAR(x(), before + increment, 1e-9);
    }
  }
  EXPECT_GT(taken, 1000);
  EXPECT_GT(refused, 1000);
  EXPECT_NEAR(x(), taken * increment, 1e-6);
}

// More answers in one cycle than anybody could take: those without room are counted.
TEST_F(RequestGateTest, RepliesWithoutRoomAreCounted) {
  EXPECT_EQ(bench.machine().replies_lost(), 0U);
  const std::size_t before = bench.replies().size();
  constexpr std::size_t asked = 300;
  for (std::size_t n = 0; n < asked; ++n) bench.ask(event(commands::OverrideFeed{1.0}, now()));
  cycles(3);
  const std::size_t answered = bench.replies().size() - before;
  EXPECT_LT(answered, asked);
  EXPECT_EQ(bench.machine().replies_lost(), asked - answered);
}

}  // namespace
}  // namespace stanok::channels

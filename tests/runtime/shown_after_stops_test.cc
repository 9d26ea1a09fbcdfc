// What is shown leads where the axes stand, after each way to stop and to change something: typed
// back, it moves nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chain/operator_session.h"
#include "tests/support/sanitized.h"

namespace stanok::testing {
namespace {

using channels::OperatorAction;

class Shown : public ::testing::TestWithParam<HandPlace> {
 protected:
  // One of the ways, from what an operator has typed; false: the machine did not take it.
  using Way = std::function<bool(OperatorSession&, Choices&)>;

  // After each session and the way that `way` goes on: the words, typed back, move nothing.
  void type_back_after(const Way& way, std::uint64_t first_seed, int sessions = 20) {
    const channels::MachineConfig machine = GetParam().config();
    int tried = 0;
    for (int seed = 0; seed < cases(sessions); ++seed) {
      SeededChoices choices(static_cast<std::uint64_t>(seed) + first_seed);
      OperatorSession session(machine, GetParam().channel, choices);
      session.type(1 + static_cast<int>(choices.below(8)));
      if (!way(session, choices)) continue;
      ++tried;
      expect_typed_back(session.bench(), "seed " + std::to_string(seed) + "\n" + session.text());
      if (HasFailure()) return;
    }
    EXPECT_GE(3 * tried, cases(sessions));
  }

  static void expect_typed_back(HandBench& bench, const std::string& what) {
    const ChannelLeft before = bench.left();
    const std::string back = bench.typed_back();
    ASSERT_EQ(bench.type(back), "") << back << "\n" << what;
    const ChannelLeft after = bench.left();
    for (std::size_t k = 0; k < before.axes_M.size(); ++k)
      EXPECT_NEAR(after.axes_M[k], before.axes_M[k], 1e-9) << back << "\n" << what;
  }

  // Begins the lines of the session as a program on a machine that is set up anew, and lets a
  // random time pass.
  static void begin(OperatorSession& session, Choices& choices, const std::string& end = "M30") {
    session.forget();
    session.bench().begin(session.text() + "G4 P0.01\n" + end + "\n", choices.below(1500));
  }
};

bool asked(OperatorSession& session, OperatorAction action, int number = 0) {
  return session.bench().ask({.action = action, .number = number}).empty();
}

TEST_P(Shown, AfterLines) {
  type_back_after([](OperatorSession&, Choices&) { return true; }, 5200, 40);
}

TEST_P(Shown, AfterTheEndOfAProgram) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        begin(session, choices, choices.chance(0.5) ? "M30" : "M2");
        session.bench().settle();
        return true;
      },
      5210);
}

TEST_P(Shown, AfterAStopAndAReset) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        begin(session, choices);
        const bool stops = choices.chance(0.5);
        const bool taken =
            asked(session, stops ? OperatorAction::program_stop : OperatorAction::program_reset);
        session.bench().settle();
        return taken;
      },
      5220);
}

TEST_P(Shown, AfterAHoldThatEndsInAStop) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        begin(session, choices);
        if (!asked(session, OperatorAction::program_hold)) return false;
        if (choices.chance(0.5)) {
          session.bench().bench().ask(OperatorAction::program_resume, GetParam().channel);
          session.bench().pass(choices.below(200));
        }
        return asked(session, OperatorAction::program_reset);
      },
      5230);
}

TEST_P(Shown, AfterAStopInTheProgram) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        begin(session, choices, "M0\nG91 G0 Z1\nM30");
        session.bench().settle();
        return asked(session, OperatorAction::program_stop);
      },
      5240);
}

TEST_P(Shown, AfterAnAlarmOfTheProgram) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        begin(session, choices,
              choices.chance(0.5) ? "G90 G53 G0 X99999" : "terminate (1030, \"enough\");");
        session.bench().settle();
        return session.bench().has_alarm() && asked(session, OperatorAction::program_reset);
      },
      5250);
}

TEST_P(Shown, AfterAnEmergencyStop) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        begin(session, choices);
        if (!asked(session, OperatorAction::machine_estop)) return false;
        session.bench().settle();
        return asked(session, OperatorAction::program_reset) &&
               asked(session, OperatorAction::machine_on);
      },
      5260);
}

TEST_P(Shown, AfterPowerOffAndOn) {
  type_back_after(
      [](OperatorSession& session, Choices&) {
        return asked(session, OperatorAction::machine_off) &&
               asked(session, OperatorAction::machine_on);
      },
      5270);
}

TEST_P(Shown, AfterAnOperatorWroteAnOffset) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        const std::string row = "G" + std::to_string(54 + choices.below(3));
        const channels::MachineConfig& machine = session.bench().machine();
        const std::string axis = machine.axes[session.bench().channel().axes[0]].name;
        return session.bench()
            .ask({.action = OperatorAction::offset_set,
                  .value = choices.between(-5.0, 5.0),
                  .text = std::string_view(row + " " + axis)})
            .empty();
      },
      5280);
}

TEST_P(Shown, AfterAnOperatorWroteATool) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        const auto& tools = session.bench().machine().tables.tools;
        const channels::ToolEdge& tool = tools[choices.below(tools.size())];
        return session.bench()
            .ask({.action = OperatorAction::tool_set,
                  .number = tool.number,
                  .value = choices.between(1.0, 60.0),
                  .value_2 = static_cast<double>(tool.edge),
                  .text = std::string_view("length")})
            .empty();
      },
      5290);
}

TEST_P(Shown, AfterAnotherScheme) {
  type_back_after(
      [](OperatorSession& session, Choices& choices) {
        const auto& schemes = session.bench().channel().schemes;
        const int id = schemes[choices.below(schemes.size())].id;
        return asked(session, OperatorAction::kinematics_select, id);
      },
      5300);
}

TEST_P(Shown, AfterARestart) {
  type_back_after(
      [](OperatorSession& session, Choices&) {
        session.restart();
        return true;
      },
      5310);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Shown, ::testing::ValuesIn(hand_places()),
                         [](const auto& tested) { return tested.param.name(); });

}  // namespace
}  // namespace stanok::testing

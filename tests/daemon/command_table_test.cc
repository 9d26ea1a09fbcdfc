// Every command in every situation of a channel, as the table of channels/contract/command_rules.h
// says: what a daemon answers, and what docs/operator/at-the-machine.md prints. After a change of
// either table write the document anew with
//   STANOK_WRITE_DOCS=1 build/release/tests/daemon_tests --gtest_filter='CommandTableDocument.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "channels/contract/command_rules.h"
#include "channels/contract/operator_action.h"
#include "tests/daemon/daemon_bench.h"
#include "tests/daemon/desk/accepted_parameters.h"
#include "tests/support/project_folders.h"
#include "tests/support/sanitized.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using channels::Situation;
using nlohmann::json;

// Long enough to be at its feed, 100 mm/s, whenever a test looks.
constexpr const char* long_program = "G90 G54\nG1 X700 F6000\nX0\nX700\nM30\n";

// Channel 1 in a situation; nothing else of the machine moves.
class Scene {
 public:
  explicit Scene(Situation situation) {
    bench.program("long.nc", long_program);
    bench.program("wrong.nc", "G90 G54\nterminate (1006, \"no blank\");\nM30\n");
    if (situation == Situation::off) return;
    bench.demand("machine.on");
    bench.cycles(300);  // until the drives hold their axes
    switch (situation) {
      case Situation::off:
      case Situation::idle:
        break;
      case Situation::ready:
        bench.demand("program.load", {{"program", "long.nc"}});
        break;
      case Situation::by_hand:
        bench.demand("jog", {{"axis", "X"}, {"velocity", 20.0}});
        bench.cycles(50);
        break;
      case Situation::switching:
        static_cast<void>(bench.ask(0, "kinematics.select", {{"scheme", 2}}));
        bench.cycles(3);
        break;
      case Situation::running:
        run("long.nc");
        break;
      case Situation::held:
        run("long.nc");
        bench.demand("program.hold");
        bench.cycles(500);
        break;
      case Situation::aside:
        run("long.nc");
        bench.demand("program.hold");
        bench.cycles(500);
        bench.demand("jog", {{"axis", "Z"}, {"velocity", 5.0}, {"increment", 1.0}});
        bench.cycles(1000);
        break;
      case Situation::alarm:
        run("wrong.nc");
        break;
      case Situation::fault:
        bench.demand("machine.estop");
        bench.cycles(100);
        break;
      case Situation::ending:
        run("long.nc");
        static_cast<void>(bench.ask(0, "program.stop"));
        bench.cycle();
        break;
    }
  }

  // What the situation looks like from outside.
  void expect_state(channels::ChannelState state, bool moves, bool has_power) const {
    EXPECT_EQ(bench.channel(1).state, state);
    EXPECT_EQ(bench.channel(1).moving, moves);
    EXPECT_EQ(bench.channel(1).drives[0].enabled, has_power);
  }

  DaemonBench bench;

 private:
  void run(const std::string& program) {
    bench.demand("program.run", {{"program", program}});
    bench.cycles(500);
  }
};

// Values for what a row requires, from the row.
json required_parameters(const protocol::Method& method) {
  json parameters = json::object();
  for (const protocol::Parameter& parameter : method.parameters) {
    if (parameter.presence == protocol::Presence::optional) continue;
    if (parameter.choices.empty()) {
      parameters[std::string(parameter.name)] =
          std::clamp(1.0, parameter.minimum, parameter.maximum);
    } else {
      parameters[std::string(parameter.name)] = parameter.choices.front();
    }
  }
  return parameters;
}

// Parameters with which the method has an effect.
json parameters_of(const protocol::Method& method) {
  static const std::map<std::string_view, json> table = {
      {"program.load", {{"program", "long.nc"}}},
      {"program.run", {{"program", "long.nc"}}},
      {"program.search", {{"target", "3"}}},
      {"override.feed", {{"percent", 80}}},
      {"override.rapid", {{"percent", 80}}},
      {"override.spindle", {{"percent", 80}}},
      {"kinematics.select", {{"scheme", 2}}},
      {"tool.set", {{"number", 1}, {"key", "wear_length"}, {"value", 0.1}}},
      {"offset.set", {{"offset", "G54"}, {"axis", "X"}, {"value", 0.1}}},
      {"mdi", {{"text", "G4 P0.01"}}},
      {"jog", {{"axis", "Y"}, {"velocity", 5.0}}},
      {"handwheel", {{"axis", "Y"}, {"way", 0.1}}},
      {"process.interrupt", {{"la", 0.0}}},
      {"scope.start", {{"signals", "cycle.time"}}},
      {"process.automatic", {{"law", "linear"}, {"on", 1}}},
      {"process.adaptive", {{"action", "off"}}},
  };
  const auto row = table.find(method.name);
  return row == table.end() ? required_parameters(method) : row->second;
}

// Admitted, and of no use: the machine has no automatic feed law and no force control, when its
// drives are off no program is loaded here, and axes that were jogged away are not on a path.
bool has_no_object(std::string_view code) {
  return code == "E6030" || code == "E6060" || code == "E6005" || code == "E6097";
}

// The command table is read where the machine is not known: what it says of a method is what the
// machine holds of its action.
TEST(CommandTableEffects, AreThoseOfTheActions) {
  for (const protocol::Method& method : protocol::methods()) {
    SCOPED_TRACE(method.name);
    if (method.action.empty()) {
      EXPECT_NE(method.effect, protocol::Effect::stops) << "only the cycle stops";
      continue;
    }
    const auto action = channels::operator_action(method.action);
    ASSERT_TRUE(action.has_value());
    EXPECT_EQ(method.effect == protocol::Effect::stops, channels::is_stop(*action));
    EXPECT_EQ(method.effect == protocol::Effect::begins_motion, channels::begins_motion(*action));
  }
}

class CommandTable : public ::testing::TestWithParam<Situation> {};

TEST_P(CommandTable, IsWhatADaemonAnswers) {
  constexpr int answered_within = 40;  // cycles; what begins something answers later
  constexpr std::size_t step = testing::is_sanitized ? 5 : 1;
  const auto& methods = protocol::methods();
  for (std::size_t k = static_cast<std::size_t>(GetParam()) % step; k < methods.size(); k += step) {
    const protocol::Method& method = methods[k];
    if (method.action.empty()) continue;
    SCOPED_TRACE(method.name);
    const auto action = channels::operator_action(method.action);
    ASSERT_TRUE(action.has_value());
    const std::string_view wanted = channels::refusal_code(*action, GetParam());
    Scene scene(GetParam());
    const auto answer = scene.bench.answer(std::string(method.name), parameters_of(method),
                                           wanted.empty() ? answered_within : 1);
    if (!wanted.empty()) {
      ASSERT_TRUE(answer.has_value()) << "a refusal is told at once";
      ASSERT_FALSE(answer->has_value()) << "must be refused with " << wanted;
      EXPECT_EQ(answer->error().code, wanted);
      EXPECT_EQ(answer->error().kind, protocol::FailureKind::refused);
    } else if (answer.has_value() && !answer->has_value()) {
      EXPECT_TRUE(has_no_object(answer->error().code))
          << answer->error().code << " " << answer->error().message;
    }
  }
}

TEST_P(CommandTable, WhatOnlyLooksIsAnsweredAlways) {
  Scene scene(GetParam());
  for (const protocol::Method& method : protocol::methods()) {
    if (!method.action.empty() || method.role != protocol::Role::observer) continue;
    json parameters = json::object();
    if (method.name == "program.check" || method.name == "program.estimate") continue;  // long
    if (calculates(method)) continue;  // of a process file
    if (method.name == "tool.get") parameters["number"] = 1;
    if (method.name == "subscribe") parameters["topics"] = {"channels"};
    if (method.name == "session.role") parameters["role"] = "operator";
    if (method.name.starts_with("history.")) continue;  // files of logs, of which there are none
    if (method.name == "program.read") parameters["program"] = "long.nc";
    const auto slot = scene.bench.ask(1, std::string(method.name), parameters);
    while (!slot->has_value()) scene.bench.cycle();  // files are read in another thread
    EXPECT_TRUE((*slot)->has_value()) << method.name << ": " << (*slot)->error().message;
  }
}

INSTANTIATE_TEST_SUITE_P(Situations, CommandTable, ::testing::ValuesIn(channels::situations),
                         [](const auto& test) {
                           std::string name(channels::name_of(test.param));
                           std::erase(name, ' ');
                           return name;
                         });

// The scenes are what they are called.
TEST(CommandTableScenes, LookLikeTheirNames) {
  using channels::ChannelState;
  Scene(Situation::off).expect_state(ChannelState::idle, false, false);
  Scene(Situation::idle).expect_state(ChannelState::idle, false, true);
  Scene(Situation::ready).expect_state(ChannelState::ready, false, true);
  Scene(Situation::by_hand).expect_state(ChannelState::idle, true, true);
  Scene(Situation::running).expect_state(ChannelState::running, true, true);
  Scene(Situation::held).expect_state(ChannelState::held, false, true);
  Scene(Situation::aside).expect_state(ChannelState::held, false, true);
  Scene(Situation::alarm).expect_state(ChannelState::alarm, false, true);
  Scene(Situation::fault).expect_state(ChannelState::alarm, false, false);
  EXPECT_TRUE(Scene(Situation::ending).bench.channel(1).moving);
  EXPECT_EQ(Scene(Situation::switching).bench.channel(1).scheme, 1);
}

std::string cell(std::string_view code) {
  return code.empty() ? " ✓ |" : " " + std::string(code) + " |";
}

// Which channels the asker must not be kept from.
std::string word_for(channels::ControlScope scope) {
  switch (scope) {
    case channels::ControlScope::nothing:
      return "–";
    case channels::ControlScope::channel:
      return "this";
    case channels::ControlScope::all_channels:
      return "all";
  }
  return "";
}

std::string command_table() {
  std::string text = "| command |";
  std::string line = "|---|";
  for (const Situation situation : channels::situations) {
    text += " " + std::string(channels::name_of(situation)) + " |";
    line += "---|";
  }
  text += " control |\n" + line + "---|\n";
  for (const protocol::Method& method : protocol::methods()) {
    const auto action = channels::operator_action(method.action);
    if (!action) continue;
    std::string name(method.name);
    std::replace(name.begin(), name.end(), '.', ' ');
    text += "| `" + name + "` |";
    for (const Situation situation : channels::situations)
      text += cell(channels::refusal_code(*action, situation));
    text += " " + word_for(channels::control_scope(*action)) + " |\n";
  }
  return text;
}

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(CommandTableDocument, IsWhatTheManualPrints) {
  const std::string path = stanok::testing::source_folder() + "/docs/operator/at-the-machine.md";
  const std::string begin_mark =
      "<!-- commands: written by a test, see tests/daemon/command_table_test.cc -->\n";
  const std::string end_mark = "<!-- end of commands -->";
  const std::string wanted = "\n" + command_table() + "\n";
  std::string manual = file_text(path);
  ASSERT_NE(manual.find(begin_mark), std::string::npos);
  ASSERT_NE(manual.find(end_mark), std::string::npos);
  const std::size_t begin = manual.find(begin_mark) + begin_mark.size();
  const std::size_t end = manual.find(end_mark);
  ASSERT_LE(begin, end);
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) {
    std::ofstream(path) << manual.substr(0, begin) + wanted + manual.substr(end);
    manual = file_text(path);
  }
  EXPECT_EQ(manual.substr(begin, manual.find(end_mark) - begin), wanted)
      << "docs/operator/at-the-machine.md: write the table anew as described in this file";
}

}  // namespace
}  // namespace stanok::daemon

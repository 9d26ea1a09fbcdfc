// The command table: well-formed rows, and every method that the interfaces promise.
#include "protocol/contract/method_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace stanok::protocol {
namespace {

TEST(MethodTable, NamesEveryMethodOnce) {
  std::set<std::string_view> names;
  for (const Method& method : methods())
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
}

TEST(MethodTable, KeepsTheMethodsOfANounTogether) {
  std::set<std::string_view> closed;
  std::string_view open;
  for (const Method& method : methods()) {
    if (noun(method) == open) continue;
    EXPECT_TRUE(closed.insert(open).second);
    EXPECT_FALSE(closed.contains(noun(method))) << method.name;
    open = noun(method);
  }
}

TEST(MethodTable, ExplainsEveryRowEveryNounAndEveryParameter) {
  for (const Method& method : methods()) {
    EXPECT_FALSE(method.help.empty()) << method.name;
    EXPECT_TRUE(verb(method).empty() || !noun_help(noun(method)).empty()) << method.name;
    for (const Parameter& parameter : method.parameters) {
      EXPECT_FALSE(parameter.help.empty()) << method.name << " " << parameter.name;
      EXPECT_LE(parameter.minimum, parameter.maximum) << method.name << " " << parameter.name;
      const bool has_choices =
          parameter.type == ParameterType::choice || parameter.type == ParameterType::text_list;
      EXPECT_EQ(has_choices, !parameter.choices.empty()) << method.name << " " << parameter.name;
    }
  }
}

// Positional parameters by position: required ones first, or a list could not be taken.
TEST(MethodTable, PutsRequiredParametersFirst) {
  for (const Method& method : methods()) {
    bool seen_optional = false;
    for (const Parameter& parameter : method.parameters) {
      if (parameter.presence == Presence::optional) seen_optional = true;
      EXPECT_FALSE(seen_optional && parameter.presence == Presence::required) << method.name;
    }
  }
}

TEST(MethodTable, LetsObserversChangeNothing) {
  for (const Method& method : methods()) {
    EXPECT_EQ(method.effect == Effect::looks, method.role == Role::observer) << method.name;
    EXPECT_TRUE(method.action.empty() || method.effect != Effect::looks) << method.name;
  }
}

TEST(MethodTable, NamesWhatIsUsualAmongTheChoices) {
  for (const Method& method : methods()) {
    for (const Parameter& parameter : method.parameters) {
      EXPECT_TRUE(parameter.usual.empty() ||
                  std::ranges::find(parameter.choices, parameter.usual) != parameter.choices.end())
          << method.name << " " << parameter.name;
    }
  }
}

// `stanok` gives each channel in turn, and renews what has no increment.
TEST(MethodTable, HasTheParametersThatItsCoursesNeed) {
  const auto has = [](const Method& method, std::string_view name) {
    return std::ranges::any_of(method.parameters,
                               [&](const Parameter& one) { return one.name == name; });
  };
  for (const Method& method : methods()) {
    EXPECT_TRUE(method.reach != Reach::every_channel || has(method, "channel")) << method.name;
    EXPECT_TRUE(method.course != Course::repeats || has(method, "increment")) << method.name;
    EXPECT_TRUE(method.course != Course::holds || has(method, "on")) << method.name;
  }
}

TEST(MethodTable, HasTheMethodsOfTheOperatorsManual) {
  for (const char* name : {"machine.on",
                           "machine.off",
                           "machine.estop",
                           "machine.status",
                           "channel.list",
                           "channel.status",
                           "channel.watch",
                           "program.load",
                           "program.run",
                           "program.start",
                           "program.hold",
                           "program.resume",
                           "program.stop",
                           "program.reset",
                           "program.step",
                           "program.list",
                           "program.search",
                           "mdi",
                           "jog",
                           "home",
                           "override.feed",
                           "override.rapid",
                           "override.spindle",
                           "tool.list",
                           "tool.get",
                           "tool.set",
                           "tool.load",
                           "tool.save",
                           "offset.list",
                           "offset.set",
                           "kinematics.list",
                           "kinematics.select",
                           "kinematics.status",
                           "drive.list",
                           "drive.status",
                           "drive.reset",
                           "drive.fault",
                           "process.status",
                           "process.interrupt",
                           "process.adaptive",
                           "workpiece.status",
                           "workpiece.allow",
                           "alarm.list",
                           "alarm.ack",
                           "alarm.history",
                           "measurement.history",
                           "log.start",
                           "log.stop",
                           "log.status",
                           "subscribe",
                           "system.info",
                           "system.shutdown",
                           "rpc.discover"}) {
    EXPECT_NE(find_method(name), nullptr) << name;
  }
  EXPECT_EQ(find_method("program"), nullptr);
  EXPECT_EQ(find_method(""), nullptr);
}

TEST(MethodTable, SplitsNamesIntoNounAndVerb) {
  EXPECT_EQ(noun(*find_method("program.load")), "program");
  EXPECT_EQ(verb(*find_method("program.load")), "load");
  EXPECT_EQ(noun(*find_method("subscribe")), "subscribe");
  EXPECT_EQ(verb(*find_method("subscribe")), "");
}

}  // namespace
}  // namespace stanok::protocol

// Requests of the command table as events of the cycle.
#include "runtime/operator_request.h"

#include <gtest/gtest.h>

#include "channels/contract/operator_action.h"

namespace stanok::runtime {
namespace {

TEST(OperatorRequest, OfEveryMethodThatEntersTheCycleHasItsAction) {
  for (const protocol::Method& method : protocol::methods()) {
    if (method.action.empty()) continue;
    SCOPED_TRACE(method.name);
    protocol::MachineRequest request;
    request.action = method.action;
    request.channel = 2;
    for (const protocol::Parameter& parameter : method.parameters) {
      const bool is_named = parameter.carries == protocol::Carries::text;
      if (is_named && !parameter.choices.empty()) request.text = parameter.choices.back();
    }
    const auto event = operator_event(request);
    ASSERT_TRUE(event.has_value());
    EXPECT_EQ(channels::name_of(event->action()), method.action);
    EXPECT_EQ(event->channel, 2);
  }
}

// The choices of the table are those of the machine.
TEST(OperatorRequest, KnowsEveryChoiceOfTheTable) {
  for (const protocol::Method& method : protocol::methods()) {
    if (method.action.empty()) continue;
    for (const protocol::Parameter& parameter : method.parameters) {
      if (parameter.carries != protocol::Carries::text) continue;
      for (const std::string_view choice : parameter.choices) {
        SCOPED_TRACE(std::string(method.name) + " " + std::string(choice));
        protocol::MachineRequest request;
        request.action = method.action;
        request.text = choice;
        const auto event = operator_event(request);
        ASSERT_TRUE(event.has_value());
        EXPECT_EQ(channels::fields_of(event->command).text.view(), choice);
      }
    }
  }
}

TEST(OperatorRequest, OfAnActionThatTheMachineDoesNotHaveIsNone) {
  protocol::MachineRequest request;
  request.action = "make_coffee";
  EXPECT_FALSE(operator_event(request).has_value());
}

}  // namespace
}  // namespace stanok::runtime

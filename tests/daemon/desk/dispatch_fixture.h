// A Dispatch before a fake machine, and one session that may do everything.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "channels/contract/operator_action.h"
#include "daemon/desk/dispatch.h"
#include "tests/daemon/desk/accepted_parameters.h"
#include "tests/daemon/fake_machine.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {

class DispatchTest : public ::testing::Test {
 protected:
  DispatchTest() { session.role = protocol::Role::integrator; }

  // The answer; nothing while it is still to come.
  std::shared_ptr<std::optional<CommandResult>> ask(
      const std::string& method, nlohmann::json parameters = nlohmann::json::object()) {
    const auto slot = std::make_shared<std::optional<CommandResult>>();
    protocol::RpcRequest request;
    request.id = 1;
    request.method = method;
    request.parameters = std::move(parameters);
    dispatch.handle(session, request, [slot](const CommandResult& outcome) {
      EXPECT_FALSE(slot->has_value()) << "answered twice";
      *slot = outcome;
    });
    return slot;
  }
  nlohmann::json result(const std::string& method,
                        nlohmann::json parameters = nlohmann::json::object()) {
    const auto slot = ask(method, std::move(parameters));
    EXPECT_TRUE(slot->has_value() && slot->value().has_value()) << method;
    return slot->has_value() && slot->value() ? *slot->value() : nlohmann::json();
  }
  protocol::Failure failure(const std::string& method,
                            nlohmann::json parameters = nlohmann::json::object()) {
    const auto slot = ask(method, std::move(parameters));
    EXPECT_TRUE(slot->has_value() && !slot->value().has_value()) << method;
    return slot->has_value() && !slot->value() ? slot->value().error() : protocol::Failure{};
  }
  void tick(std::chrono::milliseconds after) {
    dispatch.tick(SteadyTime{} + std::chrono::hours(1) + after);
  }

  // A method that the desk answers, at once, from another thread or when the cycle knows it.
  void expect_an_answer(const protocol::Method& method, const nlohmann::json& parameters) {
    const auto slot = ask(std::string(method.name), parameters);
    if (method.name == "channel.control")
      dispatch.on_reply(accepted(machine.submitted().back().id));
    else
      while (!slot->has_value()) tick(std::chrono::milliseconds(1));
    ASSERT_TRUE(slot->has_value());
    EXPECT_TRUE(slot->value().has_value()) << slot->value().error().message;
  }
  // A method that is handed to the machine.
  void expect_an_action(const protocol::Method& method, const nlohmann::json& parameters) {
    const std::size_t before = machine.submitted().size();
    const auto slot = ask(std::string(method.name), parameters);
    ASSERT_EQ(machine.submitted().size(), before + 1);
    EXPECT_EQ(channels::name_of(machine.submitted().back().action()), method.action);
    dispatch.on_reply(accepted(machine.submitted().back().id));
    ASSERT_TRUE(slot->has_value());
    EXPECT_EQ(*slot->value(), nlohmann::json({{"accepted", true}}));
  }

  FakeMachine machine;
  bool shutdown_asked = false;
  SessionState session;
  Dispatch dispatch{machine, {"test", "/state", "/socket"}, [this] { shutdown_asked = true; }};
};

}  // namespace stanok::daemon

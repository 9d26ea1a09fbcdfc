// The blocking connection against a server of three lines: answers, notifications, silence, death.
#include "client/operator/operator_client.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <string>
#include <vector>

#include "tests/client/fake_server.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

TEST(OperatorClient, ReadsTheHelloAndAnAnswer) {
  const FakeServer server([](int c) {
    say(c, hello);
    const json request = json::parse(heard(c));
    EXPECT_EQ(request["method"], "machine.status");
    say(c, R"({"jsonrpc":"2.0","id":1,"result":{"on":true}})"
           "\n");
  });
  OperatorClient client(server.path());
  EXPECT_EQ(client.hello()["machine"], "mill3");
  const auto result =
      client.call("machine.status", json::object(), OperatorClient::Clock::now() + 5s);
  ASSERT_TRUE(result);
  EXPECT_EQ((*result)["on"], true);
}

TEST(OperatorClient, HandsNotificationsOverWhileItWaits) {
  const FakeServer server([](int c) {
    say(c, hello);
    heard(c);
    say(c,
        R"({"jsonrpc":"2.0","method":"event","params":{"seq":1}})"
        "\n"
        R"({"jsonrpc":"2.0","id":99,"result":"of somebody else"})"
        "\n"
        R"({"jsonrpc":"2.0","id":1,"error":{"code":-32001,"message":"no","data":{"code":"E6003"}}})"
        "\n");
  });
  OperatorClient client(server.path());
  std::vector<std::string> seen;
  client.on_notification([&](const std::string& method, const json&) { seen.push_back(method); });
  const auto result =
      client.call("program.start", json::object(), OperatorClient::Clock::now() + 5s);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, protocol::FailureKind::refused);
  EXPECT_EQ(result.error().code, "E6003");
  EXPECT_EQ(seen, std::vector<std::string>{"event"});
}

TEST(OperatorClient, GivesUpAtTheDeadline) {
  const FakeServer server([](int c) {
    say(c, hello);
    heard(c);
    heard(c);  // until the client hangs up
  });
  OperatorClient client(server.path());
  const auto result = client.call("x", json::object(), OperatorClient::Clock::now() + 20ms);
  ASSERT_FALSE(result);
  EXPECT_EQ(exit_code(result.error().kind), 4);
  EXPECT_EQ(result.error().code, "E9016");
}

TEST(OperatorClient, SaysThatTheConnectionIsLost) {
  const FakeServer server([](int c) {
    say(c, hello);
    heard(c);
  });
  OperatorClient client(server.path());
  EXPECT_THROW(static_cast<void>(client.call("x", json::object(), std::nullopt)), ConnectionError);
}

TEST(OperatorClient, TellsWhyTheDaemonDroppedIt) {
  const FakeServer server([](int c) {
    say(c, hello);
    heard(c);
    say(c, R"({"jsonrpc":"2.0","method":"dropped","params":{"reason":"too slow"}})"
           "\n");
  });
  OperatorClient client(server.path());
  try {
    static_cast<void>(client.call("x", json::object(), std::nullopt));
    FAIL() << "no exception";
  } catch (const ConnectionError& error) {
    EXPECT_NE(std::string(error.what()).find("too slow"), std::string::npos);
  }
}

TEST(OperatorClient, DoesNotTakeAnybodyForADaemon) {
  const FakeServer server([](int c) { say(c, "220 mail.example.org ESMTP\n"); });
  EXPECT_THROW(OperatorClient client(server.path()), ConnectionError);
}

TEST(OperatorClient, FindsNobody) {
  EXPECT_THROW(OperatorClient client("/nonexistent/stanok.sock"), ConnectionError);
  EXPECT_THROW(OperatorClient client(std::string(200, 'x')), ConnectionError);
}

TEST(ChooseSocket, PrefersTheNamedOneThenTheVariableThenTheOnlyOne) {
  setenv("STANOK_SOCKET", "/run/a.sock", 1);
  EXPECT_EQ(choose_socket("/run/b.sock"), "/run/b.sock");
  EXPECT_EQ(choose_socket(""), "/run/a.sock");
  unsetenv("STANOK_SOCKET");
  setenv("XDG_RUNTIME_DIR", "/nonexistent", 1);
  setenv("XDG_STATE_HOME", "/nonexistent", 1);
  EXPECT_THROW(static_cast<void>(choose_socket("")), ConnectionError);
}

}  // namespace
}  // namespace stanok::client

// The server over a real socket: many clients, rude clients, subscriptions, the orderly end.
#include "daemon/server/operator_server.h"

#include <gtest/gtest.h>

#include <cctype>
#include <csignal>
#include <thread>

#include "daemon/host/signals.h"
#include "tests/daemon/fake_machine.h"
#include "tests/daemon/raw_client.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

class ServerTest : public ::testing::Test {
 protected:
  explicit ServerTest(ServerLimits limits = {})
      : socket(here.path() / "test.sock"),
        server(socket, machine, {"test", here.path(), socket.path()}, limits) {
    machine.on_submit = [this](const channels::OperatorEvent& event) {
      server.on_reply(accepted(event.id));
    };
    thread = std::thread([this] { server.run(); });
  }
  ~ServerTest() override {
    server.end();
    thread.join();
  }

  stanok::testing::TemporaryDirectory here;
  FakeMachine machine;
  ListeningSocket socket;
  OperatorServer server;
  std::thread thread;
};

TEST_F(ServerTest, GreetsAndAnswers) {
  RawClient client(socket.path());
  const json hello = client.receive();
  EXPECT_EQ(hello["method"], "hello");
  EXPECT_EQ(hello["params"]["server"], "stanokd");
  EXPECT_EQ(hello["params"]["machine"], "fake");
  EXPECT_EQ(hello["params"]["channels"][1]["name"], "master");
  EXPECT_EQ(hello["params"]["role"], "integrator") << "the same user";
  client.request(1, "channel.list");
  EXPECT_EQ(client.receive()["result"]["channels"].size(), 2U);
  client.request(2, "program.hold");
  const json answer = client.receive();
  EXPECT_EQ(answer["id"], 2);
  EXPECT_EQ(answer["result"]["accepted"], true);
}

TEST_F(ServerTest, AnswersWhatIsMalformedAndLivesOn) {
  RawClient client(socket.path());
  client.receive();
  client.send("this is not JSON\n{\"jsonrpc\":\"2.0\"\n[]\n\n");
  EXPECT_EQ(client.receive()["error"]["code"], -32700);
  EXPECT_EQ(client.receive()["error"]["code"], -32700);
  EXPECT_EQ(client.receive()["error"]["code"], -32600);
  client.request(5, "machine.status");
  EXPECT_EQ(client.receive()["result"]["name"], "fake");
}

TEST_F(ServerTest, SkipsAFrameThatIsTooLong) {
  RawClient client(socket.path());
  client.receive();
  client.send(std::string(3U << 20, 'x'));
  client.send("\n");
  EXPECT_EQ(client.receive()["error"]["code"], -32600);
  client.request(5, "machine.status");
  EXPECT_EQ(client.receive()["result"]["name"], "fake");
}

TEST_F(ServerTest, DoesNotAnswerNotifications) {
  RawClient client(socket.path());
  client.receive();
  client.send("{\"jsonrpc\":\"2.0\",\"method\":\"program.hold\"}\n");
  client.request(7, "machine.status");
  EXPECT_EQ(client.receive()["id"], 7);
  EXPECT_EQ(machine.submitted().size(), 1U);
}

TEST_F(ServerTest, ServesSixtyFourClientsAndTellsTheNextOneWhyNot) {
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int k = 0; k < 64; ++k) {
    clients.push_back(std::make_unique<RawClient>(socket.path()));
    EXPECT_EQ(clients.back()->receive()["method"], "hello");
  }
  RawClient late(socket.path());
  const json message = late.receive();
  EXPECT_EQ(message["method"], "dropped");
  EXPECT_EQ(message["params"]["code"], "E9008");
  EXPECT_TRUE(late.receive().is_discarded());
  for (auto& client : clients) client->request(1, "machine.status");
  for (auto& client : clients) EXPECT_EQ(client->receive()["id"], 1);
}

TEST_F(ServerTest, LetsAnObserverMakeRoomForAnOperator) {
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int k = 0; k < 64; ++k) {
    clients.push_back(std::make_unique<RawClient>(socket.path()));
    clients.back()->receive();
  }
  clients[10]->request(1, "session.role", {{"role", "observer"}});
  EXPECT_EQ(clients[10]->receive()["result"]["role"], "observer");
  RawClient late(socket.path());
  EXPECT_EQ(late.receive()["method"], "hello");
  EXPECT_EQ(clients[10]->receive()["method"], "dropped");
}

TEST_F(ServerTest, SurvivesAThousandClientsThatComeAndGo) {
  for (int k = 0; k < 1000; ++k) {
    RawClient client(socket.path());
    if (k % 3 == 0) client.send("{\"half");
    if (k % 7 == 0) client.request(1, "channel.list");
  }
  // Those that have gone are noticed one after the other; a place is free soon.
  for (int attempt = 0; attempt < 100; ++attempt) {
    RawClient client(socket.path());
    if (client.receive().value("method", "") == "hello") return;
    std::this_thread::sleep_for(20ms);
  }
  FAIL() << "no place any more";
}

TEST_F(ServerTest, DropsAClientThatDoesNotRead) {
  RawClient deaf(socket.path());
  std::string requests;
  for (int k = 0; k < 20; ++k) {
    requests += json{{"jsonrpc", "2.0"}, {"id", k}, {"method", "rpc.discover"}}.dump() + "\n";
  }
  // Until the server has had enough; it must never be the server that waits.
  while (deaf.send(requests)) {
    RawClient other(socket.path());
    EXPECT_EQ(other.receive()["method"], "hello");
  }
  RawClient other(socket.path());
  other.receive();
  other.request(1, "machine.status");
  EXPECT_EQ(other.receive()["id"], 1);
}

TEST_F(ServerTest, SendsASnapshotThenChangesThenEvents) {
  RawClient client(socket.path());
  client.receive();
  client.request(1, "subscribe", {{"topics", {"channels", "events"}}, {"rate_hz", 50}});
  EXPECT_EQ(client.receive("id", 1)["result"]["topics"].size(), 2U);
  const json full = client.receive("method", "status");
  EXPECT_EQ(full["params"]["full"], true);
  EXPECT_EQ(full["params"]["state"]["channels"]["1"]["name"], "work");
  machine.change([](FakeMachine& m) { m.output.channels[0].tag.line = 77; });
  const json change = client.receive("method", "status");
  EXPECT_EQ(change["params"]["full"], false);
  EXPECT_EQ(change["params"]["state"], json::parse(R"({"channels":{"1":{"line":77}}})"));
  channels::Event event;
  event.cycle = 12;
  event.channel = 1;
  event.code = FixedText<8>("W0001");
  event.text = FixedText<240>("mind the gap");
  server.on_event(event);
  const json told = client.receive("method", "event");
  EXPECT_EQ(told["params"]["code"], "W0001");
  EXPECT_EQ(told["params"]["text"], "mind the gap");
}

TEST_F(ServerTest, WatchesOneChannelOnly) {
  RawClient client(socket.path());
  client.receive();
  client.request(1, "channel.watch", {{"channel", 2}});
  const json full = client.receive("method", "status");
  EXPECT_TRUE(full["params"]["state"]["channels"].contains("2"));
  EXPECT_FALSE(full["params"]["state"]["channels"].contains("1"));
}

TEST_F(ServerTest, CarriesOnWhenAClientGoesBeforeItsAnswer) {
  machine.on_submit = nullptr;
  {
    RawClient client(socket.path());
    client.receive();
    client.request(1, "program.start");
    while (machine.submitted().empty()) std::this_thread::sleep_for(1ms);
  }
  server.on_reply(accepted(machine.submitted()[0].id));
  RawClient other(socket.path());
  EXPECT_EQ(other.receive()["method"], "hello");
}

class ServerSignals : public ServerTest, public ::testing::WithParamInterface<int> {};

// One signal, and another behind it that changes nothing: a terminal that is closed sends two.
TEST_P(ServerSignals, EndWithAFeedHoldAndDrivesOff) {
  RawClient client(socket.path());
  client.receive();
  ASSERT_EQ(std::raise(GetParam()), 0);
  ASSERT_EQ(std::raise(GetParam()), 0);
  EXPECT_TRUE(client.receive().is_discarded()) << "the connection ends with the server";
  const auto events = machine.submitted();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].action(), channels::OperatorAction::program_hold);
  EXPECT_EQ(events[0].channel, 0);
  EXPECT_EQ(events[1].action(), channels::OperatorAction::machine_off);
}

INSTANTIATE_TEST_SUITE_P(AllThatWouldEndTheProcess, ServerSignals,
                         ::testing::ValuesIn(ending_signals()), [](const auto& tested) {
                           std::string name = signal_name(tested.param);
                           std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

TEST_F(ServerTest, IsNotEndedNorStoppedByPipesTerminalsAndFileSizes) {
  ignore_harmless_signals();
  for (const int number : {SIGPIPE, SIGXFSZ, SIGTSTP, SIGTTIN, SIGTTOU})
    ASSERT_EQ(std::raise(number), 0);
  RawClient client(socket.path());
  EXPECT_EQ(client.receive()["method"], "hello");
  EXPECT_TRUE(machine.submitted().empty());
}

TEST_F(ServerTest, IsFoundAgainWhenItsSocketWasRemoved) {
  RawClient before(socket.path());
  before.receive();
  ASSERT_TRUE(std::filesystem::remove(socket.path()));
  while (!RawClient::is_answered(socket.path())) std::this_thread::sleep_for(1ms);
  RawClient after(socket.path());
  EXPECT_EQ(after.receive()["method"], "hello");
  before.request(1, "machine.status");
  EXPECT_EQ(before.receive("id", 1)["result"]["name"], "fake");
}

// A request of somebody that keeps the operator server busy until the test lets it go.
class BusyServerTest : public ServerTest {
 protected:
  BusyServerTest() {
    machine.on_submit = [this](const channels::OperatorEvent& event) {
      if (event.action() == channels::OperatorAction::override_feed) {
        is_busy = true;
        while (is_busy) std::this_thread::sleep_for(1ms);
      }
      server.on_reply(accepted(event.id));
    };
  }
  ~BusyServerTest() override { is_busy = false; }

  void keep_busy(RawClient& client) {
    client.receive();
    client.request(1, "override.feed", {{"percent", 50}});
    while (!is_busy) std::this_thread::yield();
  }
  std::atomic<bool> is_busy{false};
};

TEST_F(BusyServerTest, TakesEveryStopWhileTheOperatorServerIsBusy) {
  RawClient rude(socket.path());
  keep_busy(rude);
  RawClient client(socket.path());
  EXPECT_EQ(client.receive()["method"], "hello");
  int id = 1;
  for (const char* stop :
       {"machine.estop", "machine.off", "program.hold", "program.stop", "program.reset"}) {
    client.request(++id, stop);
    EXPECT_EQ(client.receive("id", id)["result"]["accepted"], true) << stop;
  }
  // On the connection of who keeps it busy, too, and behind a request that waits.
  rude.request(2, "machine.status");
  rude.request(3, "machine.estop");
  EXPECT_EQ(rude.receive("id", 3)["result"]["accepted"], true);
  EXPECT_TRUE(is_busy) << "the other request is still being worked on";
  EXPECT_EQ(machine.submitted().size(), 7U);
}

TEST_F(BusyServerTest, EndsInOrderWhileTheOperatorServerIsBusy) {
  RawClient rude(socket.path());
  keep_busy(rude);
  ASSERT_EQ(std::raise(SIGTERM), 0);
  while (machine.submitted().size() < 3) std::this_thread::yield();
  EXPECT_TRUE(is_busy);
  EXPECT_EQ(machine.submitted()[1].action(), channels::OperatorAction::program_hold);
  EXPECT_EQ(machine.submitted()[2].action(), channels::OperatorAction::machine_off);
}

TEST_F(ServerTest, TakesAStopFromAClientThatFindsNoPlace) {
  std::vector<std::unique_ptr<RawClient>> idle;
  for (int k = 0; k < 200; ++k) {
    idle.push_back(std::make_unique<RawClient>(socket.path()));
    idle.back()->receive();
  }
  RawClient late(socket.path());
  late.request(1, "machine.status");
  late.request(2, "machine.estop");
  EXPECT_EQ(late.receive()["method"], "dropped");
  EXPECT_EQ(late.receive()["id"], 2) << "nothing but the stop is answered";
  EXPECT_EQ(machine.submitted().size(), 1U);
}

TEST_F(ServerTest, ChecksAStopAsEveryRequest) {
  RawClient client(socket.path());
  client.receive();
  client.request(1, "program.hold", {{"channel", 9}});
  EXPECT_EQ(client.receive("id", 1)["error"]["data"]["code"], "E6001");
  client.request(2, "program.hold", {{"canal", 1}});
  EXPECT_EQ(client.receive("id", 2)["error"]["data"]["code"], "E9003");
  machine.change([](FakeMachine& m) { m.is_full = true; });
  client.request(3, "program.hold");
  EXPECT_EQ(client.receive("id", 3)["error"]["data"]["code"], "E9007");
  client.request(4, "session.role", {{"role", "observer"}});
  client.receive("id", 4);
  client.request(5, "machine.estop");
  EXPECT_EQ(client.receive("id", 5)["error"]["data"]["code"], "E9004");
  EXPECT_TRUE(machine.submitted().empty());
}

// The machine throws where the request is worked on, as when there is no memory left.
TEST_F(ServerTest, StopsTheMachineWhenItsOwnWorkFails) {
  machine.on_submit = [](const channels::OperatorEvent& event) {
    if (event.action() == channels::OperatorAction::override_feed) throw std::bad_alloc();
  };
  RawClient client(socket.path());
  client.receive();
  client.request(1, "override.feed", {{"percent", 50}});
  while (machine.submitted().size() < 3) std::this_thread::yield();
  EXPECT_EQ(machine.submitted()[1].action(), channels::OperatorAction::program_hold);
  EXPECT_EQ(machine.submitted()[2].action(), channels::OperatorAction::machine_off);
  EXPECT_TRUE(server.has_failed());
}

class ImpatientServerTest : public ServerTest {
 protected:
  ImpatientServerTest() : ServerTest({.clients_max = 64, .frame_time_max = 30ms}) {}
};

TEST_F(ImpatientServerTest, DropsAClientThatDoesNotFinishItsFrame) {
  RawClient loris(socket.path());
  loris.receive();
  loris.send("{\"jsonrpc\"");
  const json message = loris.receive();
  EXPECT_EQ(message["method"], "dropped");
  EXPECT_EQ(message["params"]["code"], "E9001");
}

}  // namespace
}  // namespace stanok::daemon

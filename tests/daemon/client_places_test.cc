// Places of the server when clients go slowly: an observer makes room once, not again and again.
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <thread>
#include <vector>

#include "daemon/server/operator_server.h"
#include "tests/daemon/fake_machine.h"
#include "tests/daemon/raw_client.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

// A server for two clients.
class ClientPlaces : public ::testing::Test {
 protected:
  ClientPlaces() : thread([this] { server.run(); }) {}
  ~ClientPlaces() override {
    server.end();
    thread.join();
  }

  stanok::testing::TemporaryDirectory here;
  FakeMachine machine;
  ListeningSocket socket{here.path() / "test.sock"};
  OperatorServer server{socket,
                        machine,
                        {"test", here.path(), socket.path()},
                        {.clients_max = 2, .frame_time_max = 10s}};
  std::thread thread;
};

TEST_F(ClientPlaces, OneObserverMakesRoomForOneOperatorOnly) {
  RawClient first(socket.path());
  first.receive("method", "hello");
  RawClient observer(socket.path());
  observer.receive("method", "hello");
  observer.request(1, "session.role", {{"role", "observer"}});
  observer.receive("id", 1);
  // More than the kernel keeps for a socket and less than the queue on top of that: the session of
  // an observer who reads nothing of it lingers when it is dropped.
  constexpr std::size_t unread_bytes = 300U << 10;
  observer.request(2, "rpc.discover");
  const std::size_t answer_bytes = observer.receive("id", 2).dump().size();
  for (std::size_t k = 0; k < unread_bytes / answer_bytes; ++k) {
    observer.request(3, "rpc.discover");
    first.request(4, "system.info");  // one after the other, so that the kernel takes its share
    first.receive("id", 4);
  }
  std::deque<RawClient> late;
  std::vector<std::string> words;
  for (int k = 0; k < 3; ++k) {
    late.emplace_back(socket.path());
    words.push_back(late.back().receive().value("method", ""));
  }
  EXPECT_EQ(words, (std::vector<std::string>{"hello", "dropped", "dropped"}));
  first.request(5, "system.info");
  EXPECT_EQ(first.receive("id", 5)["result"]["clients"], 2);
}

}  // namespace
}  // namespace stanok::daemon

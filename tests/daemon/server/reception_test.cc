// Reception: it comes to its end whatever those do who count on it.
#include "daemon/server/reception.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <thread>

#include "daemon/server/listening_socket.h"
#include "tests/daemon/fake_machine.h"
#include "tests/daemon/raw_client.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

// As where memory has ended: nothing can be noted of who goes.
class CounterWithoutMemory final : public Counter {
 public:
  std::atomic<int> departures = 0;
  std::atomic<bool> has_ended = false;

  void on_arrival(std::shared_ptr<Session> /*session*/) override {}
  void on_frame(std::shared_ptr<Session> /*session*/, protocol::TextFrame /*frame*/,
                const AskedAt& /*asked_at*/) override {}
  void on_departure(int /*session*/) override {
    ++departures;
    throw std::bad_alloc();
  }
  void on_stop_answered(const Asker& /*asker*/, const protocol::RpcRequest& /*request*/,
                        const CommandResult& /*outcome*/) override {}
  void on_stop_accepted(const channels::OperatorEvent& /*stop*/) override {}
  void on_end() override { has_ended = true; }
};

TEST(ReceptionTest, EndsWhereThereIsNoMemoryToTellClientsOfIt) {
  const stanok::testing::TemporaryDirectory folder;
  ListeningSocket socket(folder.path() / "op.sock");
  FakeMachine machine;
  CounterWithoutMemory counter;
  Reception reception(socket, machine, counter, {});
  std::jthread thread([&] { reception.run(); });
  RawClient client(folder.path() / "op.sock");
  EXPECT_EQ(client.receive().value("method", ""), "hello");
  reception.end();
  thread.join();
  EXPECT_TRUE(counter.has_ended);
  EXPECT_EQ(counter.departures, 1);
}

}  // namespace
}  // namespace stanok::daemon

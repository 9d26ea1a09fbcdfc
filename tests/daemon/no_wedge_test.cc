// No sequence of commands wedges the daemon: 10,000 random ones of three clients, interleaved, and
// it still answers, every request has had one answer, and two resets bring it back to work. Once on
// a virtual clock, where a seed repeats to the bit, and once with all threads and real sockets, for
// ThreadSanitizer too.
#include <gtest/gtest.h>

#include "tests/daemon/daemon_bench.h"
#include "tests/daemon/live_daemon.h"
#include "tests/daemon/random_commands.h"
#include "tests/daemon/setpoint_watch.h"
#include "tests/support/sanitized.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

constexpr int commands = testing::cases(10'000);
constexpr int client_count = 3;

class NoWedge : public ::testing::TestWithParam<int> {};

using Unanswered = std::deque<std::pair<RandomCommand, DaemonBench::Slot>>;

// Cycles until every request has its answer. Files are read and programs checked in threads of
// their own, which a loaded machine may leave waiting for long: what is waited for is the answer,
// and the bound only ends a test that hangs.
void cycle_until_answered(DaemonBench& bench, Unanswered& unanswered) {
  using namespace std::chrono_literals;
  const auto has_answer = [](const auto& request) { return request.second->has_value(); };
  const auto given_up = std::chrono::steady_clock::now() + 5min;
  while (!unanswered.empty() && std::chrono::steady_clock::now() < given_up) {
    bench.cycle();
    std::erase_if(unanswered, has_answer);
    if (!unanswered.empty()) std::this_thread::sleep_for(1ms);
  }
}

TEST_P(NoWedge, TenThousandCommandsOfThreeClients) {
  RandomCommands random(static_cast<std::uint64_t>(GetParam()));
  DaemonBench bench;
  SetpointWatch watch;
  for (const auto& [name, text] : programs_of_random_commands()) bench.program(name, text);
  bench.demand("machine.on");
  Unanswered unanswered;
  for (int n = 0; n < commands && !::testing::Test::HasFatalFailure(); ++n) {
    RandomCommand command = random.next();
    const auto slot = bench.ask(n % client_count, command.method, command.parameters);
    if (!slot->has_value()) unanswered.emplace_back(std::move(command), slot);
    // Mostly at once, now and then long enough for something to happen.
    const int chance = random.pick(0, 39);
    const int cycles = chance == 0 ? random.pick(0, 400) : random.pick(0, chance < 10 ? 40 : 2);
    for (int k = 0; k < cycles; ++k) watch.look(bench.cycle());
    while (!unanswered.empty() && unanswered.front().second->has_value()) unanswered.pop_front();
  }
  ASSERT_TRUE(bench.answer("system.info", {}, 0)->has_value());

  for (int client = 0; client < client_count; ++client) {
    for (const int channel : {1, 2})
      bench.ask(client, "channel.control", {{"on", 0}, {"channel", channel}});
  }
  // Back to idle, and to work.
  bench.demand("program.reset", {{"channel", 2}});
  bench.demand("program.reset", {{"channel", 1}});
  for (int n = 0; n < 5000 && !bench.is_idle(); ++n) bench.cycle();
  EXPECT_TRUE(bench.is_idle());
  cycle_until_answered(bench, unanswered);
  for (const auto& [command, slot] : unanswered)
    ADD_FAILURE() << "never answered: " << command.method << " " << command.parameters.dump();
  for (const char* drive : {"X", "Y", "Z", "B", "C"})
    bench.demand("drive.reset", {{"drive", drive}});
  bench.cycles(300);
  bench.demand("machine.on");
  for (const int level : {1, 2, 3, 4, 5, 6, 7, 8, 9})
    bench.demand("program.unskip", {{"level", level}});
  bench.demand("program.step", {{"on", 0}});
  bench.demand("override.feed", {{"percent", 100}});
  bench.demand("override.rapid", {{"percent", 100}});
  bench.program("last.nc", "G90 G53 G0 Z100\nM30\n");
  bench.demand("kinematics.select", {{"scheme", 1}});
  bench.demand("program.run", {{"program", "last.nc"}, {"wait", "done"}});
}

INSTANTIATE_TEST_SUITE_P(Seeds, NoWedge, ::testing::Range(1, 4));

// Sends without waiting for answers, but for no more than a few dozen at a time; takes all of them.
void send_commands(const std::filesystem::path& socket, std::uint64_t seed, int count) {
  constexpr int on_their_way = 32;
  RandomCommands random(seed);
  RawClient client(socket);
  int unanswered = 0;
  const auto take_answer = [&] {
    const json message = client.receive();
    ASSERT_FALSE(message.is_discarded()) << "client " << seed << " gets no answer any more";
    ASSERT_NE(message.value("method", ""), "dropped") << message.dump();
    if (message.contains("id")) --unanswered;
  };
  for (int n = 0; n < count && !::testing::Test::HasFatalFailure(); ++n) {
    RandomCommand command = random.next();
    command.parameters.erase("wait");  // an endless program would be waited for endlessly
    client.request(n, command.method, command.parameters);
    for (++unanswered; unanswered > on_their_way && !::testing::Test::HasFatalFailure();)
      take_answer();
  }
  while (unanswered > 0 && !::testing::Test::HasFatalFailure()) take_answer();
}

TEST(NoWedgeLive, TenThousandCommandsOfThreeClientsOverTheSocket) {
  LiveDaemon daemon;
  for (const auto& [name, text] : programs_of_random_commands()) daemon.program(name, text);
  std::vector<std::thread> threads;
  for (std::uint64_t seed = 1; seed <= client_count; ++seed) {
    threads.emplace_back([&, seed] {
      send_commands(daemon.socket(), seed, (commands + client_count - 1) / client_count);
    });
  }
  for (std::thread& thread : threads) thread.join();

  RawClient client(daemon.socket());
  client.request(1, "system.info");
  EXPECT_EQ(client.receive("id", 1)["result"]["machine"], "live");
  int id = 1;
  const auto demand = [&](const std::string& method, const json& parameters) {
    client.request(++id, method, parameters);
    const json answer = client.receive("id", id);
    EXPECT_TRUE(answer.contains("result")) << method << ": " << answer.dump();
  };
  demand("program.reset", {{"channel", 2}});
  demand("program.reset", {{"channel", 1}});
  demand("machine.on", json::object());
  demand("program.step", {{"on", 0}});
  demand("override.feed", {{"percent", 100}});
  demand("override.rapid", {{"percent", 100}});
  daemon.program("last.nc", "G90 G53 G0 X1\nM30\n");
  demand("program.run", {{"program", "last.nc"}, {"wait", "done"}});
  EXPECT_EQ(daemon.end(), 0);
}

}  // namespace
}  // namespace stanok::daemon

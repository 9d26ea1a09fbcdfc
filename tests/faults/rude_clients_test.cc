// Clients that flood, dawdle, do not read or send nonsense, against the daemon with all its
// threads: they get a reason or an answer, everybody else is served, the program runs on, memory is
// bounded.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "protocol/contract/frame_reader.h"
#include "tests/daemon/live_daemon.h"
#include "tests/support/sanitized.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

// Both ends of every connection are in this process.
void allow_descriptors(rlim_t wanted) {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = std::max(limit.rlim_cur, std::min(limit.rlim_max, wanted));
  setrlimit(RLIMIT_NOFILE, &limit);
}

// Sanitizers keep what was freed for a while, and shadows of all of it.
constexpr bool memory_is_that_of_the_daemon = !testing::is_sanitized;

std::size_t resident_bytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// When what a start needs for a while is there, or has gone again.
std::size_t resident_bytes_at_rest() {
  constexpr std::size_t little = 4U << 20;
  std::size_t before = 0;
  std::size_t now = resident_bytes();
  for (int n = 0; n < 40 && now > before + little; ++n) {
    before = now;
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    now = resident_bytes();
  }
  return now;
}

// A polite client, and a program that it started.
class RudeClients : public ::testing::Test {
 protected:
  void SetUp() override {
    allow_descriptors(4096);
    daemon.program("work.nc", "G90 F6000\nwhile (true) {\nG1 X50\nX0\n}\n");
    client.receive();
    demand("machine.on");
    demand("program.run", {{"program", "work.nc"}});
  }
  void TearDown() override {
    demand("system.info");
    client.request(++id, "channel.status");
    EXPECT_EQ(client.receive("id", id)["result"]["program_status"], "Running");
    demand("program.reset");
    EXPECT_EQ(daemon.end(), 0);
  }
  void demand(const std::string& method, const json& parameters = json::object()) {
    client.request(++id, method, parameters);
    const json answer = client.receive("id", id);
    ASSERT_TRUE(answer.contains("result")) << method << ": " << answer.dump();
  }

  LiveDaemon daemon;
  RawClient client{daemon.socket()};
  int id = 0;
};

TEST_F(RudeClients, AThousandAtOnceAreServedOrToldWhyNot) {
  std::vector<std::unique_ptr<RawClient>> all;
  for (int k = 0; k < 1000; ++k) {
    all.push_back(std::make_unique<RawClient>(daemon.socket()));
    if (k % 50 == 0) demand("machine.status");
  }
  int greeted = 0;
  for (const auto& one : all) {
    const json first = one->receive();
    ASSERT_FALSE(first.is_discarded()) << "neither greeted nor told why not";
    const std::string method = first["method"];
    ASSERT_TRUE(method == "hello" || first["params"]["code"] == "E9008") << first.dump();
    greeted += method == "hello" ? 1 : 0;
  }
  EXPECT_EQ(greeted, 63) << "of 64 places one is the polite client's";
}

// All places but one are taken by clients that send a megabyte without an end, and never read. What
// they hold is bounded: their input, their output queue, and what the sockets themselves keep.
TEST_F(RudeClients, WhoSendsWithoutAnEndOrDoesNotReadCostsABoundedMemory) {
  constexpr std::size_t others = 63;
  constexpr std::size_t kept_of_each = 2 * protocol::frame_bytes_max + (1U << 20);
  const std::size_t before = resident_bytes_at_rest();
  std::vector<std::unique_ptr<RawClient>> all;
  for (std::size_t k = 0; k < others; ++k) {
    all.push_back(std::make_unique<RawClient>(daemon.socket()));
    all.back()->request(1, "subscribe",
                        {{"topics", {"machine", "channels", "drives", "events"}}, {"rate_hz", 50}});
    all.back()->send("{\"jsonrpc\":\"2.0\",\"x\":\"" +
                     std::string(protocol::frame_bytes_max - 100, 'x'));
  }
  for (int k = 0; k < 200; ++k) demand("machine.status");
  if (memory_is_that_of_the_daemon) {
    EXPECT_LT(resident_bytes(), before + others * kept_of_each);
  }
}

TEST_F(RudeClients, WhoDoesNotReadIsDropped) {
  RawClient deaf(daemon.socket());
  const std::string question = R"({"jsonrpc":"2.0","id":1,"method":"rpc.discover"})"
                               "\n";
  int asked = 0;
  while (deaf.send(question) && asked < 100'000) {
    if (++asked % 10 == 0) demand("machine.status");
  }
  EXPECT_LT(asked, 100'000) << "never dropped";
}

// Each of them has one answer, and the connection lives on.
TEST_F(RudeClients, NonsenseIsAnsweredLineByLine) {
  const std::vector<std::string> nonsense = {
      "nonsense",
      "{",
      "}",
      "[]",
      "[[]]",
      "{}",
      "null",
      "true",
      "0",
      "-",
      "1e999",
      "\"text\"",
      "\"",
      "{\"jsonrpc\":\"2.0\"}",
      R"({"jsonrpc":"2.0","id":1})",
      R"({"jsonrpc":"1.0","id":1,"method":"system.info"})",
      R"({"id":1,"method":"system.info"})",
      R"({"jsonrpc":"2.0","id":1,"method":7})",
      R"({"jsonrpc":"2.0","id":1,"method":null})",
      R"({"jsonrpc":"2.0","id":1,"method":""})",
      R"({"jsonrpc":"2.0","id":{},"method":"a"})",
      R"({"jsonrpc":"2.0","id":[1],"method":"a"})",
      R"({"jsonrpc":"2.0","id":true,"method":"a"})",
      R"({"jsonrpc":"2.0","id":1.5,"method":"a"})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":7})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":"X"})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":{"axis":1,"velocity":1}})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":{"axis":"X","velocity":1e999}})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":{"axis":"X","velocity":null}})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":{"axis":"X","velocity":NaN}})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":{"axis":"X","velocity":1,"x":1}})",
      R"({"jsonrpc":"2.0","id":1,"method":"jog","params":["X",1,2,3,4,5,6,7,8]})",
      R"({"jsonrpc":"2.0","id":1,"method":"override.feed","params":{"percent":"100"}})",
      R"({"jsonrpc":"2.0","id":1,"method":"override.feed","params":{"percent":-1e-320}})",
      R"({"jsonrpc":"2.0","id":1,"method":"override.feed","params":{"percent":[[[[]]]]}})",
      R"({"jsonrpc":"2.0","id":1,"method":"program.run","params":{"program":""}})",
      R"({"jsonrpc":"2.0","id":1,"method":"program.run","params":{"program":"\u0000"}})",
      R"({"jsonrpc":"2.0","id":1,"method":"program.run","params":{"program":"\ud800"}})",
      R"([{"jsonrpc":"2.0","id":1,"method":"system.info"}])",
      "GET / HTTP/1.1",
      "POST /rpc HTTP/1.0",
      "\xff\xfe{\"jsonrpc\":\"2.0\"}",
      "\x01\x02\x03",
      "\xc3\x28",
      std::string(100, '['),
      std::string(100'000, '['),
      std::string(100'000, '{'),
      "{\"a\":" + std::string(500'000, ' ') + "1",
      std::string(500'000, '9'),
      "\"" + std::string(500'000, '\\')};
  RawClient rude(daemon.socket());
  rude.receive();
  for (const std::string& line : nonsense) {
    rude.send(line + "\n");
    const json answer = rude.receive();
    ASSERT_FALSE(answer.is_discarded()) << "no answer to " << line.substr(0, 80);
    EXPECT_TRUE(answer.contains("error")) << line.substr(0, 80) << " -> " << answer.dump();
  }
  rude.request(4711, "system.info");
  EXPECT_TRUE(rude.receive("id", 4711).contains("result"));
}

// Requests with bytes changed, inserted and left out, 20,000 of them: whatever they are by then,
// the connection answers the next sound one.
TEST_F(RudeClients, DamagedRequestsDoNoHarm) {
  const std::string sound =
      R"({"jsonrpc":"2.0","id":77,"method":"subscribe","params":{"topics":["machine"],"rate_hz":1}})";
  std::mt19937 random(3);
  RawClient rude(daemon.socket());
  rude.receive();
  for (int n = 1; n <= 20'000; ++n) {
    std::string line = sound;
    for (unsigned k = 0; k < 1 + random() % 4; ++k) {
      const std::size_t place = random() % line.size();
      const char byte = static_cast<char>(random());
      switch (random() % 3) {
        case 0:
          line[place] = byte;
          break;
        case 1:
          line.insert(place, 1, byte);
          break;
        default:
          line.erase(place, 1);
      }
    }
    ASSERT_TRUE(rude.send(line + "\n"));
    if (n % 20 != 0) continue;
    rude.request(100'000 + n, "session.role", {{"role", "operator"}});
    ASSERT_TRUE(rude.receive("id", 100'000 + n).contains("result")) << "behind " << line;
  }
}

}  // namespace
}  // namespace stanok::daemon

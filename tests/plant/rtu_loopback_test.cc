// Bus and simulated drives over a serial line: two pseudo terminals, joined by the test.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <random>
#include <span>
#include <string>
#include <thread>

#include "tests/plant/loopback.h"

namespace stanok::plant {
namespace {

// One end of the line: a pseudo terminal in raw mode.
struct Terminal {
  Terminal() {
    std::array<char, 128> name{};
    EXPECT_EQ(openpty(&master, &slave, name.data(), nullptr, nullptr), 0);
    termios raw{};
    tcgetattr(slave, &raw);
    cfmakeraw(&raw);
    tcsetattr(slave, TCSANOW, &raw);
    device = name.data();
  }
  ~Terminal() {
    close(master);
    close(slave);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  int master = -1;
  int slave = -1;
  std::string device;
};

// Carries bytes both ways between two terminals.
class Cable {
 public:
  Cable() : thread_([this](const std::stop_token& stop) { carry(stop); }) {}

  // From now on this share of what is carried has one byte changed.
  void disturb(double share) { noise_ = share; }

  // From now on this share of what is carried comes in two parts, the second one this much later.
  void tear(double share, std::chrono::milliseconds pause) {
    pause_ = pause;
    torn_ = share;
  }

  const std::string& one_end() const { return a_.device; }
  const std::string& other_end() const { return b_.device; }

 private:
  void carry(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::array<pollfd, 2> ends = {{{a_.master, POLLIN, 0}, {b_.master, POLLIN, 0}}};
      poll(ends.data(), ends.size(), 20);
      copy(ends[0], b_.master);
      copy(ends[1], a_.master);
    }
  }

  void copy(const pollfd& from, int to) {
    std::array<char, 512> bytes{};
    if ((from.revents & POLLIN) != 0) {
      const ssize_t count = read(from.fd, bytes.data(), bytes.size());
      if (std::bernoulli_distribution(noise_)(random_)) bytes[random_() % 8] ^= 0x10;
      std::span<const char> rest(bytes.data(), static_cast<std::size_t>(count));
      if (std::bernoulli_distribution(torn_)(random_)) {
        // Where it can, the rest begins as a frame does: with the number of the unit.
        const auto again = std::ranges::find(rest.subspan(1), rest.front());
        const std::size_t first = again == rest.end()
                                      ? random_() % rest.size()
                                      : rest.size() - static_cast<std::size_t>(rest.end() - again);
        send(rest.first(first), to);
        std::this_thread::sleep_for(pause_.load());
        rest = rest.subspan(first);
      }
      send(rest, to);
    }
  }

  static void send(std::span<const char> bytes, int to) {
    EXPECT_EQ(write(to, bytes.data(), bytes.size()), std::ssize(bytes));
  }

  Terminal a_;
  Terminal b_;
  std::atomic<double> noise_{0.0};
  std::atomic<double> torn_{0.0};
  std::atomic<std::chrono::milliseconds> pause_{};
  std::minstd_rand random_;
  std::jthread thread_;
};

class RtuLoopback : public ::testing::Test {
 protected:
  drives::BusConfig bus() const {
    drives::BusConfig config = bus_of(2);
    config.kind = drives::BusKind::modbus_rtu;
    config.device = cable.other_end();
    config.poll_ms = 5;
    return config;
  }

  void SetUp() override { server.start(); }

  Cable cable;
  ModbusServer server{{.rtu_device = cable.one_end()},
                      drives_of(bus_of(2), std::array<double, 2>{1.0, 2.0})};
};

TEST_F(RtuLoopback, DrivesOfSeveralUnitsGoToTheirTargets) {
  CycleSide cycle(bus(), 0);
  ASSERT_TRUE(cycle.switch_on());
  cycle.targets[0].position = 1.3;
  cycle.targets[1].position = 2.3;
  EXPECT_TRUE(cycle.until(
      [&] { return cycle.feedback[0].position == 1.3 && cycle.feedback[1].position == 2.3; }));
  EXPECT_EQ(cycle.bus.status().endpoint, cable.other_end());
}

TEST_F(RtuLoopback, ASilentUnitDoesNotTakeTheOtherWithIt) {
  drives::BusConfig patient = bus();
  patient.timeout_ms = 2000;  // what the other drive may lack on a loaded computer
  CycleSide cycle(patient, 0);
  ASSERT_TRUE(cycle.switch_on());
  server.inject(0, FaultKind::off);
  ASSERT_TRUE(cycle.until([&] { return !cycle.feedback[0].valid; }));
  const std::uint32_t sequence = cycle.feedback[1].sequence;
  EXPECT_TRUE(cycle.until([&] {
    return !cycle.feedback[0].valid && cycle.feedback[1].valid &&
           cycle.feedback[1].sequence > sequence + 20;
  }));
}

// A changed byte spoils a request or an answer: contact is kept, and the axes go on.
TEST_F(RtuLoopback, NoiseOnTheLineIsBorne) {
  drives::BusConfig noisy = bus();
  noisy.poll_ms = 20;
  noisy.timeout_ms = 3000;
  CycleSide cycle(noisy, 0);
  ASSERT_TRUE(cycle.switch_on());
  cable.disturb(0.1);
  cycle.targets[0].position = 1.3;
  const auto errors = [&] {
    return cycle.errors(drives::ExchangeError::mangled) +
           cycle.errors(drives::ExchangeError::timeout) +
           cycle.errors(drives::ExchangeError::stuck);
  };
  ASSERT_TRUE(cycle.until([&] {
    return errors() > 5 && cycle.feedback[0].sequence > 60 && cycle.feedback[1].sequence > 60;
  }));
  EXPECT_EQ(cycle.feedback[0].losses, 0U);
  EXPECT_EQ(cycle.feedback[1].losses, 0U);
  EXPECT_TRUE(cycle.until([&] { return cycle.feedback[0].position == 1.3; }));
}

// On a line without transaction numbers an answer that comes too late meets a later request. It is
// a time-out, as nothing was wrong with the frame, and the other drive stays in contact.
TEST_F(RtuLoopback, LateAnswersAreTimeOutsAndNotBrokenFrames) {
  CycleSide cycle(bus(), 0);
  ASSERT_TRUE(cycle.switch_on());
  server.inject(0, FaultKind::slow);
  const std::uint32_t sequence = cycle.feedback[1].sequence;
  ASSERT_TRUE(cycle.until([&] {
    return cycle.errors(drives::ExchangeError::timeout) > 20 &&
           cycle.feedback[1].sequence > sequence + 50;
  }));
  EXPECT_EQ(cycle.errors(drives::ExchangeError::mangled), 0U);
  EXPECT_EQ(cycle.errors(drives::ExchangeError::implausible), 0U);
  EXPECT_EQ(cycle.feedback[1].losses, 0U);
}

// A device, an adapter or this computer pauses in the middle of a frame: its end comes when another
// request is out already.
TEST_F(RtuLoopback, EndsOfLateAnswersAreTimeOutsToo) {
  CycleSide cycle(bus(), 0);
  ASSERT_TRUE(cycle.switch_on());
  cable.tear(0.05, std::chrono::milliseconds(60));
  ASSERT_TRUE(cycle.until([&] {
    return cycle.errors(drives::ExchangeError::timeout) > 20 && cycle.feedback[1].sequence > 100;
  }));
  EXPECT_EQ(cycle.errors(drives::ExchangeError::mangled), 0U);
  EXPECT_EQ(cycle.errors(drives::ExchangeError::implausible), 0U);
}

TEST_F(RtuLoopback, BrokenFramesAreDiscarded) {
  CycleSide cycle(bus(), 0);
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  server.inject(1, FaultKind::mangled);
  ASSERT_TRUE(cycle.until([&] { return !cycle.feedback[1].valid; }));
  EXPECT_EQ(cycle.feedback[1].position, 2.0);
  server.inject(1, FaultKind::none);
  EXPECT_TRUE(cycle.until([&] { return cycle.feedback[1].valid; }));
}

}  // namespace
}  // namespace stanok::plant

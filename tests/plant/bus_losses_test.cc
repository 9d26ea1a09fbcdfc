// A whole bus of moving axes whose requests get lost on the way: contact is kept while one in five
// is lost, and every answer that comes is used.
//
// STANOK_BUS_ANSWERS and STANOK_BUS_TIMEOUT_MS make a measurement of it
// (docs/integrator/drives.md#losses).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "tests/plant/loopback.h"
#include "tests/plant/lossy_path.h"

namespace stanok::plant {
namespace {

constexpr int axis_count = 7;

int number_of(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::stoi(text);
}

struct Losses {
  Loss loss;
  double share;
  int poll_ms;
};

class BusLosses : public ::testing::TestWithParam<Losses> {};

// The time-out is longer than that of a machine file, so that a busy computer is not taken for a
// loss on the bus.
TEST_P(BusLosses, ContactIsKeptWhileAxesMove) {
  const Losses& losses = GetParam();
  const auto answers = static_cast<std::uint32_t>(number_of("STANOK_BUS_ANSWERS", 60));
  drives::BusConfig bus = bus_of(axis_count);
  bus.poll_ms = losses.poll_ms;
  bus.timeout_ms = number_of("STANOK_BUS_TIMEOUT_MS", 1500);
  for (drives::AxisDriveConfig& axis : bus.axes) axis.following_error_max = 5.0;
  const std::vector<double> start(axis_count, 0.0);
  ModbusServer server({}, drives_of(bus, start));
  server.start();
  LossyPath path(server.port(), losses.loss, losses.share, 23);
  CycleSide cycle(bus, path.port());
  ASSERT_TRUE(cycle.switch_on());
  std::uint32_t fewest = 0;
  std::uint32_t oldest = 0;
  const std::uint32_t begin = cycle.feedback[0].sequence;
  while (fewest < answers) {
    fewest = answers;
    for (std::size_t k = 0; k < axis_count; ++k) {
      drives::DriveTarget& target = cycle.targets[k];
      target.velocity = target.position < 100.0 ? 10.0 : 0.0;  // a cycle of 1 ms
      target.position += target.velocity * 1e-3;
      const drives::DriveFeedback& feedback = cycle.feedback[k];
      ASSERT_EQ(feedback.losses, 0U) << "axis " << k << " after " << feedback.sequence;
      ASSERT_TRUE(feedback.valid) << "axis " << k;
      ASSERT_EQ(feedback.state, drives::DriveState::operation_enabled) << "axis " << k;
      fewest = std::min(fewest, feedback.sequence - begin);
      oldest = std::max(oldest, feedback.age_cycles);
    }
    cycle.run();
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  EXPECT_GT(path.losses(), 0U);
  std::cout << "lost " << path.losses() << " of " << path.requests()
            << " requests; the oldest feedback was " << oldest << " cycles old\n";
}

std::vector<Losses> all_losses() {
  std::vector<Losses> all;
  for (const Loss loss : {Loss::dropped, Loss::connection_closed}) {
    for (const double share : {0.02, 0.05, 0.10, 0.20}) {
      for (const int poll_ms : {10, 50}) all.push_back({loss, share, poll_ms});
    }
  }
  return all;
}

std::string losses_name(const ::testing::TestParamInfo<Losses>& one) {
  const char* loss = one.param.loss == Loss::dropped ? "dropped_" : "closed_";
  return loss + std::to_string(std::lround(100.0 * one.param.share)) + "_percent_poll_" +
         std::to_string(one.param.poll_ms) + "_ms";
}

INSTANTIATE_TEST_SUITE_P(Shares, BusLosses, ::testing::ValuesIn(all_losses()), losses_name);

}  // namespace
}  // namespace stanok::plant

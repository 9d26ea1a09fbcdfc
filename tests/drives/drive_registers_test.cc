// The register blocks word by word, as docs/drives.md#registers gives them.
#include "drives/modbus/drive_registers.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace stanok::drives {
namespace {

constexpr auto int32_min = std::numeric_limits<std::int32_t>::min();
constexpr auto int32_max = std::numeric_limits<std::int32_t>::max();

TEST(DriveRegisters, CommandHasTheHighWordFirst) {
  const CommandBlock block{.control_word = 0x080F,
                           .target_position = 0x12345678,
                           .target_velocity = -2,
                           .heartbeat = 0xABCD};
  EXPECT_EQ(to_registers(block),
            (CommandRegisters{0x080F, 0x1234, 0x5678, 0xFFFF, 0xFFFE, 0xABCD}));
}

TEST(DriveRegisters, StatusHasTheHighWordFirst) {
  const StatusBlock block{.status_word = 0x1237,
                          .position = -1,
                          .velocity = 65536,
                          .following_error = int32_min,
                          .power_w = -3,
                          .vibration = 65535,
                          .vibration_frequency = 1200,
                          .fault_code = 0x8611,
                          .heartbeat_echo = 7};
  EXPECT_EQ(to_registers(block), (StatusRegisters{0x1237, 0xFFFF, 0xFFFF, 0x0001, 0x0000, 0x8000,
                                                  0x0000, 0xFFFD, 0xFFFF, 1200, 0x8611, 7}));
}

TEST(DriveRegisters, ComeBackUnchangedForAnyValues) {
  const unsigned seed = 402;
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> any32(int32_min, int32_max);
  std::uniform_int_distribution<int> any16(0, 65535);
  const auto word = [&] { return static_cast<std::uint16_t>(any16(random)); };
  for (int i = 0; i < 10000; ++i) {
    const CommandBlock command{word(), any32(random), any32(random), word()};
    EXPECT_EQ(command_block(to_registers(command)), command) << "seed " << seed;
    const StatusBlock status{
        word(), any32(random), any32(random), any32(random), static_cast<std::int16_t>(word()),
        word(), word(),        word(),        word()};
    EXPECT_EQ(status_block(to_registers(status)), status) << "seed " << seed;
  }
}

TEST(Increments, RoundToTheNearest) {
  EXPECT_EQ(increments(1.2345, 1000.0), 1235);  // 1234.5 away from zero
  EXPECT_EQ(increments(-0.0004, 1000.0), 0);
  EXPECT_EQ(increments(-350.0, 1000.0), -350000);
}

TEST(Increments, RefuseWhatThirtyTwoBitsDoNotHold) {
  EXPECT_EQ(increments(2147483.647, 1000.0), int32_max);
  EXPECT_EQ(increments(2147483.648, 1000.0), std::nullopt);
  EXPECT_EQ(increments(std::numeric_limits<double>::quiet_NaN(), 1000.0), std::nullopt);
  EXPECT_EQ(increments(std::numeric_limits<double>::infinity(), 1000.0), std::nullopt);
}

}  // namespace
}  // namespace stanok::drives

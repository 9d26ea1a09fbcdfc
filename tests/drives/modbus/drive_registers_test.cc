// The register blocks word by word, as docs/integrator/drives.md#registers gives them, and as other
// maps do.
#include "drives/modbus/drive_registers.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <vector>

namespace stanok::drives {
namespace {

constexpr auto int32_min = std::numeric_limits<std::int32_t>::min();
constexpr auto int32_max = std::numeric_limits<std::int32_t>::max();

using Words = std::vector<std::uint16_t>;

template <class Block>
Words image_of(const RegisterMap& map, const Block& block) {
  Words image(static_cast<std::size_t>(register_count(map)));
  write_block(map, block, image);
  return image;
}

Words part(const Words& image, std::ptrdiff_t first, std::ptrdiff_t count) {
  return {image.begin() + first, image.begin() + first + count};
}

TEST(DriveRegisters, CommandHasTheHighWordFirst) {
  const CommandBlock block{.control_word = 0x080F,
                           .target_position = 0x12345678,
                           .target_velocity = -2,
                           .heartbeat = 0xABCD};
  EXPECT_EQ(part(image_of(register_map({}), block), 0, 6),
            (Words{0x080F, 0x1234, 0x5678, 0xFFFF, 0xFFFE, 0xABCD}));
}

TEST(DriveRegisters, StatusHasTheHighWordFirst) {
  const StatusBlock block{.status_word = 0x1237,
                          .position = -1,
                          .velocity = 65536,
                          .following_error = int32_min,
                          .power = -3,
                          .vibration = 65535,
                          .vibration_frequency = 1200,
                          .fault_code = 0x8611,
                          .heartbeat_echo = 7,
                          .inputs = 0x0005,
                          .index_position = -65537,
                          .index_count = 9,
                          .temperature = -12};
  const Words image = image_of(register_map({.status = 200}), block);
  EXPECT_EQ(part(image, 200, 17),
            (Words{0x1237, 0xFFFF, 0xFFFF, 0x0001, 0x0000, 0x8000, 0x0000, 0xFFFD, 0xFFFF, 1200,
                   0x8611, 7, 0x0005, 0xFFFE, 0xFFFF, 9, 0xFFF4}));
  EXPECT_EQ(image.size(), 217U);
}

TEST(DriveRegisters, AFieldSaysWidthSignAndOrderOfWords) {
  RegisterMap map;
  map.status_word = {.address = 3};
  map.position = {.address = 8, .words = 2, .order = WordOrder::low_first};
  map.velocity = {.address = 1, .is_signed = true};
  map.power = {.address = 5};
  const Words image = {0, 0xFFFE, 0, 0x0237, 0, 0xFFFE, 0, 0, 0x5678, 0x1234};
  const StatusBlock status = status_block(map, image);
  EXPECT_EQ(status.status_word, 0x0237);
  EXPECT_EQ(status.position, 0x12345678);
  EXPECT_EQ(status.velocity, -2);
  EXPECT_EQ(status.power, 65534);
  EXPECT_EQ(status.temperature, 0) << "the map has none";
  EXPECT_EQ(image_of(map, status), image);
}

TEST(DriveRegisters, ComeBackUnchangedForAnyValues) {
  const unsigned seed = 402;
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> any32(int32_min, int32_max);
  std::uniform_int_distribution<int> any16(0, 65535);
  const auto word = [&] { return static_cast<std::uint16_t>(any16(random)); };
  const auto signed_word = [&] { return std::int32_t{static_cast<std::int16_t>(word())}; };
  RegisterMap map = register_map({});
  map.position.order = WordOrder::low_first;
  for (int i = 0; i < 10000; ++i) {
    const CommandBlock command{word(), any32(random), any32(random), word()};
    EXPECT_EQ(command_block(map, image_of(map, command)), command) << "seed " << seed;
    const StatusBlock status{
        word(), any32(random), any32(random), any32(random), signed_word(), word(),       word(),
        word(), word(),        word(),        any32(random), word(),        signed_word()};
    EXPECT_EQ(status_block(map, image_of(map, status)), status) << "seed " << seed;
  }
}

TEST(RegisterField, RoundsToTheNearestIncrement) {
  const RegisterField field{.address = 0, .words = 2, .scale = 1000.0};
  EXPECT_EQ(field.increments(1.2345), 1235);  // 1234.5 away from zero
  EXPECT_EQ(field.increments(-0.0004), 0);
  EXPECT_EQ(field.increments(-350.0), -350000);
}

TEST(RegisterField, RefusesWhatThirtyTwoBitsDoNotHold) {
  const RegisterField field{.address = 0, .words = 2, .scale = 1000.0};
  EXPECT_EQ(field.increments(2147483.647), int32_max);
  EXPECT_EQ(field.increments(2147483.648), std::nullopt);
  EXPECT_EQ(field.increments(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
  EXPECT_EQ(field.increments(std::numeric_limits<double>::infinity()), std::nullopt);
}

TEST(RegisterField, HasScaleAndOffset) {
  // A temperature of 0.1 K per increment from -40 deg C: 25 deg C are (25 + 40) * 10.
  const RegisterField field{.address = 0, .scale = 10.0, .offset = 400.0};
  EXPECT_EQ(field.increments(25.0), 650);
  EXPECT_EQ(field.value(650), 25.0);
  EXPECT_EQ(field.increments(-40.1), std::nullopt) << "16 bits without sign";
  EXPECT_EQ(field.saturated_increments(-41.0), 0);
  EXPECT_EQ(field.saturated_increments(1e9), 65535);
  const RegisterField reversed{.address = 0, .is_signed = true, .scale = -2.0};
  EXPECT_EQ(reversed.increments(7.0), -14);
  EXPECT_EQ(reversed.value(-14), 7.0);
  EXPECT_EQ(reversed.saturated_increments(20000.0), -32768);
}

}  // namespace
}  // namespace stanok::drives

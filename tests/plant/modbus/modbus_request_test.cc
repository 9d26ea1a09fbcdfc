// Requests as bytes, from the examples of the Modbus specifications.
#include "plant/modbus/modbus_request.h"

#include <gtest/gtest.h>

#include <random>

namespace stanok::plant {
namespace {

using Bytes = std::vector<std::uint8_t>;

// MODBUS Application Protocol V1.1b3, example of clause 6.17.
const Bytes read_write_example = {0x17, 0x00, 0x03, 0x00, 0x06, 0x00, 0x0E, 0x00,
                                  0x03, 0x06, 0x00, 0xFF, 0x00, 0xFF, 0x00, 0xFF};

TEST(RegisterWrite, ReadsFunction23) {
  const auto write = register_write(read_write_example);
  ASSERT_TRUE(write);
  EXPECT_EQ(write->first, 14);
  EXPECT_EQ(write->values, (std::vector<std::uint16_t>{0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(write->read.first, 3);
  EXPECT_EQ(write->read.count, 6);
}

TEST(RegisterWrite, ReadsFunctions6And16) {
  const auto single = register_write(Bytes{0x06, 0x00, 0x01, 0x00, 0x03});
  ASSERT_TRUE(single);
  EXPECT_EQ(single->first, 1);
  EXPECT_EQ(single->values, std::vector<std::uint16_t>{3});
  const auto multiple =
      register_write(Bytes{0x10, 0x00, 0x01, 0x00, 0x02, 0x04, 0x00, 0x0A, 0x01, 0x02});
  ASSERT_TRUE(multiple);
  EXPECT_EQ(multiple->values, (std::vector<std::uint16_t>{0x000A, 0x0102}));
}

TEST(RegisterWrite, IsNothingForReadsAndBrokenRequests) {
  EXPECT_FALSE(register_write(Bytes{0x03, 0x00, 0x6B, 0x00, 0x03}));
  EXPECT_FALSE(register_write(Bytes{}));
  for (std::size_t length = 0; length < read_write_example.size(); ++length) {
    EXPECT_FALSE(register_write(std::span(read_write_example).first(length))) << length;
  }
}

TEST(Crc16, IsThatOfTheCheckString) {
  // The published check value of CRC-16/MODBUS for "123456789".
  const Bytes check = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc16(check), 0x4B37);
}

Bytes with_crc(Bytes frame) {
  const std::uint16_t crc = crc16(frame);
  frame.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}

TEST(RtuRequestReader, CutsRequestsHoweverTheyArrive) {
  Bytes line;
  const Bytes read = with_crc({0x02, 0x03, 0x00, 0x64, 0x00, 0x0C});
  Bytes unit_and_request = {0x05};
  unit_and_request.insert(unit_and_request.end(), read_write_example.begin(),
                          read_write_example.end());
  const Bytes read_write = with_crc(unit_and_request);
  line.insert(line.end(), read.begin(), read.end());
  line.insert(line.end(), read_write.begin(), read_write.end());

  RtuRequestReader reader;
  std::vector<Bytes> requests;
  for (const std::uint8_t byte : line) {
    reader.append(std::span(&byte, 1));
    if (auto request = reader.next()) {
      requests.push_back(*request);
    }
  }
  EXPECT_EQ(requests, (std::vector<Bytes>{read, read_write}));
  EXPECT_TRUE(reader.is_empty());
}

TEST(RtuRequestReader, DiscardsABadCrcAndAnUnknownFunction) {
  RtuRequestReader reader;
  Bytes bad = with_crc({0x02, 0x03, 0x00, 0x64, 0x00, 0x0C});
  bad.back() ^= 1;
  reader.append(bad);
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.is_empty());
  reader.append(Bytes{0x02, 0x63});
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.is_empty());
}

TEST(RtuRequestReader, SurvivesNoise) {
  const unsigned seed = 485;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, 255);
  RtuRequestReader reader;
  for (int i = 0; i < 100000; ++i) {
    const auto byte = static_cast<std::uint8_t>(any(random));
    reader.append(std::span(&byte, 1));
    if (const auto request = reader.next()) {
      EXPECT_EQ(crc16(*request), 0) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace stanok::plant

// Logs that are whole, cut, and damaged in the middle.
#include "recording/log/log_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <random>

#include "recording/read/log_contents.h"
#include "tests/recording/recorded_log.h"

namespace stanok::recording {
namespace {

constexpr int recorded_cycles = 200;
// Behind LOG_META, behind 64 and 128 kB, at the flush, and the trailer.
constexpr std::int64_t checks = 5;
// LOG_META, LOG_TYPES, the tool, a setpoint every cycle, the state and the process every 50 ms.
constexpr std::int64_t events = 3 + recorded_cycles + 2 * (recorded_cycles / 50) + checks;

class LogReading : public ::testing::Test {
 protected:
  void SetUp() override {
    record(file_, recorded_cycles);
    bytes_ = bytes_of(file_);
  }
  // Where event `number` begins: found by its header, not by the reader.
  [[nodiscard]] std::size_t begin_of(std::int64_t number) const {
    Bytes head{0xED, 0xA1, 0xDA, 0x01};
    for (int shift = 56; shift >= 0; shift -= 8) {
      head.push_back(static_cast<std::uint8_t>(number >> shift));
    }
    const auto found = std::search(bytes_.begin(), bytes_.end(), head.begin(), head.end());
    return static_cast<std::size_t>(found - bytes_.begin());
  }
  [[nodiscard]] LogContents contents() const {
    write_bytes(file_, bytes_);
    auto read = read_contents(file_);
    EXPECT_TRUE(read);
    return read ? *read : LogContents{};
  }

  std::filesystem::path file_ = test_file("lcm");
  Bytes bytes_;
};

TEST_F(LogReading, CountsEveryMessageOfASoundLog) {
  const LogContents log = contents();
  EXPECT_TRUE(log.is_sound());
  EXPECT_EQ(log.events, events);
  EXPECT_EQ(log.bytes, static_cast<std::int64_t>(bytes_.size()));
  EXPECT_EQ(log.utime_last, (recorded_cycles - 1) * 1000);
  EXPECT_EQ(log.channels.at(setpoint_channel).messages, recorded_cycles);
  ASSERT_TRUE(log.description);
  EXPECT_EQ(log.description->machine, "mill");
  EXPECT_EQ(log.description->channels.at(0).axes.at(1).name, "C1");
}

TEST_F(LogReading, ReadsACutFileUpToTheCut) {
  const std::size_t cut = begin_of(100);
  bytes_.resize(cut + 40);
  const LogContents log = contents();
  EXPECT_EQ(log.events, 100);
  ASSERT_EQ(log.damage.size(), 1U);
  EXPECT_EQ(log.damage[0].kind, DamageKind::cut);
  EXPECT_EQ(log.damage[0].offset, static_cast<std::int64_t>(cut));
  EXPECT_EQ(log.damage[0].bytes, 40);
}

TEST_F(LogReading, GoesOnBehindGarbageBetweenEvents) {
  const std::size_t place = begin_of(100);
  bytes_.insert(bytes_.begin() + static_cast<std::ptrdiff_t>(place), 1000, std::uint8_t{0x5A});
  const LogContents log = contents();
  EXPECT_EQ(log.events, events);
  ASSERT_EQ(log.damage.size(), 1U);
  EXPECT_EQ(log.damage[0].kind, DamageKind::unreadable);
  EXPECT_EQ(log.damage[0].offset, static_cast<std::int64_t>(place));
  EXPECT_EQ(log.damage[0].bytes, 1000);
}

TEST_F(LogReading, LosesOnlyTheEventThatMissesBytes) {
  const std::size_t place = begin_of(100);
  const auto hole = bytes_.begin() + static_cast<std::ptrdiff_t>(place) + 200;
  bytes_.erase(hole, hole + 50);
  const LogContents log = contents();
  EXPECT_EQ(log.events, events - 1);
  ASSERT_EQ(log.damage.size(), 1U);
  EXPECT_EQ(log.damage[0].offset, static_cast<std::int64_t>(place));
  EXPECT_EQ(log.channels.at(setpoint_channel).missing, 1);
}

TEST_F(LogReading, IsNotLedAwayByAWrongLength) {
  const std::size_t place = begin_of(100);
  bytes_[place + 25] = 0x10;  // 1 MiB instead of 604 bytes: beyond the end of the file
  const LogContents log = contents();
  EXPECT_EQ(log.events, events - 1);
  EXPECT_FALSE(log.is_sound());
}

TEST_F(LogReading, TellsMessagesThatCannotBeDecoded) {
  bytes_[begin_of(100) + 28 + std::string(setpoint_channel).size()] ^= 0xFF;
  const LogContents log = contents();
  EXPECT_EQ(log.events, events);
  EXPECT_FALSE(log.is_sound());
  EXPECT_EQ(log.channels.at(setpoint_channel).undecodable, 1);
}

TEST_F(LogReading, AccountsForEveryByteOfRandomlyDamagedLogs) {
  const Bytes sound = bytes_;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    bytes_ = sound;
    for (int k = 0; k < 20; ++k)
      bytes_[random() % bytes_.size()] = static_cast<std::uint8_t>(random());
    write_bytes(file_, bytes_);
    auto reader = LogReader::open(file_);
    ASSERT_TRUE(reader);
    std::size_t accounted = 0;
    while (const auto event = reader->next()) {
      accounted += 28 + event->channel.size() + event->bytes.size();
    }
    for (const Damage& damage : reader->damage()) {
      accounted += static_cast<std::size_t>(damage.bytes);
    }
    EXPECT_EQ(accounted, bytes_.size());
  }
}

TEST(LogReader, ReadsAnEmptyFileAsNoEvents) {
  const auto file = test_file("lcm");
  write_bytes(file, {});
  const auto log = read_contents(file);
  ASSERT_TRUE(log);
  EXPECT_EQ(log->events, 0);
  EXPECT_TRUE(log->is_sound());
}

TEST(LogReader, SaysWhyAFileCannotBeOpened) {
  const auto log = read_contents("/nowhere/x.lcm");
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().system_error, ENOENT);
}

// Outputs that the recorder was too late for have no running number.
TEST(LogWithAGap, MissesTheSetpointsOfCyclesThatNeverCame) {
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    MessageStream stream(small_machine(), {writer->get()});
    for (int cycle = 100; cycle < 300; ++cycle) {
      if (cycle < 150 || cycle >= 167) stream.cycle(output_of(cycle));
    }
  }
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_EQ(contents->channels.at(setpoint_channel).missing, 17);
}

}  // namespace
}  // namespace stanok::recording

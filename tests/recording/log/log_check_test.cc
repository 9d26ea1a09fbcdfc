// No byte of a log can change, and no event be missing, unnoticed.
#include "recording/log/log_check.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <numeric>

#include "recording/format/channel_names.h"
#include "recording/read/log_contents.h"
#include "tests/recording/recorded_log.h"
#include "tests/support/sanitized.h"

namespace stanok::recording {
namespace {

// Every kind of message, and places in them that nobody uses.
void record_everything(const std::filesystem::path& file) {
  auto writer = LogWriter::open(file);
  ASSERT_TRUE(writer);
  MessageStream stream(small_machine(), {writer->get()});
  stream.text({.cycle = 0, .name = "part.nc", .text = "G0 X1\nM30\n"});
  stream.program_read({.name = "part.nc", .path = "/p/part.nc", .text = "M30\n", .found = true}, 0);
  for (std::int64_t cycle = 1; cycle <= 5; ++cycle) {
    channels::InputRecord input;
    input.cycle = cycle;
    input.channel = 1;
    stream.input(input);
    channels::CycleOutput output = output_of(cycle);
    output.channels[0].has_feedback = true;
    output.channels[0].arrivals.chunks = static_cast<std::uint64_t>(cycle);
    stream.cycle(output);
    if (cycle == 3) {
      ASSERT_TRUE((*writer)->flush());
    }
  }
  channels::Event event;
  event.cycle = 5;
  event.code = FixedText<8>("A1001");
  stream.event(event);
}

// As `log verify` and `log info` judge.
bool is_whole(const std::filesystem::path& file) {
  const auto contents = read_contents(file);
  return contents && contents->is_sound() && !contents->is_cut() &&
         contents->coverage.is_complete();
}

struct Place {
  std::size_t begin = 0;
  std::size_t size = 0;
};

class LogChecks : public ::testing::Test {
 protected:
  void SetUp() override {
    record_everything(file_);
    bytes_ = bytes_of(file_);
    auto reader = LogReader::open(file_);
    ASSERT_TRUE(reader);
    while (const auto event = reader->next())
      events_.push_back({static_cast<std::size_t>(event->offset), event->whole.size()});
  }
  // The log with its events in that order.
  [[nodiscard]] bool is_whole_as(const std::vector<std::size_t>& order) const {
    Bytes bytes;
    for (const std::size_t number : order) {
      const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(events_[number].begin);
      bytes.insert(bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(events_[number].size));
    }
    write_bytes(file_, bytes);
    return is_whole(file_);
  }
  [[nodiscard]] std::vector<std::size_t> order() const {
    std::vector<std::size_t> numbers(events_.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
  }

  std::filesystem::path file_ = test_file("lcm");
  Bytes bytes_;
  std::vector<Place> events_;
};

// A published check value of CRC-32: "123456789".
TEST(CheckSum, IsCrc32) {
  const Bytes digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(check_sum(0, digits), 0xCBF43926U);
  const std::span<const std::uint8_t> parts(digits);
  EXPECT_EQ(check_sum(check_sum(0, parts.first(4)), parts.subspan(4)), 0xCBF43926U);
}

TEST_F(LogChecks, CoverALogThatNobodyTouched) {
  EXPECT_TRUE(is_whole(file_));
  EXPECT_TRUE(is_whole_as(order()));
  const auto contents = read_contents(file_);
  EXPECT_EQ(contents->coverage.end, LogEnd::complete);
  EXPECT_EQ(contents->coverage.sound_bytes, static_cast<std::int64_t>(bytes_.size()));
}

TEST_F(LogChecks, NoticeEveryByteThatChanges) {
  const int descriptor = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_GE(descriptor, 0);
  int unnoticed = 0;
  constexpr std::size_t step = testing::is_sanitized ? 13 : 1;
  for (std::size_t offset = 0; offset < bytes_.size(); offset += step) {
    const auto at = static_cast<::off_t>(offset);
    const auto changed = static_cast<std::uint8_t>(bytes_[offset] ^ 1U << offset % 8);
    ASSERT_EQ(::pwrite(descriptor, &changed, 1, at), 1);
    if (is_whole(file_)) {
      ++unnoticed;
      ADD_FAILURE() << "byte " << offset;
    }
    ASSERT_EQ(::pwrite(descriptor, &bytes_[offset], 1, at), 1);
  }
  ::close(descriptor);
  EXPECT_EQ(unnoticed, 0);
  EXPECT_TRUE(is_whole(file_));
}

TEST_F(LogChecks, NoticeACutAtEveryByteAndEveryEvent) {
  constexpr std::size_t every_byte_of = testing::cases(1500U);
  for (std::size_t size = bytes_.size() - 1; size > bytes_.size() - every_byte_of; --size) {
    std::filesystem::resize_file(file_, size);
    EXPECT_FALSE(is_whole(file_)) << "cut at byte " << size;
  }
  for (auto event = events_.rbegin(); event != events_.rend(); ++event) {
    if (event->begin > std::filesystem::file_size(file_)) continue;
    std::filesystem::resize_file(file_, event->begin);
    EXPECT_FALSE(is_whole(file_)) << "cut at the event at byte " << event->begin;
  }
}

TEST_F(LogChecks, NoticeAnEventThatIsMissing) {
  for (std::size_t missing = 0; missing < events_.size(); ++missing) {
    std::vector<std::size_t> numbers = order();
    numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_FALSE(is_whole_as(numbers)) << missing;
  }
}

TEST_F(LogChecks, NoticeAnEventThatIsThereTwice) {
  for (std::size_t twice = 0; twice < events_.size(); ++twice) {
    std::vector<std::size_t> numbers = order();
    numbers.insert(numbers.begin() + static_cast<std::ptrdiff_t>(twice), twice);
    EXPECT_FALSE(is_whole_as(numbers)) << twice;
  }
}

TEST_F(LogChecks, NoticeEventsInAnotherOrder) {
  for (std::size_t first = 0; first + 1 < events_.size(); ++first) {
    std::vector<std::size_t> numbers = order();
    std::swap(numbers[first], numbers[first + 1]);
    EXPECT_FALSE(is_whole_as(numbers)) << first;
  }
}

TEST_F(LogChecks, NoticeBytesBehindTheTrailer) {
  bytes_.push_back(0);
  write_bytes(file_, bytes_);
  EXPECT_FALSE(is_whole(file_));
}

// What a check says of the place of a change, and that what stands before it is sound.
TEST_F(LogChecks, NameTheGroupOfAChange) {
  const std::size_t changed = bytes_.size() - 200;
  bytes_[changed] ^= 0x10U;
  write_bytes(file_, bytes_);
  const auto contents = read_contents(file_);
  ASSERT_TRUE(contents);
  ASSERT_EQ(contents->damage.size(), 1U);
  const Damage& damage = contents->damage.front();
  EXPECT_EQ(damage.kind, DamageKind::altered);
  EXPECT_LE(damage.offset, static_cast<std::int64_t>(changed));
  EXPECT_GT(damage.offset + damage.bytes, static_cast<std::int64_t>(changed));
  EXPECT_EQ(contents->coverage.sound_bytes, damage.offset);
  EXPECT_GT(damage.offset, 0) << "the flush made a check between";
}

// Which is what a crash leaves: no trailer, and all that was flushed is covered.
TEST(LogWithoutTrailer, IsSoundUpToTheLatestFlush) {
  const auto file = test_file("lcm");
  const auto copy = test_file("copy.lcm");
  auto writer = LogWriter::open(file);
  ASSERT_TRUE(writer);
  MessageStream stream(small_machine(), {writer->get()});
  for (int cycle = 0; cycle < 20; ++cycle) stream.cycle(output_of(cycle));
  ASSERT_TRUE((*writer)->flush());
  std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing);
  const auto contents = read_contents(copy);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound());
  EXPECT_TRUE(contents->is_cut());
  EXPECT_EQ(contents->coverage.sound_bytes, contents->bytes);
  EXPECT_EQ(contents->coverage.end, LogEnd::goes_on);
}

// About every 64 kB, so that a change costs no more than that.
TEST(LogWithManyCycles, HasAGroupEvery64kB) {
  const auto file = test_file("lcm");
  record(file, 2000);
  auto reader = LogReader::open(file);
  ASSERT_TRUE(reader);
  std::int64_t checked = 0;
  while (const auto event = reader->next()) {
    if (topic_of(event->channel) != name_of(Topic::log_check)) continue;
    EXPECT_LT(event->offset - checked, 70'000);
    checked = event->offset;
  }
  EXPECT_GT(checked, 1'000'000);
  EXPECT_TRUE(is_whole(file));
}

TEST(LogPiecesWithChecks, SayWhetherAnotherOneFollows) {
  const auto file = test_file("lcm");
  int pieces = 0;
  {
    auto writer = LogWriter::open(file, 50'000);
    ASSERT_TRUE(writer);
    MessageStream stream(small_machine(), {writer->get()});
    for (int cycle = 0; cycle < 300; ++cycle) stream.cycle(output_of(cycle));
    pieces = (*writer)->status().pieces;
  }
  ASSERT_GT(pieces, 2);
  for (int piece = 1; piece <= pieces; ++piece) {
    const auto contents = read_contents(piece_name(file, piece));
    ASSERT_TRUE(contents);
    EXPECT_TRUE(contents->coverage.is_complete()) << piece;
    EXPECT_EQ(contents->coverage.end, piece == pieces ? LogEnd::complete : LogEnd::next_piece);
  }
}

}  // namespace
}  // namespace stanok::recording

// A log that is played gives every message once more, in order; what is damaged is left out and
// told.
#include "recording/read/log_play.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "recording/log/log_writer.h"
#include "tests/config/temporary_files.h"

namespace stanok::recording {
namespace {

struct Message {
  std::string channel;
  std::int64_t utime;
  std::vector<std::uint8_t> bytes;
  friend bool operator==(const Message&, const Message&) = default;
};

class Collector final : public MessageSink {
 public:
  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override {
    messages.push_back({channel, utime, {bytes.begin(), bytes.end()}});
  }
  std::vector<Message> messages;
};

class PlayTest : public ::testing::Test {
 protected:
  PlayTest() {
    auto writer = LogWriter::open(path());
    for (int k = 0; k < 100; ++k) {
      sent.push_back({"CHANNEL_" + std::to_string(k % 3), 1'000'000 + 10'000 * k,
                      std::vector<std::uint8_t>(static_cast<std::size_t>(20 + k),
                                                static_cast<std::uint8_t>(k))});
      (*writer)->send(sent.back().channel, sent.back().utime, sent.back().bytes);
    }
    EXPECT_TRUE((*writer)->flush());
  }
  [[nodiscard]] std::filesystem::path path() const { return files.folder() / "run.lcm"; }

  config::TemporaryFiles files;
  std::vector<Message> sent;
  Collector bus;
};

TEST_F(PlayTest, GivesEveryMessageOnceMoreInOrder) {
  const auto result = play(path(), 0.0, bus, [] { return false; });
  ASSERT_TRUE(result);
  EXPECT_EQ(bus.messages, sent);
  EXPECT_EQ(result->messages, 100);
  EXPECT_DOUBLE_EQ(result->recorded_s, 0.99);
  EXPECT_TRUE(result->damage.empty());
}

TEST_F(PlayTest, GoesToTheCutAndSaysWhere) {
  std::int64_t last = 0;
  auto reader = LogReader::open(path());
  while (const auto event = reader->next()) {
    if (event->channel.starts_with("CHANNEL_")) last = event->offset;
  }
  std::filesystem::resize_file(path(), static_cast<std::uintmax_t>(last) + 30);
  const auto result = play(path(), 0.0, bus, [] { return false; });
  ASSERT_TRUE(result);
  EXPECT_EQ(result->messages, 99);
  ASSERT_EQ(result->damage.size(), 1U);
  EXPECT_EQ(result->damage[0].kind, DamageKind::cut);
}

TEST_F(PlayTest, EndsWhenItIsInterrupted) {
  int asked = 0;
  const auto result = play(path(), 0.0, bus, [&] { return ++asked > 10; });
  ASSERT_TRUE(result);
  EXPECT_EQ(result->messages, 10);
}

}  // namespace
}  // namespace stanok::recording

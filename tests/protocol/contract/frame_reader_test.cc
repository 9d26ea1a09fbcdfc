// Frames: lines out of a stream, however it was cut, and a bound on what is kept.
#include "protocol/contract/frame_reader.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stanok::protocol {
namespace {

std::vector<TextFrame> drain(FrameReader& reader) {
  std::vector<TextFrame> frames;
  while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  return frames;
}

TEST(FrameReader, GivesOneFramePerLine) {
  FrameReader reader;
  reader.append("{\"a\":1}\n{\"b\":2}\n{\"c\"");
  const auto frames = drain(reader);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].text, "{\"a\":1}");
  EXPECT_EQ(frames[1].text, "{\"b\":2}");
  EXPECT_TRUE(reader.is_within_frame());
  reader.append(":3}\n");
  EXPECT_EQ(drain(reader).at(0).text, "{\"c\":3}");
  EXPECT_FALSE(reader.is_within_frame());
}

TEST(FrameReader, PassesOverBlankLines) {
  FrameReader reader;
  reader.append("\n \t\r\n\n1\n");
  const auto frames = drain(reader);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].text, "1");
}

TEST(FrameReader, TakesALineOfExactlyTheLimit) {
  FrameReader reader(8);
  reader.append("12345678\n");
  EXPECT_EQ(drain(reader).at(0).kind, FrameKind::text);
}

TEST(FrameReader, ReportsALineThatIsTooLongOnceAndGoesOnBehindIt) {
  FrameReader reader(8);
  reader.append("123456789");
  auto frames = drain(reader);
  ASSERT_EQ(frames.size(), 1U) << "reported before its end has come";
  EXPECT_EQ(frames[0].kind, FrameKind::oversize);
  reader.append("123456789123456789");
  EXPECT_TRUE(drain(reader).empty());
  reader.append("1\nok\n");
  frames = drain(reader);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].text, "ok");
}

// Property: however the stream is cut into pieces, the frames are the same.
TEST(FrameReader, DoesNotCareHowTheStreamIsCut) {
  std::string stream;
  for (int i = 0; i < 200; ++i) {
    stream +=
        std::string(static_cast<std::size_t>(i * 7 % 23), static_cast<char>('a' + i % 26)) + "\n";
  }
  FrameReader whole(16);
  whole.append(stream);
  const auto expected = drain(whole);
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    FrameReader reader(16);
    std::vector<TextFrame> frames;
    for (std::size_t begin = 0; begin < stream.size();) {
      const std::size_t length = 1 + random() % 40;
      reader.append(std::string_view(stream).substr(begin, length));
      for (TextFrame& frame : drain(reader)) frames.push_back(std::move(frame));
      begin += length;
    }
    ASSERT_EQ(frames.size(), expected.size()) << "seed " << seed;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i].kind, expected[i].kind) << "seed " << seed << " frame " << i;
      EXPECT_EQ(frames[i].text, expected[i].text) << "seed " << seed << " frame " << i;
    }
  }
}

}  // namespace
}  // namespace stanok::protocol

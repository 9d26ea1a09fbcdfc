// Logs in pieces, what is repeated in them, and texts in chunks.
#include "recording/log/log_writer.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <stanok_messages/program_chunk_t.hpp>

#include "recording/format/decode.h"
#include "recording/read/log_contents.h"
#include "tests/recording/recorded_log.h"

namespace stanok::recording {
namespace {

constexpr const char* meta = "STANOK_MILL_LOG_META";

LogContents sound_contents(const std::filesystem::path& file) {
  const auto contents = read_contents(file);
  EXPECT_TRUE(contents) << file;
  if (!contents) return {};
  EXPECT_TRUE(contents->is_sound()) << file;
  return *contents;
}

TEST(PieceName, StandsBeforeTheExtension) {
  EXPECT_EQ(piece_name("logs/run.lcm", 1), "logs/run.lcm");
  EXPECT_EQ(piece_name("logs/run.lcm", 2), "logs/run.2.lcm");
  EXPECT_EQ(piece_name("run", 3), "run.3");
}

TEST(LogPieces, StandAloneAndLoseNothing) {
  constexpr std::int64_t size_max = 20'000;
  constexpr int cycles = 200;
  const auto file = test_file("lcm");
  int pieces = 0;
  {
    auto writer = LogWriter::open(file, size_max);
    ASSERT_TRUE(writer);
    MessageStream stream(small_machine(), {writer->get()});
    for (int cycle = 0; cycle < cycles; ++cycle) stream.cycle(output_of(cycle));
    pieces = (*writer)->status().pieces;
  }
  EXPECT_GT(pieces, 3);
  std::int64_t messages = 0;
  for (int piece = 1; piece <= pieces; ++piece) {
    SCOPED_TRACE(piece);
    const LogContents contents = sound_contents(piece_name(file, piece));
    ASSERT_TRUE(contents.description);
    EXPECT_EQ(contents.description->machine, "mill");
    EXPECT_LT(contents.bytes, size_max + 8000);  // one message more at most
    if (const auto found = contents.channels.find(setpoint_channel);
        found != contents.channels.end()) {
      messages += found->second.messages;
      EXPECT_EQ(found->second.missing, 0);
    }
  }
  EXPECT_EQ(messages, cycles);
}

// Programs and tables are in every piece, whenever they were sent.
TEST(LogPieces, BeginWithTheTexts) {
  const auto file = test_file("lcm");
  int pieces = 0;
  {
    auto writer = LogWriter::open(file, 20'000);
    ASSERT_TRUE(writer);
    MessageStream stream(small_machine(), {writer->get()});
    for (int cycle = 0; cycle < 300; ++cycle) {
      stream.cycle(output_of(cycle));
      if (cycle == 5) stream.text({.cycle = 5, .name = "part.nc", .text = "G0 X1\nM30\n"});
    }
    pieces = (*writer)->status().pieces;
    ASSERT_GT(pieces, 3);
  }
  for (int piece = 2; piece <= pieces; ++piece) {
    auto reader = LogReader::open(piece_name(file, piece));
    ASSERT_TRUE(reader);
    EXPECT_EQ(topic_of(reader->next()->channel), name_of(Topic::log_meta));
    EXPECT_EQ(topic_of(reader->next()->channel), name_of(Topic::log_check));
    EXPECT_EQ(topic_of(reader->next()->channel), name_of(Topic::log_types));
    const auto chunk = decode<program_chunk_t>(reader->next()->bytes);
    ASSERT_TRUE(chunk);
    EXPECT_EQ(text_of(chunk->name), "part.nc");
    EXPECT_NE(topic_of(reader->next()->channel), name_of(Topic::program));
  }
}

TEST(LogPieces, AreOneWithoutABound) {
  const auto file = test_file("lcm");
  record(file, 2000);
  EXPECT_EQ(sound_contents(file).channels.at(setpoint_channel).messages, 2000);
  EXPECT_FALSE(std::filesystem::exists(piece_name(file, 2)));
}

TEST(LogWriter, SaysWhyAFileCannotBeMade) {
  const auto writer = LogWriter::open("/nowhere/run.lcm");
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().system_error, ENOENT);
  EXPECT_NE(writer.error().text.find("/nowhere/run.lcm"), std::string::npos);
}

// Once at the start and once for each further minute begun.
TEST(LoggedStream, SaysWhatTheLogIsEveryMinuteOfMachineTime) {
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    MessageStream stream(small_machine(), {writer->get()});
    for (std::int64_t second = 0; second <= 150; ++second) stream.cycle(output_of(second * 1000));
  }
  EXPECT_EQ(sound_contents(file).channels.at(meta).messages, 3);
}

TEST(LoggedStream, CutsATextIntoChunksThatAddUp) {
  std::string text;
  for (int line = 0; line < 400; ++line) text += "N" + std::to_string(line) + " G1 X1.5\n";
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    MessageStream stream(small_machine(), {writer->get()});
    stream.text({.cycle = 5, .channel = 1, .run = 2, .file = 3, .name = "part.nc", .text = text});
    stream.text({.cycle = 6, .channel = 1, .run = 3, .file = 4, .name = "empty.nc", .text = ""});
  }
  auto reader = LogReader::open(file);
  ASSERT_TRUE(reader);
  std::string gathered;
  int empty_texts = 0;
  while (const auto event = reader->next()) {
    const auto chunk = decode<program_chunk_t>(event->bytes);
    if (!chunk) continue;
    empty_texts += chunk->size == 0 ? 1 : 0;
    if (chunk->size == 0) continue;
    EXPECT_EQ(chunk->offset, static_cast<std::int64_t>(gathered.size()));
    EXPECT_EQ(chunk->size, static_cast<std::int64_t>(text.size()));
    EXPECT_EQ(static_cast<std::uint64_t>(chunk->hash), text_hash(text));
    EXPECT_EQ(text_of(chunk->name), "part.nc");
    gathered.append(reinterpret_cast<const char*>(chunk->text),
                    static_cast<std::size_t>(chunk->length));
  }
  EXPECT_EQ(gathered, text);
  EXPECT_EQ(empty_texts, 1);
}

// Published test vectors of FNV-1a with 64 bit.
TEST(TextHash, IsFnv1a) {
  EXPECT_EQ(text_hash(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(text_hash("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(text_hash("foobar"), 0x85944171f73967e8ULL);
}

}  // namespace
}  // namespace stanok::recording

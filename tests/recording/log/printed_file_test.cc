// The file of printed lines: what is in it, its bound, and a disk that is full.
#include "recording/log/printed_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/support/temporary_directory.h"

namespace stanok::recording {
namespace {

namespace fs = std::filesystem;

channels::Event printing(const std::string& line) {
  channels::Event event;
  event.channel = 1;
  event.text = FixedText<240>("printed " + line);
  return event;
}

std::string lines_in(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(PrintedFile, HasTheLinesAndNothingElseOfTheLog) {
  const testing::TemporaryDirectory folder;
  PrintedFile file(folder.path() / "log", "mill-printed");
  file.take(printing("X1.5"));
  channels::Event other;
  other.text = FixedText<240>("program started");
  file.take(other);
  channels::Event alarm = printing("NOT ME");
  alarm.code = FixedText<8>("U1000");
  file.take(alarm);
  file.take(printing(""));
  EXPECT_EQ(lines_in(folder.path() / "log" / "mill-printed.txt"), "X1.5\n\n");
  EXPECT_EQ(file.error(), "");
}

TEST(PrintedFile, GivesOneLineForOneWhateverIsInIt) {
  EXPECT_EQ(printed_line_of("printed A\nB\x1b[2J"), "A B [2J");
  EXPECT_EQ(printed_line_of("measured bore size=1"), std::nullopt);
}

TEST(PrintedFile, StaysBelowItsBoundAndKeepsTheOneBefore) {
  const testing::TemporaryDirectory folder;
  PrintedFile file(folder.path(), "p", 30);
  for (int i = 0; i < 10; ++i) file.take(printing("123456789"));
  EXPECT_EQ(lines_in(folder.path() / "p.txt").size(), 10U);
  EXPECT_EQ(lines_in(folder.path() / "p.1.txt").size(), 30U);
}

TEST(PrintedFile, TellsOfAFullDiskAndGoesOnWhenThereIsRoom) {
  const testing::TemporaryDirectory folder;
  fs::create_symlink("/dev/full", folder.path() / "p.txt");
  PrintedFile file(folder.path(), "p");
  file.take(printing("LOST"));
  EXPECT_NE(file.error().find("p.txt cannot be written"), std::string::npos) << file.error();
  fs::remove(folder.path() / "p.txt");
  file.take(printing("KEPT"));
  EXPECT_EQ(file.error(), "");
  EXPECT_EQ(lines_in(folder.path() / "p.txt"), "KEPT\n");
}

}  // namespace
}  // namespace stanok::recording

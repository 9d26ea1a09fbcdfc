// The watch views on a terminal that draws what they print: pictures of every length, at every
// width.
#include "client/operator/watch_view.h"

#include <gtest/gtest.h>

#include <random>

#include "client/terminal/progress_line.h"
#include "client/terminal/screen_text.h"
#include "tests/client/fake_screen.h"

namespace stanok::client {
namespace {

using nlohmann::json;

json channel_of(int id, double x, const json& alarm) {
  return {{"id", id},
          {"name", "mill"},
          {"state", "Active"},
          {"program_status", "Running"},
          {"program", "impeller/blade.nc"},
          {"line", 1200},
          {"alarm", alarm},
          {"position", {{"X", x}, {"Y", -200.5}, {"Z", 12.125}}},
          {"override", {{"feed", 100.0}, {"rapid", 50.0}}},
          {"speed_mm_s", 41.6667}};
}

json status_of(const json& channels) {
  return {{"full", true}, {"state", {{"channels", channels}}}};
}

// What stands on a screen where only this was ever printed.
std::vector<std::string> only(const json& status, const Terminal& terminal, OperatorView kind) {
  WatchView view(OutputForm::people, terminal, kind);
  FakeScreen screen(terminal.size().columns, terminal.size().lines);
  screen.write(view.shown("status", status));
  return screen.lines();
}

TEST(WatchOnATerminal, LeavesNothingOfALongerPictureBehind) {
  const Terminal terminal(Screen::coloured, {80, 24});
  for (const OperatorView kind : {OperatorView::answer, OperatorView::overview}) {
    WatchView view(OutputForm::people, terminal, kind);
    FakeScreen screen(80, 24);
    const json alarm = {{"code", "E5101"}, {"text", "X is too far"}, {"line", 7}};
    const json long_one =
        status_of({{"1", channel_of(1, 1.5, alarm)}, {"2", channel_of(2, 2.5, alarm)}});
    const json short_one = status_of({{"1", channel_of(1, 1.75, nullptr)}});
    screen.write(view.shown("status", long_one));
    screen.write(view.shown("status", short_one));
    EXPECT_EQ(screen.lines(), only(short_one, terminal, kind));
  }
}

TEST(WatchOnATerminal, DrawsAMovingChannelInPlaceAtEveryWidth) {
  for (std::size_t columns = 1; columns <= 200; ++columns) {
    const Terminal terminal(Screen::coloured, {columns, 100});
    for (const OperatorView kind : {OperatorView::answer, OperatorView::overview}) {
      WatchView view(OutputForm::people, terminal, kind);
      FakeScreen screen(columns, 100);
      json status;
      for (int k = 0; k < 5; ++k) {
        status = status_of({{"1", channel_of(1, 1000.0 / (k + 1), nullptr)}});
        screen.write(view.shown("status", status));
      }
      ASSERT_EQ(screen.lines(), only(status, terminal, kind)) << columns << " columns";
      ASSERT_EQ(screen.wraps(), 0) << columns << " columns";
      ASSERT_TRUE(screen.scrolled().empty() || columns < 10) << columns << " columns";
    }
  }
}

TEST(WatchOnATerminal, TellsWhatHappensAboveThePicture) {
  const Terminal terminal(Screen::monochrome, {40, 60});
  WatchView view(OutputForm::people, terminal);
  FakeScreen screen(40, 60);
  const json status = status_of({{"1", channel_of(1, 1.5, nullptr)}});
  screen.write(view.shown("status", status));
  screen.write(view.shown("event", {{"cycle", 12},
                                    {"channel", 1},
                                    {"code", "A2001"},
                                    {"text", "the drive of X says fault 7, and nothing more"}}));
  screen.write(view.shown("status", status));
  std::vector<std::string> expected = {"cycle 12  channel 1  A2001  the drive",
                                       "  of X says fault 7, and nothing more"};
  const auto picture = only(status, terminal, OperatorView::answer);
  expected.insert(expected.end(), picture.begin(), picture.end());
  EXPECT_EQ(screen.lines(), expected);
}

TEST(WatchOnATerminal, CutsAPictureThatIsHigherThanTheWindow) {
  const Terminal terminal(Screen::monochrome, {80, 5});
  WatchView view(OutputForm::people, terminal);
  FakeScreen screen(80, 5);
  for (int k = 0; k < 3; ++k)
    screen.write(view.shown("status", status_of({{"1", channel_of(1, k, nullptr)}})));
  ASSERT_EQ(screen.lines().size(), 4U);
  EXPECT_TRUE(screen.scrolled().empty());
  EXPECT_NE(screen.lines().back().find("more lines"), std::string::npos);
}

TEST(WatchOnATerminal, KeepsItsPlaceThroughRandomPictures) {
  const unsigned seed = 20260401;
  std::mt19937 random(seed);
  const auto up_to = [&](std::size_t n) { return random() % (n + 1); };
  for (int round = 0; round < 200; ++round) {
    const TerminalSize size{20 + up_to(100), 30 + up_to(30)};
    PictureInPlace picture(Terminal(Screen::coloured, size));
    FakeScreen screen(size.columns, size.lines);
    std::string text;
    for (int k = 0; k < 6; ++k) {
      text.clear();
      for (std::size_t lines = up_to(6); lines-- > 0;)
        text += std::string(up_to(2 * size.columns), 'x') + (up_to(1) == 0 ? " ä" : "") + "\n";
      screen.write(picture.drawn(text));
    }
    FakeScreen fresh(size.columns, size.lines);
    PictureInPlace alone(Terminal(Screen::coloured, size));
    fresh.write(alone.drawn(text));
    ASSERT_EQ(screen.lines(), fresh.lines()) << "seed " << seed << " round " << round;
  }
}

TEST(WatchOnATerminal, TakesNoOrdersFromATextOfAProgram) {
  const Terminal terminal(Screen::monochrome, {80, 24});
  WatchView view(OutputForm::people, terminal, OperatorView::overview);
  FakeScreen screen(80, 24);
  screen.write(view.shown("event", {{"text", "\033[2Ja\nb\tc\x7F\xC2\x9B"}}));
  EXPECT_EQ(screen.lines().front(), "cycle -  channel -  \uFFFD[2Ja b c\uFFFD\uFFFD");
}

TEST(ProgressLine, NeverLeavesItsLine) {
  EXPECT_EQ(progress_text("channel 1  Running", 80), "\r\033[Kchannel 1  Running");
  FakeScreen screen(20, 5);
  for (int k = 0; k < 3; ++k)
    screen.write(progress_text("channel 1  Running  impeller/blade.nc:" + std::to_string(k), 20));
  EXPECT_EQ(screen.lines(), std::vector<std::string>{"channel 1  Runni..."});
  EXPECT_EQ(screen.wraps(), 0);
}

TEST(ScreenText, CountsWideCharactersAndAccents) {
  EXPECT_EQ(screen_columns("Fräse"), 5U);
  EXPECT_EQ(screen_columns("旋盤"), 4U) << "two columns each";
  EXPECT_EQ(screen_columns("e\u0301"), 1U) << "an accent stands on the letter before";
  EXPECT_EQ(screen_columns("\033[1;31mred\033[0m"), 3U);
}

TEST(ScreenText, BreaksAtBlanksAndIndents) {
  EXPECT_EQ(broken_lines("one two three\nfour\n", 8),
            (std::vector<std::string>{"one two", "  three", "four"}));
  EXPECT_EQ(broken_lines("abcdefghij", 4), (std::vector<std::string>{"abcd", "efgh", "ij"}));
  EXPECT_EQ(broken_lines("\n\n", 4), (std::vector<std::string>{"", ""}));
}

TEST(ScreenText, CutsWithThreeDots) {
  EXPECT_EQ(cut_to_columns("abcdef", 6), "abcdef");
  EXPECT_EQ(cut_to_columns("abcdefg", 6), "abc...");
  EXPECT_EQ(cut_to_columns("旋盤旋盤", 6), "旋...");
}

}  // namespace
}  // namespace stanok::client

// What a cycle sees of what its preparation has made, live and in a replay; and announcements.
#include "channels/cycle/arrival_window.h"

#include <gtest/gtest.h>

#include "channels/cycle/announcements.h"
#include "tests/support/machine/cycle_bench.h"

namespace stanok::channels {
namespace {

Item item() {
  return {.content = lang::Dwell{}};
}

TEST(ArrivalWindowTest, ALiveCycleSeesAllThatHasCome) {
  ChannelLink link;
  ArrivalWindow window(link);
  ASSERT_TRUE(link.items.push(item()));
  ASSERT_TRUE(link.items.push(item()));
  EXPECT_EQ(link.items.size(), 2U);
  window.open(ArrivalWindow::all);
  EXPECT_EQ(window.arrivals().items, 2U);
}

TEST(ArrivalWindowTest, AReplayedCycleSeesWhatTheRecordedOneSaw) {
  ChannelLink link;
  ArrivalWindow window(link);
  const Arrivals recorded{.items = 1};
  EXPECT_FALSE(window.has_prepared(recorded));
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(link.items.push(item()));
  EXPECT_TRUE(window.has_prepared(recorded));
  window.open(recorded);
  EXPECT_EQ(link.items.size(), 1U);
  EXPECT_EQ(window.arrivals().items, 1U);
  window.open({.items = 3});
  EXPECT_EQ(link.items.size(), 3U);
}

TEST(ArrivalWindowTest, ARepeatedPreparationGoesAsFarAsTheRecordedOneIsKnown) {
  ChannelLink link;
  ArrivalWindow window(link);
  EXPECT_FALSE(window.may_prepare({}));
  EXPECT_TRUE(window.may_prepare({.items = 1}));
  EXPECT_TRUE(window.may_prepare({.resets = 1})) << "all before that reset is known";
  ASSERT_TRUE(link.items.push(item()));
  EXPECT_FALSE(window.may_prepare({.items = 1}));
  EXPECT_TRUE(window.may_prepare({.chunks = 1, .items = 1}));
}

TEST(ArrivalWindowTest, CountsAnewBehindAReset) {
  ChannelLink link;
  ArrivalWindow window(link);
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(link.items.push(item()));
  window.open(ArrivalWindow::all);
  link.items.pop_front(2);
  window.show_rest();
  window.begin_anew(link.items.popped());
  EXPECT_EQ(window.arrivals().resets, 1U);
  EXPECT_EQ(window.arrivals().items, 1U);
  EXPECT_TRUE(window.has_prepared({.resets = 1, .items = 1}));
  EXPECT_FALSE(window.has_prepared({.resets = 1, .items = 2}));
}

TEST(AnnouncementsTest, AreShownWhereThePathHasPassedTheirBlockOrIsOver) {
  stanok::testing::CycleBench bench;
  Announcements announcements(bench.link.remarks, bench.parts.log);
  ASSERT_TRUE(bench.link.remarks.push({{.run = 1, .block = 5}, SpokenText{{"W101"}, {"a word"}}}));
  ASSERT_TRUE(bench.link.remarks.push({{.run = 1, .block = 9}, SpokenText{{"W102"}, {"more"}}}));
  announcements.advance({.run = 1, .block = 5}, PathEnd::not_reached);
  EXPECT_EQ(bench.event(), "none");
  announcements.advance({.run = 1, .block = 6}, PathEnd::not_reached);
  EXPECT_EQ(bench.event(), "W101");
  EXPECT_EQ(bench.event(), "none");
  announcements.advance({.run = 1, .block = 6}, PathEnd::reached);
  EXPECT_EQ(bench.event(), "W102");
}

TEST(AnnouncementsTest, KeepTheLatestWorkpiece) {
  stanok::testing::CycleBench bench;
  Announcements announcements(bench.link.remarks, bench.parts.log);
  ASSERT_TRUE(bench.link.remarks.push({{}, BlankNews{}}));
  ASSERT_TRUE(bench.link.remarks.push({{}, lang::WorkpiecePosition{}}));
  announcements.advance({}, PathEnd::reached);
  EXPECT_EQ(announcements.workpiece().announcements, 2U);
  EXPECT_EQ(announcements.workpiece().shapes, 1U);
  EXPECT_TRUE(announcements.workpiece().has_shape);
  EXPECT_TRUE(announcements.workpiece().has_position);
}

}  // namespace
}  // namespace stanok::channels

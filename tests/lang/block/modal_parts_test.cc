// The parts of the modal state, each alone.
#include "lang/block/modal_parts.h"

#include <gtest/gtest.h>

namespace stanok::lang {
namespace {

FeedLaw law_of(FeedLaw::Kind kind) {
  FeedLaw law;
  law.kind = kind;
  law.feed_first = kind == FeedLaw::Kind::linear ? 60.0 : 0.0;
  return law;
}

TEST(ModalFeed, FWaitsBehindALawThatGivesTheFeed) {
  ModalFeed feed;
  feed.put_under(law_of(FeedLaw::Kind::linear));
  EXPECT_FALSE(feed.is_set()) << "there was no F";
  feed.put_under({});
  feed.known = true;
  feed.put_under(law_of(FeedLaw::Kind::linear));
  EXPECT_FALSE(feed.known);
  EXPECT_TRUE(feed.behind_law);
  EXPECT_TRUE(feed.is_set());
  feed.put_under({});
  EXPECT_TRUE(feed.known);
  EXPECT_FALSE(feed.behind_law);
}

TEST(ModalFeed, AnInterruptedFeedIsThatOfF) {
  ModalFeed feed;
  feed.known = true;
  feed.put_under(law_of(FeedLaw::Kind::interrupted));
  EXPECT_TRUE(feed.known);
  EXPECT_FALSE(feed.behind_law);
}

TEST(ModalSpindles, OneThatRunsIsEnough) {
  ModalSpindles spindles;
  spindles.start(0b101);
  EXPECT_TRUE(spindles.runs(0));
  EXPECT_FALSE(spindles.runs(1));
  spindles.stop(0b001);
  EXPECT_TRUE(spindles.any_runs);
  EXPECT_FALSE(spindles.runs(0));
  spindles.stop(0xFFFF);
  EXPECT_FALSE(spindles.any_runs);
}

// X, Y, Z are the axes 0, 1, 2. A quarter turn about Z at (10, 0): the origin comes to (10, -10).
TEST(FrameSettings, ShiftsAndTheRotationAboutItsCentreAddUp) {
  FrameSettings frames;
  frames.work_offset[0] = 100.0;
  frames.local_shift[1] = 5.0;
  frames.axis_shift[2] = 7.0;
  frames.rotation = {
      Rotation::about(vector3({0.0, 0.0, 1.0}), 90.0), {0.0, 0.0, 1.0}, 90.0, {10.0, 0.0, 0.0}};
  const GeometryAxes geometry{AxisIndex(0), AxisIndex(1), AxisIndex(2)};
  AxisValues origin = frames.frame(geometry).base_from_work({});
  EXPECT_NEAR(origin[0], 110.0, 1e-12);
  EXPECT_NEAR(origin[1], -5.0, 1e-12);
  EXPECT_NEAR(origin[2], 7.0, 1e-12);
  frames.axis_shift_active = false;
  origin = frames.frame(geometry).base_from_work({});
  EXPECT_NEAR(origin[2], 0.0, 1e-12);
}

}  // namespace
}  // namespace stanok::lang

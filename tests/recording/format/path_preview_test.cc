// Previews of paths: their shape, and their way over the bus in parts.
#include "recording/format/path_preview.h"

#include <gtest/gtest.h>

#include <cmath>
#include <lcm/lcm-cpp.hpp>

#include "recording/stream/lcm_publisher.h"
#include "tests/recording/recorded_log.h"

namespace stanok::recording {
namespace {

const std::vector<std::string> words{"Z", "X", "Y"};

channels::ChannelOutput at(double x, double y, double z, double feed) {
  channels::ChannelOutput output;
  output.running = true;
  output.run = 1;
  output.feed_commanded = feed;
  output.point_W[0].value = z;
  output.point_W[1].value = x;
  output.point_W[2].value = y;
  return output;
}

TEST(PathPreview, KnowsFeedFromRapidTraverseAndWhereNoLineLeads) {
  PreviewWriter writer(words);
  for (int k = 0; k <= 10; ++k) writer.add(at(k, 0.0, 50.0, 0.0));
  for (int k = 0; k <= 10; ++k) writer.add(at(10.0, k, 50.0, 20.0));
  const auto points = writer.take();
  std::vector<PlotPoint> feed;
  std::vector<PlotPoint> rapid;
  int begins = 0;
  for (const PreviewPoint& one : points) {
    (one.rapid ? rapid : feed).push_back(one.point);
    begins += one.begins ? 1 : 0;
  }
  EXPECT_EQ(begins, 2) << "one line at feed, one in rapid traverse";
  EXPECT_EQ(rapid, (std::vector<PlotPoint>{{0.0, 0.0, 50.0}, {10.0, 0.0, 50.0}}));
  EXPECT_EQ(feed, (std::vector<PlotPoint>{{10.0, 0.0, 50.0}, {10.0, 10.0, 50.0}}));
}

TEST(PathPreview, StaysWithinAHundredthOfAMillimetre) {
  PreviewWriter writer(words);
  for (int k = 0; k <= 36'000; ++k) {
    const double angle = k * 3.14159265358979 / 18'000.0;
    writer.add(at(20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0, 20.0));
  }
  const auto points = writer.take();
  EXPECT_LT(points.size(), 200U);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double x = 0.5 * (points[k].point[0] + points[k - 1].point[0]);
    const double y = 0.5 * (points[k].point[1] + points[k - 1].point[1]);
    EXPECT_LE(20.0 - std::hypot(x, y), 0.01 + 1e-9);
  }
  EXPECT_EQ(points.back().point[0], 20.0);
}

TEST(PathPreview, KeepsAPathThatTurnsBack) {
  PreviewWriter writer(words);
  for (const double x : {0.0, 5.0, 10.0, 5.0, 0.0, -5.0}) writer.add(at(x, 0.0, 0.0, 20.0));
  std::vector<double> xs;
  for (const PreviewPoint& one : writer.take()) xs.push_back(one.point[0]);
  EXPECT_EQ(xs, (std::vector<double>{0.0, 10.0, -5.0}));
}

TEST(PathPreview, LeavesALineOutBetweenRuns) {
  PreviewWriter writer(words);
  for (int run = 1; run <= 3; ++run) {
    for (int k = 0; k <= 5; ++k) {
      auto output = at(100.0 * run + k, 0.0, 0.0, 20.0);
      output.run = static_cast<std::uint32_t>(run);
      writer.add(output);
    }
  }
  const auto points = writer.take();
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (!points[k].begins) {
      EXPECT_LE(points[k].point[0] - points[k - 1].point[0], 5.0);
    }
  }
}

TEST(PathPreview, IsBoundedHoweverLongTheProgram) {
  PreviewWriter writer(words);
  for (int k = 0; k < 300'000; ++k)
    writer.add(at(50.0 * std::cos(0.01 * k), 50.0 * std::sin(0.01 * k), 0.001 * k, 20.0));
  const auto points = writer.take();
  EXPECT_LE(points.size(), ThinnedPath::points_max);
  EXPECT_GT(points.size(), 1000U);
  for (const PreviewPoint& one : points)
    EXPECT_NEAR(std::hypot(one.point[0], one.point[1]), 50.0, 1e-9);
}

class PathOnTheBus : public ::testing::Test {
 protected:
  PathOnTheBus() { publisher.bus()->subscribeFunction("STANOK_MILL_CH1_PATH", &keep, &messages); }
  static void keep(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                   const path_t* message, std::vector<path_t>* messages) {
    messages->push_back(*message);
  }
  void run(int from, int to) {
    for (int cycle = from; cycle < to; ++cycle) stream.cycle(output_of(cycle));
    while (publisher.bus()->handleTimeout(0) > 0) {
    }
  }
  static PathPreview line(int count) {
    PathPreview preview{1, "part.nc", {}};
    for (int k = 0; k < count; ++k)
      preview.points.push_back({{1.0 * k, 0.0, 0.0}, k == 0, k > 100});
    return preview;
  }

  LcmPublisher publisher{"memq://"};
  MessageStream stream{small_machine(), {&publisher}};
  std::vector<path_t> messages;
};

TEST_F(PathOnTheBus, ComesInPartsThatMakeTheWhole) {
  run(0, 10);
  EXPECT_TRUE(messages.empty());
  stream.path(line(150));
  run(10, 200);
  ASSERT_EQ(messages.size(), 3U);
  int next = 0;
  for (const path_t& message : messages) {
    EXPECT_EQ(message.channel, 1);
    EXPECT_EQ(message.preview, 1);
    EXPECT_EQ(message.total, 150);
    EXPECT_EQ(message.first, next);
    EXPECT_STREQ(reinterpret_cast<const char*>(message.program), "part.nc");
    for (int k = 0; k < message.count; ++k, ++next) {
      EXPECT_EQ(message.point[k][0], next);
      EXPECT_EQ(message.joint[k], next == 0 ? 1 : next > 100 ? 2 : 0);
    }
  }
  EXPECT_EQ(next, 150);
}

TEST_F(PathOnTheBus, ComesAgainEveryMinuteUntilThereIsAnother) {
  stream.path(line(10));
  run(0, 60'100);
  EXPECT_EQ(messages.size(), 2U);
  stream.path(line(70));
  run(60'100, 60'300);
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages.back().preview, 2);
  EXPECT_EQ(messages.back().first + messages.back().count, 70);
}

}  // namespace
}  // namespace stanok::recording

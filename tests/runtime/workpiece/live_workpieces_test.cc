// A workpiece that is followed cycle by cycle and shown by pages while it is cut.
#include "runtime/workpiece/live_workpieces.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "recording/format/log_description.h"
#include "tests/support/stl_text.h"
#include "tests/support/temporary_directory.h"

namespace stanok::runtime {
namespace {

constexpr double radius = 4.0;
constexpr double depth = 5.0;

// Three axes, no turn: the tool is where the axes are.
channels::MachineConfig three_axes() {
  channels::MachineConfig machine;
  machine.cycle_us = 1000;
  machine.axes.resize(3);
  for (std::size_t k = 0; k < 3; ++k) machine.axes[k].name = std::string(1, "XYZ"[k]);
  channels::ChannelConfig channel;
  channel.id = 1;
  channel.axes = {0, 1, 2};
  channel.words = {"X", "Y", "Z"};
  kinematics::SchemeConfig scheme;
  scheme.id = 1;
  scheme.type = "cartesian";
  scheme.axes = {0, 1, 2};
  scheme.linear = {0, 1, 2};
  channel.schemes = {scheme};
  machine.channels = {channel};
  return machine;
}

class LiveWorkpiecesTest : public ::testing::Test {
 protected:
  LiveWorkpiecesTest() {
    output.channel_count = 1;
    channel().id = 1;
    channel().axis_count = 3;
    channel().scheme = 1;
    channel().tool = {5, 1};
    channel().tool_row.number = 5;
    channel().tool_row.kind = FixedText<16>("flat");
    channel().tool_row.radius = radius;
    channel().tool_row.flute_length = 30.0;
    channel().tool_row.overhang = 40.0;
    channel().process.spindles[0] = {1, 3000.0};
    channel().moving = true;
    channel().feed_commanded = 10.0;
  }
  channels::ChannelOutput& channel() { return output.channels[0]; }

  // A block of 60 x 40 x 20 mm, its top at program zero.
  void announce(double resolution) {
    channels::Workpiece& workpiece = channel().workpiece;
    ++workpiece.announcements;
    ++workpiece.shapes;
    workpiece.has_shape = true;
    workpiece.shape.type = 0;
    workpiece.shape.size_mm = {60.0, 40.0, 20.0};
    workpiece.shape.zero_mm = {0.0, 0.0, 20.0};
    workpiece.shape.screen_resolution_mm = resolution;
  }
  void cycle_at(double x, double y, double z) {
    ++output.cycle;
    channel().axes[0].position = x;
    channel().axes[1].position = y;
    channel().axes[2].position = z;
    live.observe(output);
  }
  // Along X, a tenth of a millimetre a cycle.
  void move_along_x(double from, double to, double y, double z) {
    for (double x = from; x <= to; x += 0.1) cycle_at(x, y, z);
  }

  // Asks until the thread has cut all; the pages of one answer, by brick.
  SurfacePage page(const SurfaceRequest& request) {
    auto page = live.page(1, request);
    return page ? *page : SurfacePage{};
  }
  std::map<std::size_t, std::vector<SurfacePage::Corner>> shown;
  std::uint32_t version = 0;
  std::uint32_t workpiece = 0;
  std::size_t bricks_told = 0;

  void look() {
    std::optional<std::size_t> from = 0;
    std::optional<std::uint32_t> first_version;
    while (from) {
      const SurfacePage told = page({.workpiece = workpiece, .since = version, .from = *from});
      if (told.workpiece != workpiece) {
        shown.clear();
        version = 0;
      }
      workpiece = told.workpiece;
      if (!first_version) first_version = told.version;
      for (const auto& brick : told.bricks) {
        const auto* corners = told.corners.data();
        shown[brick.number] = {corners + brick.first, corners + brick.behind};
        ++bricks_told;
      }
      from = told.next;
    }
    version = *first_version;
  }
  [[nodiscard]] double volume() const {
    double sum = 0.0;
    for (const auto& [brick, corners] : shown) {
      for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
        std::array<Eigen::Vector3d, 3> at;
        for (std::size_t c = 0; c < 3; ++c)
          at[c] = Eigen::Vector3f(corners[k + c].place_mm.data()).cast<double>();
        sum += at[0].dot(at[1].cross(at[2])) / 6.0;
      }
    }
    return sum;
  }
  // Looks again until there is nothing left to be cut.
  void look_until(double wanted, double tolerance) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(3);
    while (std::abs(volume() - wanted) > tolerance && std::chrono::steady_clock::now() < patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      look();
    }
    EXPECT_NEAR(volume(), wanted, tolerance);
  }

  // The last of the way of a tool may still have been on its way to the thread.
  void look_until_nothing_is_new() {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(3);
    do {
      bricks_told = 0;
      look();
    } while (bricks_told > 0 && std::chrono::steady_clock::now() < patience);
    EXPECT_EQ(bricks_told, 0U) << "nothing has changed since";
  }

  channels::CycleOutput output;
  std::vector<std::string> complaints;
  LiveWorkpieces live{three_axes(),
                      [this](const std::string& line) { complaints.push_back(line); }};
};

constexpr double block_mm3 = 60.0 * 40.0 * 20.0;
// A slot through the block along X, of the width of the tool.
constexpr double slot_mm3 = 60.0 * 2.0 * radius * depth;
// Sharp edges of a block are bevelled by part of a cell: (60 + 40 + 20) * 4 edges of 0.5 mm^2 / 8.
constexpr double rounding_mm3 = 60.0;

TEST_F(LiveWorkpiecesTest, NothingIsShownBeforeABlankIsAnnounced) {
  cycle_at(0, 0, 10);
  EXPECT_FALSE(live.page(1, {}));
  EXPECT_FALSE(live.page(2, {}));
}

TEST_F(LiveWorkpiecesTest, ShowsABlankWhatIsCutOfItAndByWhichTool) {
  announce(0.5);
  cycle_at(-10, 20, 10);
  look_until(block_mm3, rounding_mm3);
  const std::size_t all_bricks = bricks_told;
  bricks_told = 0;
  cycle_at(-10, 20, -depth);
  move_along_x(-10, 70, 20, -depth);
  look_until(block_mm3 - slot_mm3, 2 * rounding_mm3);
  bool is_of_tool = false;
  for (const auto& [brick, corners] : shown) {
    for (const auto& corner : corners) {
      const auto& [x, y, z] = corner.place_mm;
      const bool is_floor = std::abs(z + depth) < 1e-3 && std::abs(y - 20) < 3 && x > 1 && x < 59;
      if (is_floor) {
        EXPECT_EQ(corner.tool, 5) << x << ' ' << y;
      }
      is_of_tool = is_of_tool || is_floor;
    }
  }
  EXPECT_TRUE(is_of_tool);
  EXPECT_GT(all_bricks, 4U);
  look_until_nothing_is_new();
  EXPECT_TRUE(complaints.empty());
}

TEST_F(LiveWorkpiecesTest, AnotherBlankTakesThePlaceOfTheFirst) {
  announce(1.0);
  cycle_at(-10, 20, -depth);
  move_along_x(-10, 70, 20, -depth);
  look_until(block_mm3 - slot_mm3, 4 * rounding_mm3);
  const std::uint32_t first = workpiece;
  announce(1.0);
  cycle_at(-10, 20, 30);
  look_until(block_mm3, 4 * rounding_mm3);
  EXPECT_GT(workpiece, first);
}

// A regular prism of 64 corners, cut through by the tool: the slot of 8 mm over the circle of 20 mm
// has the area 2 (y sqrt(r² - y²) + r² asin (y / r)), y = 4, up to what the prism lacks of it.
TEST_F(LiveWorkpiecesTest, CutsTheSolidOfAnStlFile) {
  namespace st = stanok::testing;
  constexpr int corners = 64;
  const st::TemporaryDirectory folder;
  const std::string bytes = st::binary_stl(st::stl_cylinder(20.0, -20.0, 0.0, corners));
  const std::string path = (folder.path() / "round.stl").string();
  std::ofstream(path, std::ios::binary) << bytes;
  announce(0.5);
  channels::Workpiece& announced = channel().workpiece;
  announced.shape.type = 2;
  announced.shape.size_mm = {40.0, 40.0, 20.0};
  announced.shape.zero_mm = {0.0, 0.0, 0.0};
  announced.shape.fingerprint = recording::text_hash(bytes);
  announced.file = std::string_view(path);
  cycle_at(-40, 0, 10);
  const double blank_mm3 = st::regular_polygon_area(20.0, corners) * 20.0;
  look_until(blank_mm3, 4 * rounding_mm3);
  cycle_at(-40, 0, -depth);
  move_along_x(-40, 40, 0, -depth);
  const double area = 2.0 * (4.0 * std::sqrt(400.0 - 16.0) + 400.0 * std::asin(0.2));
  look_until(blank_mm3 - depth * area, 4 * rounding_mm3);
  EXPECT_TRUE(complaints.empty());
}

TEST_F(LiveWorkpiecesTest, TellsThatAnStlFileIsGone) {
  announce(0.5);
  channel().workpiece.shape.type = 2;
  channel().workpiece.file = std::string_view("/nowhere/round.stl");
  cycle_at(-40, 0, 10);
  const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  while (live.page(1, {}) && std::chrono::steady_clock::now() < patience) {
  }
  EXPECT_FALSE(live.page(1, {}));
}

// 60 x 40 x 20 mm at a thousandth of a millimetre would take thousands of gigabytes.
TEST_F(LiveWorkpiecesTest, IsAsFineAsItsMemoryAllows) {
  announce(0.001);
  cycle_at(-10, 20, 10);
  const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  std::optional<SurfacePage> page;
  while (!page && std::chrono::steady_clock::now() < patience) page = live.page(1, {});
  ASSERT_TRUE(page);
  EXPECT_GT(page->blank.resolution, 0.01);
  EXPECT_LT(page->blank.resolution, 0.2);
  EXPECT_TRUE(complaints.empty());
}

// More cycles than there is room for, at once: the machine is not held up, and the tool goes
// straight over those that were left out.
TEST_F(LiveWorkpiecesTest, NeverHoldsUpWhoFeedsIt) {
  announce(0.5);
  cycle_at(-10, 20, -depth);
  for (int pass = 0; pass < 10; ++pass) {
    for (double x = -10; x <= 70; x += 0.02) cycle_at(x, 20, -depth);
  }
  look_until(block_mm3 - slot_mm3, 2 * rounding_mm3);
}

}  // namespace
}  // namespace stanok::runtime

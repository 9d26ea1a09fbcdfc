// Copies of the tables that follow their writes: at every version all values are those of that
// version, also when the reader was too far behind and copies them anew, beside the cycle.
#include "channels/stores/table_view.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

constexpr int axis_x = 0;
constexpr int axis_y = 1;

class TableViewTest : public ::testing::Test {
 protected:
  // Of the writes 1, 2, 3...: X, Y, X, Y... of G54, the numbers 1, 1, 2, 2...
  void write_pairs(int pairs) {
    for (int n = 0; n < pairs; ++n) {
      ++written_;
      EXPECT_TRUE(live.set_offset(1, axis_x, written_));
      EXPECT_TRUE(live.set_offset(1, axis_y, written_));
    }
  }
  static void expect_values_of(const TableView& view) {
    const auto version = static_cast<double>(view.version());
    ASSERT_EQ(view.offset(1, axis_x), std::floor((version + 1.0) / 2.0));
    ASSERT_EQ(view.offset(1, axis_y), std::floor(version / 2.0));
  }

  MachineConfig machine = stanok::testing::two_channel_machine();
  LiveTables live{machine};

 private:
  int written_ = 0;
};

TEST_F(TableViewTest, StaysAtItsWriteUntilItIsBroughtUp) {
  TableView view(live);
  write_pairs(2);
  EXPECT_EQ(view.version(), 0U);
  EXPECT_EQ(view.offset(1, axis_x), 0.0);
  for (std::uint64_t version = 1; version <= 4; ++version) {
    view.advance_to(version);
    EXPECT_EQ(view.version(), version);
    expect_values_of(view);
  }
  view.advance_to(2);
  EXPECT_EQ(view.version(), 4U) << "it does not go back";
}

TEST_F(TableViewTest, ReadsToolsAndOffsetsAsTheTablesDo) {
  ASSERT_TRUE(live.set_tool_value(4, 1, 1, 77.0, Writer::person));
  ASSERT_TRUE(live.set_tool_value(4, 1, 5, -0.25, Writer::person));
  ASSERT_TRUE(live.set_offset(7, axis_y, 3.0));
  TableView view(live);
  EXPECT_EQ(view.tool(4, 1)->length, 77.0);
  EXPECT_EQ(view.tool(4, 1)->wear_length, -0.25);
  EXPECT_EQ(view.tool_value(4, 1, 1), 77.0);
  EXPECT_EQ(view.offset(7, machine.axes[axis_y].name), 3.0);
  EXPECT_EQ(view.offset(7, "no axis"), 0.0);
  EXPECT_FALSE(view.offset(0, axis_x));
  EXPECT_FALSE(view.offset(310, "no axis"));
  EXPECT_FALSE(view.tool(4000, 1));
  EXPECT_FALSE(view.tool_value(4, 1, 0));
  EXPECT_FALSE(view.tool_value(4, 1, 12));
  const TablesConfig rows = view.rows();
  ASSERT_EQ(rows.offsets.size(), 1U);
  EXPECT_EQ(rows.offsets.at("G59.1").at(machine.axes[axis_y].name), 3.0);
}

// Farther than writes are kept.
TEST_F(TableViewTest, IsWholeAlsoFromFarBehind) {
  TableView view(live);
  write_pairs(TableWrites::kept);
  view.advance_to(3);
  EXPECT_EQ(view.version(), 2U * TableWrites::kept);
  expect_values_of(view);
}

TEST_F(TableViewTest, IsWholeBesideTheCycle) {
  TableView view(live);
  std::jthread cycle([this] { write_pairs(100'000); });
  std::mt19937 random(3);
  while (view.version() < 200'000U) {
    const std::uint64_t newest = live.version();
    const std::uint64_t behind = newest - view.version();
    view.advance_to(view.version() + (behind == 0 ? 0 : 1 + random() % behind));
    expect_values_of(view);
  }
}

}  // namespace
}  // namespace stanok::channels

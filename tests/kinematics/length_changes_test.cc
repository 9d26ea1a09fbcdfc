// What was read behind a write knows it; what was read before is corrected by it.
#include "kinematics/length_changes.h"

#include <gtest/gtest.h>

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

class LengthChangesTest : public ::testing::Test {
 protected:
  void change(int tool, int edge, double by_z, std::uint64_t version) {
    changes.note({.tool = tool, .edge = edge, .by_mm = {0.0, 0.0, by_z}, .version = version});
  }
  [[nodiscard]] double since(const ToolRow& row) const { return changes.since(row).z(); }

  LengthChanges changes;
};

TEST_F(LengthChangesTest, CountForWhatWasReadBefore) {
  change(4, 1, 2.0, 7);
  change(4, 1, -0.5, 9);
  EXPECT_EQ(since({.tool = 4, .edge = 1, .sign = 1, .version = 6}), 1.5);
  EXPECT_EQ(since({.tool = 4, .edge = 1, .sign = 1, .version = 7}), -0.5);
  EXPECT_EQ(since({.tool = 4, .edge = 1, .sign = 1, .version = 9}), 0.0);
  EXPECT_TRUE(changes.concern({.tool = 4, .edge = 1, .sign = 1, .version = 8}));
  EXPECT_FALSE(changes.concern({.tool = 4, .edge = 1, .sign = 1, .version = 9}));
}

TEST_F(LengthChangesTest, CountAsTheRowDoes) {
  change(4, 1, 2.0, 7);
  EXPECT_EQ(since({.tool = 4, .edge = 1, .sign = -1, .version = 0}), -2.0);  // G44
  EXPECT_EQ(since({.tool = 4, .edge = 1, .sign = 0, .version = 0}), 0.0);    // G43.1
  EXPECT_EQ(since({.tool = 4, .edge = 2, .sign = 1, .version = 0}), 0.0);
  EXPECT_EQ(since({.tool = 5, .edge = 1, .sign = 1, .version = 0}), 0.0);
}

TEST_F(LengthChangesTest, LengthenTheToolOfATransform) {
  Transform transform;
  transform.tool.nose_to_tip_mm = {0.0, 0.0, -50.0};
  transform.row = {.tool = 4, .edge = 1, .sign = 1, .version = 3};
  change(4, 1, 2.5, 4);
  EXPECT_EQ(with_changes(transform, changes).tool.nose_to_tip_mm.z(), -52.5);
  changes.forget();
  EXPECT_EQ(with_changes(transform, changes).tool.nose_to_tip_mm.z(), -50.0);
}

TEST_F(LengthChangesTest, HaveAnEnd) {
  std::uint64_t version = 0;
  while (!changes.is_full()) change(1, 1, 0.125, ++version);
  EXPECT_EQ(since({.tool = 1, .edge = 1, .sign = 1}), 0.125 * static_cast<double>(version));
  EXPECT_EQ(version, 64U);
}

}  // namespace
}  // namespace stanok::kinematics

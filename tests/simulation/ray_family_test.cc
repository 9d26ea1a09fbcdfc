// Material on rays against a plain array of small cells.
#include "simulation/ray_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace stanok::simulation {
namespace {

// Positions are whole hundredths, so that both count the same cells.
class Cells {
 public:
  void set(int from, int to, bool material) {
    for (int i = std::max(from, 0); i < std::min(to, 1000); ++i)
      cells_[static_cast<std::size_t>(i)] = material;
  }
  [[nodiscard]] int count(int from, int to) const {
    return static_cast<int>(
        std::count(cells_.begin() + std::max(from, 0), cells_.begin() + std::min(to, 1000), true));
  }

 private:
  std::vector<bool> cells_ = std::vector<bool>(1000, false);
};

TEST(RayFamily, HoldsWhatAnArrayOfCellsHolds) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> position(0, 1000);
    RayFamily family(3);
    Cells cells;
    family.add(1, 0.0, 10.0);
    cells.set(0, 1000, true);
    for (int cut = 0; cut < 30; ++cut) {
      const int one = position(random);
      const int other = one + position(random) / 10 + 1;
      const int before = cells.count(one, other);
      EXPECT_NEAR(family.overlap(1, one * 0.01, other * 0.01), before * 0.01, 1e-4) << seed;
      EXPECT_NEAR(family.subtract(1, one * 0.01, other * 0.01), before * 0.01, 1e-4) << seed;
      cells.set(one, other, false);
      EXPECT_EQ(family.overlap(1, one * 0.01, other * 0.01), 0.0) << seed;
    }
    EXPECT_NEAR(family.length(), cells.count(0, 1000) * 0.01, 1e-3) << seed;
    for (int i = 0; i < 1000; i += 7)
      EXPECT_EQ(family.contains(1, i * 0.01 + 0.005), cells.count(i, i + 1) == 1) << seed;
  }
}

TEST(RayFamily, ForgetsNothingOfOtherRays) {
  RayFamily family(2);
  family.add(0, 0.0, 1.0);
  family.add(0, 2.0, 3.0);
  family.add(1, 0.0, 5.0);
  EXPECT_DOUBLE_EQ(family.subtract(1, 1.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(family.subtract(1, 0.0, 5.0), 4.0);
  EXPECT_DOUBLE_EQ(family.length(), 2.0);
  EXPECT_FALSE(family.may_meet(1, 0.0F, 5.0F));
}

}  // namespace
}  // namespace stanok::simulation

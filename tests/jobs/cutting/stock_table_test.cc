#include "jobs/cutting/stock_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

TEST(StockTable, OfATextHasRadiusAndHardnessByPlace) {
  const auto stock = stock_of_text("0:32:200,-20:33:260");
  ASSERT_TRUE(stock.has_value());
  EXPECT_EQ(stock->radius_mm(1.0), 0.0);
  EXPECT_EQ(stock->radius_mm(-19.0), 32.0);
  EXPECT_EQ(stock->radius_mm(-21.0), 33.0);
  EXPECT_EQ(stock->force_factor(-19.0), 1.0);
  EXPECT_DOUBLE_EQ(stock->force_factor(-21.0), std::pow(260.0 / 200.0, 0.75));
}

TEST(StockTable, WithoutHardnessTheForceIsTheSame) {
  const auto stock = stock_of_text("0:32,-20:33");
  ASSERT_TRUE(stock.has_value());
  EXPECT_EQ(stock->force_factor(-30.0), 1.0);
}

TEST(StockTable, RefusesWhatIsNoStock) {
  for (const char* const text :
       {"", "0", "0:", "0:32,", "0:32,0:33", "0:32,5:33", "0:-1", "0:32:200,-20:33", "0:32:-5",
        "0:32:200:1", "a:32", "0:nan", "0:32x"})
    EXPECT_FALSE(stock_of_text(text).has_value()) << text;
}

TEST(StockTable, OfAFileHasOneStepInEachLine) {
  const stanok::testing::TemporaryDirectory folder;
  const auto file = folder.path() / "stock.csv";
  std::ofstream(file) << "z,radius,hardness\n# the face\n0, 32, 200\n-20,33,260\r\n";
  const StockTable stock = read_stock_table(file);
  ASSERT_EQ(stock.steps.size(), 2u);
  EXPECT_EQ(stock.steps[1].z_mm, -20.0);
  EXPECT_EQ(stock.steps[1].radius_mm, 33.0);
  EXPECT_EQ(stock.steps[1].hardness_hb, 260.0);
  std::ofstream(file) << "0,32,200\n5,33,260\n";
  try {
    static_cast<void>(read_stock_table(file));
    FAIL() << "z rises";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("stock.csv:2:"), std::string::npos) << error.what();
  }
}

TEST(StockTable, OfAMachineFileIsItsSimulatedBar) {
  const StockTable stock = read_stock_table(
      std::filesystem::path(stanok::testing::source_folder()) / "config/machines/lathe.toml");
  EXPECT_EQ(stock.radius_mm(-30.0), 33.0);
  EXPECT_EQ(stock.force_factor(-10.0), 1.0);
  EXPECT_DOUBLE_EQ(stock.force_factor(-70.0), std::pow(260.0 / 200.0, 0.75));
}

}  // namespace
}  // namespace stanok::jobs

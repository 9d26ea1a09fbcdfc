// Files of sensor values: what they mean, and what is said about wrong ones.
#include "runtime/simulation_files/sensor_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace stanok::runtime {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class SensorFile : public ::testing::Test {
 protected:
  SensorFile() : spindles_(2) {
    spindles_[0].id = 1;
    spindles_[1].id = 4;
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            (std::string("stanok_sensors_") + test->name() + ".csv");
  }
  ~SensorFile() override { std::filesystem::remove(path_); }

  std::vector<SensorRow> read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_sensor_file(path_.string(), spindles_);
  }
  std::string refusal(const std::string& text) {
    try {
      static_cast<void>(read(text));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }

  std::vector<channels::SpindleConfig> spindles_;
  std::filesystem::path path_;
};

TEST_F(SensorFile, ValuesBelongToSpindlesAndTimes) {
  const auto rows = read(
      "# cutting test\n t, power_w ,vibration_um.4,vibration_hz.4\r\n0,1200,,\n0.5,1250.5,7,180\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].t, 0.0);
  EXPECT_EQ(rows[0].spindles[0].power_w, 1200.0);
  EXPECT_TRUE(std::isnan(rows[0].spindles[1].vibration_um));
  EXPECT_EQ(rows[1].t, 0.5);
  EXPECT_EQ(rows[1].spindles[0].power_w, 1250.5);
  EXPECT_EQ(rows[1].spindles[1].vibration_um, 7.0);
  EXPECT_EQ(rows[1].spindles[1].vibration_hz, 180.0);
  EXPECT_TRUE(std::isnan(rows[1].spindles[1].power_w));
}

TEST_F(SensorFile, SaysWhereAndWhyItIsWrong) {
  EXPECT_THAT(refusal("power_w,t\n"), HasSubstr(":1:1: the first column must be t"));
  EXPECT_THAT(refusal("t,force\n"), HasSubstr(":1:3: 'force' is no sensor"));
  EXPECT_THAT(refusal("t,power_w.2\n"), HasSubstr(":1:3: the machine has no spindle 2"));
  EXPECT_THAT(refusal("t,power_w\n0,1\n1,2,3\n"), HasSubstr(":3:5: 3 values under 2 columns"));
  EXPECT_THAT(refusal("t,power_w\n0,1\n1, 2x\n"), HasSubstr(":3:4: '2x' is not a number"));
  EXPECT_THAT(refusal("t,power_w\n0,nan\n"), HasSubstr(":2:3: 'nan' is not a number"));
  EXPECT_THAT(refusal("t,power_w\n1,1\n0.5,1\n"), HasSubstr(":3:1: t goes back"));
  EXPECT_THAT(refusal(""), HasSubstr(":1:1: the head line is missing"));
  spindles_.clear();
  EXPECT_THAT(refusal("t,power_w\n"), EndsWith("the machine has no spindle"));
}

TEST_F(SensorFile, MustBeReadable) {
  EXPECT_THROW(static_cast<void>(read_sensor_file("/no/such/file.csv", spindles_)),
               std::runtime_error);
}

}  // namespace
}  // namespace stanok::runtime

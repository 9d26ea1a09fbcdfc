// The measurement report: lines of programs as CSV and JSON lines, in files of bounded size.
#include "recording/log/measurement_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <vector>

#include "tests/support/temporary_directory.h"

namespace stanok::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

channels::Event told(const std::string& text) {
  channels::Event event;
  event.cycle = 1234;
  event.channel = 2;
  event.text = FixedText<240>(text);
  return event;
}

TEST(MeasurementFiles, WritesEachMeasurementIntoBothFiles) {
  const testing::TemporaryDirectory folder;
  MeasurementFiles files(folder.path() / "log", "m");
  files.take(told("measured bore x=1.25 y=-2 size=12.0031 error_size=0.0031"), 5'000'000);
  files.take(told("measured ring size=24 depth_2=0.5"), 6'000'000);
  EXPECT_EQ(files.error(), "");
  EXPECT_THAT(
      lines_of(folder.path() / "log" / "m.csv"),
      ElementsAre("utime,cycle,channel,feature,x,y,z,size,angle,error_x,error_y,error_z,error_"
                  "size,error_angle",
                  "5000000,1234,2,bore,1.25,-2,,12.0031,,,,,0.0031,",
                  "6000000,1234,2,ring,,,,24,,,,,,"));
  EXPECT_THAT(lines_of(folder.path() / "log" / "m.jsonl"),
              ElementsAre("{\"utime\":5000000,\"cycle\":1234,\"channel\":2,\"feature\":"
                          "\"bore\",\"error_size\":0.0031,\"size\":12.0031,\"x\":1.25,\"y\":-2}",
                          "{\"utime\":6000000,\"cycle\":1234,\"channel\":2,\"feature\":"
                          "\"ring\",\"depth_2\":0.5,\"size\":24}"));
}

TEST(MeasurementFiles, LeaveOtherTextsAlone) {
  const testing::TemporaryDirectory folder;
  MeasurementFiles files(folder.path() / "log", "m");
  for (const char* const text :
       {"", "measured", "measured ", "a bore was measured x=1", "measured bo\"re x=1",
        "measured bore x=one", "measured bore x=1;", "measured bore x", "measured bore x=inf",
        "measured bore =1", "Measured bore x=1"}) {
    EXPECT_FALSE(measurement_of(text)) << text;
    files.take(told(text), 0);
  }
  channels::Event warning = told("measured bore x=1");
  warning.code = FixedText<8>("W0001");
  files.take(warning, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "log"));
  EXPECT_TRUE(measurement_of("measured bore"));
}

TEST(MeasurementFiles, AFullFileMakesRoomForTheNext) {
  const testing::TemporaryDirectory folder;
  constexpr std::int64_t size_max = 2000;
  MeasurementFiles files(folder.path(), "m", size_max);
  for (int n = 0; n < 200; ++n) files.take(told("measured web size=" + std::to_string(n)), n);
  for (const char* const name : {"m.csv", "m.1.csv", "m.jsonl", "m.1.jsonl"}) {
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(folder.path() / name));
    EXPECT_LE(size, size_max) << name;
    EXPECT_GT(size, 0) << name;
  }
  EXPECT_THAT(lines_of(folder.path() / "m.csv").front(), HasSubstr("utime,cycle"));
  EXPECT_THAT(lines_of(folder.path() / "m.csv").back(), HasSubstr("web,,,,199,"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 4);
}

// A file that cannot be put aside grows no further.
TEST(MeasurementFiles, StopAtTheirSize) {
  const testing::TemporaryDirectory folder;
  constexpr std::int64_t size_max = 200;
  std::filesystem::create_directories(folder.path() / "m.1.csv" / "in_the_way");
  MeasurementFiles files(folder.path(), "m", size_max);
  for (int n = 0; n < 20; ++n) files.take(told("measured web size=" + std::to_string(n)), n);
  EXPECT_THAT(files.error(), HasSubstr("m.csv cannot be put aside"));
  EXPECT_LE(static_cast<std::int64_t>(std::filesystem::file_size(folder.path() / "m.csv")),
            size_max);
}

TEST(MeasurementFiles, TellWhyNothingIsWritten) {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "log") << "no folder";
  MeasurementFiles files(folder.path() / "log", "m");
  files.take(told("measured bore x=1"), 0);
  EXPECT_THAT(files.error(), HasSubstr("cannot be written"));
  std::filesystem::remove(folder.path() / "log");
  files.take(told("measured bore x=1"), 0);
  EXPECT_EQ(files.error(), "");
  EXPECT_THAT(lines_of(folder.path() / "log" / "m.jsonl"), SizeIs(1));
}

}  // namespace
}  // namespace stanok::recording

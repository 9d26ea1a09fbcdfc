#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "programs/generators/car_body.h"
#include "programs/generators/curve_split.h"
#include "programs/generators/impeller_blade.h"
#include "programs/generators/path_files.h"

namespace stanok::programs {
namespace {

struct Extent {
  double min = 1e300;
  double max = -1e300;
  void add(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
  [[nodiscard]] double size() const { return max - min; }
};

// What a reader of the text alone finds; knows only words with plain numbers.
struct TextReading {
  long blocks = 0;
  long feed_blocks = 0;
  std::array<Extent, coordinate_count> cut;  // ends of feed motions
  double chord_time_s = 0.0;                 // chords over feed, arcs as chords
};

TextReading read_program(const std::string& text) {
  TextReading reading;
  std::map<char, double> word;
  std::istringstream lines(text);
  double motion = 0.0;
  Point last{};
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '%' || line[0] == '(') continue;
    ++reading.blocks;
    const char* at = line.c_str();
    bool moves = false;
    while (*at != '\0') {
      const char address = *at++;
      if (address == ' ') continue;
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      EXPECT_NE(end, at) << line;
      at = end;
      if (address == 'G' && value < 4.0) motion = value;
      if (address != 'G') word[address] = value;
      moves = moves || std::string("XYZBC").find(address) != std::string::npos;
    }
    const Point point{word['X'], word['Y'], word['Z'], word['B'], word['C']};
    if (moves && motion > 0.0) {
      ++reading.feed_blocks;
      for (std::size_t k = 0; k < point.size(); ++k) reading.cut[k].add(point[k]);
      reading.chord_time_s +=
          std::hypot(point[0] - last[0], point[1] - last[1], point[2] - last[2]) / word['F'] * 60.0;
    }
    last = point;
  }
  return reading;
}

const Workload& full_car() {
  static const Workload workload = car_body({});
  return workload;
}

const Workload& full_blade() {
  static const Workload workload = impeller_blade({});
  return workload;
}

// Table of the experiment: blocks, size in kB (of 1000 or 1024 bytes), zone, time on the machine.
TEST(CarBodyProgram, HasTheBlocksSizeZoneAndTimeOfTheExperiment) {
  const TextReading reading = read_program(full_car().program.text());
  EXPECT_EQ(reading.blocks, 41913);
  EXPECT_NEAR(static_cast<double>(full_car().program.text().size()), 1'147e3, 0.03 * 1'147e3);
  EXPECT_NEAR(reading.cut[0].size(), 52.0, 1e-9);
  EXPECT_NEAR(reading.cut[1].max, 43.0, 0.25);  // the row ends; half circles bulge to the edge
  EXPECT_NEAR(reading.cut[2].size(), 31.0, 1e-9);
  EXPECT_NEAR(reading.chord_time_s, 2734.0, 0.03 * 2734.0);
  EXPECT_LT(reading.chord_time_s, 2734.0);
}

TEST(ImpellerProgram, HasTheBlocksSizeZoneAndTimeOfTheExperiment) {
  const TextReading reading = read_program(full_blade().program.text());
  EXPECT_EQ(reading.blocks, 173103);
  EXPECT_NEAR(static_cast<double>(full_blade().program.text().size()), 11'955e3, 0.03 * 11'955e3);
  EXPECT_NEAR(reading.cut[0].size(), 52.0, 1e-2);
  EXPECT_NEAR(reading.cut[1].size(), 86.0, 1e-2);
  EXPECT_NEAR(reading.cut[2].size(), 34.0, 1e-2);
  EXPECT_NEAR(reading.chord_time_s, 3071.0, 0.04 * 3071.0);
  EXPECT_LT(reading.chord_time_s, 3071.0);
}

TEST(ImpellerProgram, KeepsAwayFromThePoleAndWithinTheTiltOfTheHead) {
  const TextReading reading = read_program(full_blade().program.text());
  EXPECT_GT(reading.cut[3].min, 3.0);
  EXPECT_LT(reading.cut[3].max, 35.0);
  EXPECT_LT(std::abs(reading.cut[4].max), 90.0);
  EXPECT_LT(std::abs(reading.cut[4].min), 90.0);
}

// Rotary speed C'(s) F and acceleration C"(s) F^2 along the rows, from differences of neighbouring
// blocks, against half of what the slowest suitable rotary axis gives (60 deg/s, 600 deg/s^2).
TEST(ImpellerProgram, TurnsItsRotaryAxesComfortablyAtItsFeeds) {
  const std::vector<PathStep>& path = full_blade().program.path();
  const auto length = [&](std::size_t i) {
    return std::hypot(path[i].end[0] - path[i - 1].end[0], path[i].end[1] - path[i - 1].end[1],
                      path[i].end[2] - path[i - 1].end[2]);
  };
  const auto is_row = [&](std::size_t i) {
    const double dy = path[i].end[1] - path[i - 1].end[1];
    return path[i].feed_mm_per_s < 500.0 && std::abs(dy) > 0.5 * length(i) &&
           dy * (path[i + 1].end[1] - path[i].end[1]) > 0.0;
  };
  double speed_max = 0.0;
  double acceleration_max = 0.0;
  for (std::size_t i = 2; i + 2 < path.size(); ++i) {
    if (!is_row(i - 1) || !is_row(i) || !is_row(i + 1)) continue;
    for (std::size_t axis = 3; axis < 5; ++axis) {
      const double rate = (path[i].end[axis] - path[i - 1].end[axis]) / length(i);
      const double next = (path[i + 1].end[axis] - path[i].end[axis]) / length(i + 1);
      const double feed = path[i].feed_mm_per_s;
      speed_max = std::max(speed_max, std::abs(rate) * feed);
      acceleration_max = std::max(acceleration_max, 2.0 * std::abs(next - rate) /
                                                        (length(i) + length(i + 1)) * feed * feed);
    }
  }
  EXPECT_LT(speed_max, 30.0);
  EXPECT_LT(acceleration_max, 300.0);
}

TEST(Workloads, AreTheSameEveryTime) {
  WorkloadOptions small;
  small.scale = Scale::small;
  EXPECT_EQ(car_body(small).program.text(), car_body(small).program.text());
  EXPECT_EQ(impeller_blade(small).program.text(), impeller_blade(small).program.text());
}

TEST(Workloads, AreShortAtSmallScaleUnderTheSameNames) {
  WorkloadOptions options;
  options.scale = Scale::small;
  const Workload car = car_body(options);
  const Workload blade = impeller_blade(options);
  EXPECT_EQ(car.name, full_car().name);
  EXPECT_EQ(blade.name, full_blade().name);
  const TextReading car_reading = read_program(car.program.text());
  const TextReading blade_reading = read_program(blade.program.text());
  EXPECT_EQ(car_reading.blocks, 600);
  EXPECT_EQ(blade_reading.blocks, 1500);
  EXPECT_LT(car_reading.chord_time_s + blade_reading.chord_time_s, 40.0);
}

TEST(Workloads, TakeTheFeedsOfTheCaller) {
  WorkloadOptions options;
  options.scale = Scale::small;
  options.feed_low = 1000.0;
  options.feed_high = 2000.0;
  const std::string text = car_body(options).program.text();
  EXPECT_NE(text.find("F1000"), std::string::npos);
  EXPECT_NE(text.find("F2000"), std::string::npos);
}

TEST(CarBodyProgram, HasArcsInBothPlanesAndRapids) {
  int clockwise = 0;
  int counter_clockwise = 0;
  int rapid = 0;
  for (const PathStep& step : full_car().program.path()) {
    clockwise += step.shape == 2 ? 1 : 0;
    counter_clockwise += step.shape == 3 ? 1 : 0;
    rapid += step.feed_mm_per_s > 500.0 ? 1 : 0;
  }
  EXPECT_GT(clockwise, 50);
  EXPECT_GT(counter_clockwise, 50);
  EXPECT_GT(rapid, 50);
  EXPECT_NE(full_car().program.text().find(" G18 G2 "), std::string::npos);
}

// The centre must be equally far from both ends: half circles are programmed without rounding.
TEST(CarBodyProgram, HasArcsThatCloseToTheBit) {
  const std::vector<PathStep>& path = full_car().program.path();
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].shape == 1) continue;
    const double x = path[i - 1].end[0] + path[i].centre[0];
    EXPECT_NEAR(path[i].end[0] - x, path[i].centre[0], 1e-12);
    EXPECT_EQ(path[i].end[1], path[i - 1].end[1]);
    EXPECT_EQ(path[i].end[2], path[i - 1].end[2]);
  }
}

TEST(PathFiles, HoldTheNumbersOfTheProgram) {
  const std::string csv = path_csv(full_car(), {});
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "x,y,z,f,g,i,j,stop");
  const auto rows = std::count(csv.begin(), csv.end(), '\n') - 1;
  EXPECT_EQ(static_cast<std::size_t>(rows), full_car().program.path().size());
  EXPECT_EQ(csv.substr(csv.size() - 3), ",1\n");
}

TEST(PathFiles, StartASliceAtTheEndOfTheBlockBefore) {
  const std::vector<PathStep>& path = full_blade().program.path();
  const std::size_t i = 1000;
  const std::string csv = path_csv(full_blade(), {path[i].block, path[i].block + 1});
  std::istringstream lines(csv);
  std::string header;
  std::string first;
  std::string second;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(header, "x,y,z,b,c,f,g,i,j,stop");
  EXPECT_EQ(std::strtod(first.c_str(), nullptr), path[i - 1].end[0]);
  EXPECT_EQ(std::strtod(second.c_str(), nullptr), path[i].end[0]);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
}

TEST(DecimalText, ShowsAllDecimalsAndTheSign) {
  EXPECT_EQ(decimal_text(0, 3), "0.000");
  EXPECT_EQ(decimal_text(-5, 3), "-0.005");
  EXPECT_EQ(decimal_text(123456, 3), "123.456");
  EXPECT_EQ(decimal_text(-7, 0), "-7");
}

TEST(Shares, AddUpToTheTotalWhateverTheWeights) {
  const std::vector<int> counts = shares({0.3, 7.1, 2.2, 1e-9, 5.0}, 1001);
  int sum = 0;
  for (const int count : counts) sum += count;
  EXPECT_EQ(sum, 1001);
}

// On a circle the curvature is constant, so the chords are equal.
TEST(CurveSplit, CutsACircleIntoEqualChords) {
  const auto circle = [](double t) { return Point{10.0 * std::cos(t), 10.0 * std::sin(t)}; };
  const std::vector<double> ends = CurveSplit(circle, 0.0, 3.0, {}).ends(30);
  ASSERT_EQ(ends.size(), 30U);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    EXPECT_NEAR(ends[k], 0.1 * static_cast<double>(k + 1), 1e-6);
  }
  EXPECT_EQ(ends.back(), 3.0);
}

}  // namespace
}  // namespace stanok::programs

// The blade of the experiment with vectors in place of angles: the same ends, the same time.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "programs/generators/impeller_blade.h"
#include "runtime/simulation.h"
#include "tests/runtime/feed_ends.h"
#include "tests/support/temporary_directory.h"

namespace stanok::runtime {
namespace {

constexpr int table_and_head = 2;  // scheme of e7106mf4

std::string blade_of_angles(programs::Scale scale) {
  programs::WorkloadOptions options;
  options.scale = scale;
  return programs::impeller_blade(options).program.text();
}

// Behind G43.4 each B and C becomes the direction (sin B cos C, -sin B sin C, cos B).
std::string with_vectors(const std::string& angles) {
  std::istringstream lines(angles);
  std::string text;
  double b_deg = 0.0;
  double c_deg = 0.0;
  bool is_led = false;
  for (std::string line; std::getline(lines, line); text += '\n') {
    if (line.starts_with("(")) {
      text += line;
      continue;
    }
    if (const auto at = line.find("G43.4"); at != std::string::npos) {
      line.replace(at, 5, "G43.5");
      is_led = true;
    }
    std::istringstream words(line);
    bool turns = false;
    for (std::string word; words >> word;) {
      const bool is_angle = word[0] == 'B' || word[0] == 'C';
      if (is_angle) (word[0] == 'B' ? b_deg : c_deg) = std::stod(word.substr(1));
      turns = turns || is_angle;
      if (!is_angle || !is_led) text += word + " ";
    }
    if (!turns || !is_led) continue;
    const double b = b_deg / deg_of_plane;
    const double c = c_deg / deg_of_plane;
    char vector[120];
    std::snprintf(vector, sizeof vector, "I%.16f J%.16f K%.16f", std::sin(b) * std::cos(c),
                  -std::sin(b) * std::sin(c), std::cos(b));
    text += vector;
  }
  return text;
}

// The last part of each block.
std::vector<FeedEnd> block_ends(const std::string& text) {
  std::vector<FeedEnd> ends;
  for (const FeedEnd& end : feed_ends(machine_called("e7106mf4.toml"), text, table_and_head)) {
    if (!ends.empty() && ends.back().block == end.block) ends.pop_back();
    ends.push_back(end);
  }
  return ends;
}

double machine_time_s(const std::string& text) {
  const stanok::testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "blade.nc") << text;
  SimulationOptions options;
  options.file = config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                           "config" / "machines" / "e7106mf4.toml");
  options.program_roots = {folder.path()};
  options.programs = {{1, "blade.nc"}};
  options.schemes = {{1, table_and_head}};
  const SimulationResult result = simulate(options, {}, [] { return false; });
  EXPECT_TRUE(result.ok);
  return result.machine_time_s;
}

void expect_equal_ends(const std::string& angles) {
  const auto expected = block_ends(angles);
  const auto ends = block_ends(with_vectors(angles));
  ASSERT_GT(expected.size(), 1000U);
  ASSERT_EQ(ends.size(), expected.size());
  double most = 0.0;
  for (std::size_t n = 0; n < ends.size(); ++n) {
    for (std::size_t axis = 0; axis < 5; ++axis) {
      most = std::max(most, std::abs(ends[n].tip_B[axis] - expected[n].tip_B[axis]));
      most = std::max(most, std::abs(ends[n].axes_M[axis] - expected[n].axes_M[axis]));
    }
  }
  EXPECT_LT(most, 1e-9);
}

void expect_equal_time(const std::string& angles) {
  const double expected = machine_time_s(angles);
  EXPECT_NEAR(machine_time_s(with_vectors(angles)) / expected, 1.0, 0.01);
  EXPECT_GT(expected, 10.0);
}

TEST(VectorBlade, EndsWhereTheBladeOfAnglesDoes) {
  expect_equal_ends(blade_of_angles(programs::Scale::small));
}

TEST(VectorBlade, TakesTheTimeOfTheBladeOfAngles) {
  expect_equal_time(blade_of_angles(programs::Scale::small));
}

TEST(VectorBlade, OfTheWholeExperimentIsTheBladeOfAnglesFullSize) {
  const std::string angles = blade_of_angles(programs::Scale::full);
  expect_equal_ends(angles);
  expect_equal_time(angles);
}

}  // namespace
}  // namespace stanok::runtime

// The tool on the great circle between two vectors, through the whole chain: in each cycle, from
// the angles of the axes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "runtime/simulation.h"
#include "tests/runtime/feed_ends.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace stanok::runtime {
namespace {

constexpr double circle_tolerance_deg = 0.005;  // docs/reference/language.md, G43.5

double radians(double deg) {
  return deg / deg_of_plane;
}

// The cradle A turns the plate C, which turns the part: back from the tool, which is upright.
Point tool_of_trunnion(double a_deg, double c_deg) {
  return Eigen::AngleAxisd(-radians(c_deg), Point::UnitZ()) *
         (Eigen::AngleAxisd(-radians(a_deg), Point::UnitX()) * Point::UnitZ());
}

// The head B leans the tool, the table C turns the part.
Point tool_of_head(double b_deg, double c_deg) {
  const double b = radians(b_deg);
  const double c = radians(c_deg);
  return {std::sin(b) * std::cos(c), -std::sin(b) * std::sin(c), std::cos(b)};
}

// The head C turns the head A, which leans the tool.
Point tool_of_two_heads(double a_deg, double c_deg) {
  return Eigen::AngleAxisd(radians(c_deg), Point::UnitZ()) *
         (Eigen::AngleAxisd(radians(a_deg), Point::UnitX()) * Point::UnitZ());
}

std::filesystem::path shipped(const char* name) {
  return std::filesystem::path(stanok::testing::source_folder()) / "config" / "machines" / name;
}

config::MachineFile trunnion() {
  return config::read_machine_file(shipped("trunnion.toml"));
}

config::MachineFile head_and_table() {
  return config::read_machine_file(shipped("e7106mf4.toml"));
}

// The slides and rotary axes of the trunnion, both rotary axes in the head.
config::MachineFile two_heads() {
  const stanok::testing::TemporaryDirectory folder;
  std::ifstream from(shipped("trunnion.toml"));
  std::string text{std::istreambuf_iterator<char>(from), {}};
  const auto begin = text.find("type = \"table_table\"");
  const auto end = text.find("\n\n", begin);
  text.replace(begin, end - begin,
               "type = \"head_head\"\n"
               "axes = [\"X\", \"Y\", \"Z\", \"A\", \"C\"]\n"
               "zero = { X = 0.0, Y = 0.0, Z = -500.0 }\n"
               "outer_axis = \"C\"\nouter_vector = [0.0, 0.0, 1.0]\n"
               "inner_axis = \"A\"\ninner_vector = [1.0, 0.0, 0.0]\n"
               "pivot_to_spindle = [0.0, 0.0, -100.0]");
  std::filesystem::copy(shipped("trunnion"), folder.path() / "trunnion");
  std::ofstream(folder.path() / "heads.toml") << text;
  return config::read_machine_file(folder.path() / "heads.toml");
}

struct FiveAxes {
  const char* name;
  config::MachineFile (*machine)();
  int scheme;  // -1: the one at power-on
  Point (*tool)(double, double);
  double start_j;  // of the vector from which A leans to the side on which it has its travel
};

struct Place {
  Point tip_W;
  Point tool;
};

// Vectors as far apart as they come, and near to each other, near the pole and far from it.
std::vector<Place> random_places(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<Place> places;
  double lean = radians(20.0);
  double azimuth = 0.0;
  while (static_cast<int>(places.size()) < count) {
    const bool is_near = part(random) < 0.3;
    lean =
        is_near ? lean + radians(4.0 * (part(random) - 0.5)) : radians(2.0 + 48.0 * part(random));
    azimuth = is_near ? azimuth + radians(6.0 * (part(random) - 0.5))
                      : 2.0 * std::numbers::pi * part(random);
    lean = std::clamp(lean, radians(2.0), radians(50.0));
    const Point tool(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                     std::cos(lean));
    const auto at = [&] { return 40.0 * part(random) - 20.0; };
    places.push_back({Point(at(), at(), 40.0 + at()), tool});
  }
  return places;
}

std::string line_to(const Place& place) {
  char text[200];
  std::snprintf(text, sizeof text, "G1 X%.6f Y%.6f Z%.6f I%.12f J%.12f K%.12f\n", place.tip_W.x(),
                place.tip_W.y(), place.tip_W.z(), place.tool.x(), place.tool.y(), place.tool.z());
  return text;
}

struct Found {
  double farthest_deg = 0.0;
  std::int64_t cycles = 0;
};

class OffCircle final : public CycleObserver {
 public:
  OffCircle(const FiveAxes& chain, const std::vector<Place>& places, int first_line, double ends)
      : chain_(chain), places_(places), first_line_(first_line), ends_(ends) {}
  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels.begin()[0];
    const int k = static_cast<int>(channel.tag.line) - first_line_;
    if (!channel.moving || k < 0 || k + 1 >= static_cast<int>(places_.size())) return;
    const Place& from = places_[static_cast<std::size_t>(k)];
    const Place& to = places_[static_cast<std::size_t>(k) + 1];
    const Point tip(channel.point_W[0].value, channel.point_W[1].value, channel.point_W[2].value);
    const Point way = to.tip_W - from.tip_W;
    const double part = (tip - from.tip_W).dot(way) / way.squaredNorm();
    if (part < ends_ || part > 1.0 - ends_) return;
    const Point tool = chain_.tool(channel.axes[3].position, channel.axes[4].position);
    const Point pole = from.tool.cross(to.tool).normalized();
    const double off = deg_of_plane * std::abs(std::asin(tool.dot(pole)));
    found_.farthest_deg = std::max(found_.farthest_deg, off);
    ++found_.cycles;
  }
  [[nodiscard]] const Found& found() const { return found_; }

 private:
  const FiveAxes& chain_;
  const std::vector<Place>& places_;
  int first_line_;
  double ends_;
  Found found_;
};

std::string faults_of(const SimulationResult& result) {
  std::string text;
  for (const auto* alarms : {&result.alarms, &result.load_diagnostics}) {
    for (const channels::AlarmReport& alarm : *alarms)
      text += alarm.diagnostic.code + " line " + std::to_string(alarm.diagnostic.place.line) +
              ": " + alarm.diagnostic.message + "\n";
  }
  for (const std::string& refusal : result.refusals) text += refusal + "\n";
  return text;
}

class GreatCircle : public ::testing::TestWithParam<FiveAxes> {
 protected:
  // 25 moves for each seed.
  void expect_on_circles(unsigned seeds) {
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      expect_on_circle("G61.1", 0.0, seed);
      expect_on_circle("G64", 0.07, seed);
    }
  }
  void expect_on_circle(const std::string& path_mode, double ends, unsigned seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    expect_on_circle(path_mode, ends, random_places(random, 26));
  }
  void expect_on_circle(const std::string& path_mode, double ends,
                        const std::vector<Place>& places) {
    const std::string head = "T2 M6\nS1000 M3\nG54 G43.5 H2 F2000\nG0 X0 Y0 Z60 I0 J" +
                             std::to_string(GetParam().start_j) + " K0.94\n" + path_mode + "\n";
    std::string text = head;
    for (const Place& place : places) text += line_to(place);
    const int first_line = 2 + static_cast<int>(std::ranges::count(head, '\n'));
    const stanok::testing::TemporaryDirectory folder;
    std::ofstream(folder.path() / "circle.nc") << text << "M30\n";
    SimulationOptions options;
    options.file = GetParam().machine();
    options.program_roots = {folder.path()};
    options.programs = {{1, "circle.nc"}};
    if (GetParam().scheme >= 0) options.schemes = {{1, GetParam().scheme}};
    OffCircle off(GetParam(), places, first_line, ends);
    const SimulationResult result = simulate(options, {&off}, [] { return false; });
    ASSERT_TRUE(result.ok) << faults_of(result);
    EXPECT_GT(off.found().cycles, 500);
    EXPECT_LT(off.found().farthest_deg, circle_tolerance_deg);
    worst_deg_ = std::max(worst_deg_, off.found().farthest_deg);
  }
  void TearDown() override {
    ::testing::Test::RecordProperty("worst_deg", std::to_string(worst_deg_));
  }

 private:
  double worst_deg_ = 0.0;
};

// Between stops everywhere; on a smooth path away from its corners, for which a line has a
// sixteenth at either end.
TEST_P(GreatCircle, IsKeptInEachCycle) {
  expect_on_circles(stanok::testing::cases(2U));
}

TEST_P(GreatCircle, IsKeptInEachCycleFullSize) {
  expect_on_circles(40);
}

// From one side of the pole to the other, past it at a distance of one ten-thousandth of a degree
// to a degree: the free axis makes half a turn within a short part of the way.
TEST_P(GreatCircle, PassesBesideThePole) {
  const double side = GetParam().start_j < 0.0 ? -1.0 : 1.0;
  for (const double past_deg : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 0.1, 1.0}) {
    SCOPED_TRACE("past the pole at " + std::to_string(past_deg) + " deg");
    const Point past(std::sin(radians(past_deg)), 0.0, std::cos(radians(past_deg)));
    const auto lean = [&](double deg) {
      return Point(std::cos(radians(deg)) * past + std::sin(radians(deg)) * Point::UnitY());
    };
    expect_on_circle(
        "G61.1", 0.0,
        {{Point(0, 0, 60), lean(25.0 * side)}, {Point(10, 5, 50), lean(-25.0 * side)}});
  }
}

INSTANTIATE_TEST_SUITE_P(
    Chains, GreatCircle,
    ::testing::Values(FiveAxes{"table_table", trunnion, -1, tool_of_trunnion, -0.342},
                      FiveAxes{"head_table", head_and_table, 2, tool_of_head, -0.342},
                      FiveAxes{"head_head", two_heads, -1, tool_of_two_heads, 0.342}),
    [](const auto& chain) { return std::string(chain.param.name); });

}  // namespace
}  // namespace stanok::runtime

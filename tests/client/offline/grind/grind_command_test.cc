// `stanok grind` as a person calls it: files to the letter, JSON by its names, exit codes, programs
// that run on the grinder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/client/stanok_program.h"
#include "tests/support/project_folders.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string grinder = stanok::testing::source_folder() + "/config/machines/grinder.toml";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// A folder for the files of a test, and calls of the program that leave their output there.
class Grind : public ::testing::Test {
 protected:
  Grind() {
    std::string pattern = (fs::temp_directory_path() / "stanok-grind-test-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Grind() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  int run(const std::string& arguments) const {
    const std::string command =
        stanok_program + " " + arguments + " >" + path("stdout") + " 2>" + path("stderr");
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status)) << command;
    return WEXITSTATUS(status);
  }
  [[nodiscard]] std::string output() const { return text_of(path("stdout")); }
  [[nodiscard]] std::string errors() const { return text_of(path("stderr")); }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(output()); }

  // The example with one thing replaced.
  [[nodiscard]] std::string control_file_with(const std::string& what,
                                              const std::string& other) const {
    std::string text = text_of(example_folder + "plunge_grinding.txt");
    return write("changed.txt", text.replace(text.find(what), what.size(), other));
  }

 private:
  fs::path folder_;
};

TEST_F(Grind, VerifiesThePapersFileAndWritesItBackToTheLetter) {
  EXPECT_EQ(
      run("grind verify " + example_folder + "plunge_grinding.txt --out " + path("again.txt")), 0);
  EXPECT_EQ(text_of(path("again.txt")), text_of(example_folder + "plunge_grinding.txt"));
  EXPECT_THAT(output(), HasSubstr("damping ratio 0.9000"));
  EXPECT_THAT(errors(), HasSubstr("W910"));
}

TEST_F(Grind, CallsABurnABurn) {
  const std::string burning = control_file_with("-0.0048 0.0040", "-0.0048 0.0080");
  EXPECT_EQ(run("grind verify " + burning), 1);
  EXPECT_THAT(errors(), HasSubstr("E9103"));
}

TEST_F(Grind, TellsAnUndersizePartAsTextAsJsonAndByItsExitCode) {
  const std::string deep = control_file_with("-0.0048 0.0040", "-0.0600 0.0040");
  EXPECT_EQ(run("grind verify " + deep), 1);
  EXPECT_THAT(errors(), HasSubstr("error[E9108]: the part is undersize"));
  EXPECT_THAT(output(), HasSubstr("failed"));
  EXPECT_EQ(run("grind verify --json " + deep), 1);
  EXPECT_EQ(json()["ok"], false);
  EXPECT_LT(json()["residual_mm"], -0.050);
  EXPECT_NEAR(json()["out_of_roundness_mm"], 0.0040 * 0.5, 0.00005);
  EXPECT_EQ(json()["findings"].back()["code"], "E9108");
}

TEST_F(Grind, RefusesAWrongControlFileWithPlaceAndRange) {
  const std::string wrong = control_file_with("25000000.0", "25000.0");
  EXPECT_EQ(run("grind verify " + wrong), 1);
  EXPECT_THAT(errors(), HasSubstr("changed.txt:4:1"));
  EXPECT_THAT(errors(), HasSubstr("25000 N/mm would be 25000000 N/m"));
  EXPECT_EQ(run("grind verify " + wrong + " --json"), 1);
  EXPECT_EQ(json()["diagnostics"][0]["code"], "E9102");
}

TEST_F(Grind, TellsFaultsOfAProcessFileAsTextAndAsJson) {
  std::string text = text_of(example_folder + "plunge_grinding.toml");
  text.replace(text.find("25_000_000.0"), 12, "25_000.0");
  const std::string wrong = write("p.toml", text);
  EXPECT_EQ(run("grind design " + wrong), 1);
  EXPECT_THAT(errors(), HasSubstr("p.toml:12:13: process: stiffness is 25000;"));
  EXPECT_EQ(run("grind design --json " + wrong), 1);
  EXPECT_EQ(json()["ok"], false);
  EXPECT_EQ(json()["diagnostics"][0]["line"], 12);
  EXPECT_THAT(std::string(json()["diagnostics"][0]["message"]), HasSubstr("25000000 N/m"));
  EXPECT_EQ(run("grind design " + path("none.toml")), 1);
  EXPECT_EQ(run("grind verify " + path("")), 1);
}

TEST_F(Grind, DesignsFromAProcessFileWhatVerifyAccepts) {
  const std::string design = "grind design " + example_folder + "plunge_grinding.toml";
  ASSERT_EQ(run(design + " --json --out " + path("cycle.txt")), 0);
  const nlohmann::json result = json();
  EXPECT_NEAR(result["q_max"], 0.408214276, 1e-6);
  EXPECT_NEAR(result["damping_ratio"], 0.9, 5e-5);
  EXPECT_LE(result["q_over_d_max"], 1.001);
  EXPECT_LE(result["residual_mm"], 0.0);
  EXPECT_EQ(result["boundary"].size(), 3U);
  EXPECT_EQ(result["law"][0][0], 0.3);
  EXPECT_EQ(result["iterations"][0]["n"], 0);
  EXPECT_LT(result["lower_bound_s"], result["compare"]["continuous_s"]);
  EXPECT_LT(result["compare"]["continuous_s"], result["cycle_time_s"]);
  EXPECT_LT(result["cycle_time_s"], result["compare"]["three_step_s"]);
  EXPECT_LT(result["compare"]["three_step_s"], result["compare"]["constant_safe_s"]);
  EXPECT_EQ(result["stiffness"][0]["factor"], 0.5);
  EXPECT_GT(result["stiffness"][0]["size_error_mm"], 0.0);

  ASSERT_EQ(run("grind verify --json " + path("cycle.txt")), 0);
  EXPECT_EQ(json()["cycle_time_s"], result["cycle_time_s"]);
  EXPECT_EQ(json()["findings"].size(), 0U);
}

TEST_F(Grind, TakesNumberOrPlacesOfTheSwitchPoints) {
  const std::string design = "grind design " + example_folder + "plunge_grinding.toml --json ";
  ASSERT_EQ(run(design + "--points 3"), 0);
  EXPECT_EQ(json()["law"].size(), 8U);
  ASSERT_EQ(run(design + "--at 0.1,0.05,0.0"), 0);
  EXPECT_EQ(json()["law"][1][0], 0.1);
  EXPECT_EQ(json()["law"][5][0], 0.0);
  EXPECT_EQ(run(design + "--at 0.05,0.1"), 1);
  EXPECT_EQ(run(design + "--points 3 --at 0.1"), 2);
}

TEST_F(Grind, RefusesAGainOfOneUnlessForced) {
  const std::string design =
      "grind design " + example_folder + "plunge_grinding.toml --iterations 12 ";
  EXPECT_EQ(run(design + "--koc 1.2"), 1);
  EXPECT_THAT(errors(), HasSubstr("E9107"));
  ASSERT_EQ(run(design + "--koc 1.5 --force --json"), 0);
  const nlohmann::json iterations = json()["iterations"];
  EXPECT_EQ(iterations.size(), 13U);
  EXPECT_GT(iterations.back()["rms"], iterations[7]["rms"]);
}

TEST_F(Grind, DrawsItsPictures) {
  const std::string verify = "grind verify " + example_folder + "plunge_grinding.txt --picture ";
  ASSERT_EQ(run(verify + path("a.svg")), 0) << errors();
  EXPECT_THAT(text_of(path("a.svg")), HasSubstr("<svg"));
  ASSERT_EQ(run(verify + path("a.png")), 0) << errors();
  EXPECT_THAT(text_of(path("a.png")), ::testing::StartsWith("\x89PNG"));
  EXPECT_EQ(run(verify + path("a.gif")), 2);
}

TEST_F(Grind, StudiesEveryCombinationInOrder) {
  ASSERT_EQ(run("grind study " + example_folder +
                "plunge_grinding.toml --points 3 --vary stiffness=2e6:3e7:2 "
                "--vary part_speed=100:140:3"),
            0);
  std::vector<std::string> lines;
  std::istringstream text(output());
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_THAT(lines[0], ::testing::StartsWith("stiffness,part_speed,cycle_time_s,"));
  EXPECT_THAT(lines[1], ::testing::StartsWith("2000000,100,,"));
  EXPECT_THAT(lines[1], HasSubstr("E9102"));
  EXPECT_THAT(lines[5], ::testing::StartsWith("30000000,120,"));
  const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
  EXPECT_EQ(commas(lines[5]), commas(lines[0]));
  EXPECT_EQ(run("grind study " + example_folder + "plunge_grinding.toml --vary stifness=1:2:3"), 2);
}

// The values of a list are those of the same range: 100, 120, 140.
TEST_F(Grind, StudiesListsAsRangesOfTheSameValues) {
  const std::string study = "grind study " + example_folder + "plunge_grinding.toml --points 3 ";
  ASSERT_EQ(run(study + "--set part_speed=100:140:3"), 0);
  const std::string of_range = output();
  ASSERT_EQ(run(study + "--set part_speed=100,120,140"), 0);
  EXPECT_EQ(output(), of_range);
  ASSERT_EQ(run(study + "--set part_speed=140,100"), 0);  // in the order of the list
  const std::string of_list = output();
  const std::size_t first = of_list.find("\n140,");
  ASSERT_NE(first, std::string::npos);
  EXPECT_LT(first, of_list.find("\n100,"));
}

// More parts than designs, too: then some have none.
TEST_F(Grind, PartsOfAStudyAreTheWholeOne) {
  const std::string study = "grind study " + example_folder +
                            "plunge_grinding.toml --points 3 --set part_speed=100:140:5 ";
  ASSERT_EQ(run(study), 0);
  const std::string whole = output();
  for (const int parts : {1, 2, 3, 7}) {
    std::string together;
    for (int k = 1; k <= parts; ++k) {
      ASSERT_EQ(run(study + "--part " + std::to_string(k) + "/" + std::to_string(parts)), 0);
      together += output();
    }
    EXPECT_EQ(together, whole) << parts;
  }
  for (const char* wrong : {"0/3", "4/3", "1", "1/0", "a/3", "1/3x", "-1/3", ""})
    EXPECT_EQ(run(study + "--part '" + wrong + "'"), 2) << wrong;
}

TEST_F(Grind, RefusesSetsOfAnotherForm) {
  for (const char* wrong : {"part_speed=", "part_speed=100,", "part_speed=,100", "part_speed=1,x",
                            "part_speed=1:2", "part_speed=1:2:3:", "part_speed=1:2:0",
                            "part_speed=1:2,3:4", "part_speed=inf", "part_speed"}) {
    EXPECT_EQ(run("grind study " + example_folder + "plunge_grinding.toml --set " + wrong), 2)
        << wrong;
  }
}

struct TraceRow {
  double t, feed, x, vx;
};

std::vector<TraceRow> read_trace(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  EXPECT_THAT(line, ::testing::StartsWith("t,line,feed,x,z,c,vx"));
  std::vector<TraceRow> rows;
  while (std::getline(stream, line)) {
    std::vector<double> values;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    rows.push_back({values[0], values[2], values[3], values[6]});
  }
  return rows;
}

// Switched within one increment of the machine (0.1 um), feeds to 1e-6, at rest at the last X.
TEST_F(Grind, ProgramFollowsTheTableInTheSimulation) {
  ASSERT_EQ(run("grind program " + example_folder + "plunge_grinding.txt -o " + path("p.nc") +
                " --machine " + grinder),
            0)
      << errors();
  EXPECT_EQ(text_of(path("p.nc")), text_of(example_folder + "plunge_grinding.nc"));
  ASSERT_EQ(run("simulate " + path("p.nc") + " --machine " + grinder +
                " --tip-trace 1=" + path("trace.csv")),
            0)
      << errors();
  const auto trace = read_trace(path("trace.csv"));
  const std::vector<std::array<double, 3>> table = {
      {0.3000, 0.2602, 0.0400}, {0.2602, 0.0893, 0.0294}, {0.0893, 0.0700, 0.0233},
      {0.0700, 0.0500, 0.0177}, {0.0500, 0.0200, 0.0097}, {0.0200, -0.0048, 0.0040}};
  constexpr double increment = 0.0001;
  for (const auto& [begin, end, feed] : table) {
    int inside = 0;
    for (const TraceRow& row : trace) {
      if (row.vx >= 0.0 || row.x > begin - increment || row.x < end + increment) continue;
      ++inside;
      ASSERT_NEAR(row.vx, -feed, 1e-6) << "X " << row.x;
      ASSERT_NEAR(row.feed, feed, 1e-6) << "X " << row.x;
    }
    EXPECT_NEAR(inside * 0.001, (begin - end - 2.0 * increment) / feed, 0.002);
  }
  const auto lowest = std::ranges::min_element(trace, {}, &TraceRow::x);
  EXPECT_EQ(lowest->x, -0.0048);
  EXPECT_EQ(lowest->vx, 0.0);
}

// The gauge sees the size where the simulated X stands at 29.9970: 1.8 um before the table's end.
TEST_F(Grind, ProgramEndsWhereTheGaugeFindsTheSize) {
  const auto with_contact = [&](const std::string& name, const std::string& to) {
    std::string machine = text_of(grinder);
    machine.erase(machine.find("tables = "),
                  std::string("tables = \"grinder/tables.toml\"").size());
    return write(name, machine + "\n[[contact]]\ninput = 0\naxis = \"X\"\nto = " + to + "\n");
  };
  ASSERT_EQ(run("grind program " + example_folder + "plunge_grinding.txt -o " + path("g.nc") +
                " --gauge 0.02 --machine " + grinder),
            0)
      << errors();
  ASSERT_EQ(run("simulate " + path("g.nc") + " --machine " + with_contact("g.toml", "29.9970") +
                " --tip-trace 1=" + path("trace.csv")),
            0)
      << errors();
  const auto trace = read_trace(path("trace.csv"));
  const auto lowest = std::ranges::min_element(trace, {}, &TraceRow::x);
  EXPECT_NEAR(lowest->x, -0.0030, 0.0001);
  EXPECT_EQ(run("simulate " + path("g.nc") + " --machine " + with_contact("n.toml", "29.9")), 6)
      << errors();
  EXPECT_THAT(errors() + output(), HasSubstr("no size from the gauge"));
}

TEST_F(Grind, SaysOfAProgramThatItBurns) {
  const std::string burning = control_file_with("-0.0048 0.0040", "-0.0048 0.0080");
  EXPECT_EQ(run("grind program " + burning + " -o " + path("p.nc") + " --machine " + grinder), 1);
  EXPECT_THAT(errors(), HasSubstr("E9103"));
  EXPECT_TRUE(fs::exists(path("p.nc"))) << "written all the same";
}

TEST_F(Grind, RefusesAMachineThatCannotGrindSo) {
  const std::string program =
      "grind program " + example_folder + "plunge_grinding.txt -o " + path("p.nc");
  EXPECT_EQ(run(program + " --machine " + stanok::testing::source_folder() +
                "/config/machines/mill3.toml"),
            1);
  EXPECT_THAT(errors(), HasSubstr("kind \"grind\""));
  EXPECT_EQ(run(program + " --wheel-speed 60 --machine " + grinder), 1);
  EXPECT_THAT(errors(), HasSubstr("wheel would turn at 2864"));
}

}  // namespace
}  // namespace stanok::client

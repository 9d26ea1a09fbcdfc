// Texts, checks and paths of programs as clients get them.
#include "daemon/desk/program_desk.h"

#include <gtest/gtest.h>
#include <sodium.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <numbers>
#include <thread>

#include "config/files/grinding_file.h"
#include "process/grinding/cycle_design.h"
#include "tests/daemon/fake_machine.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

class ProgramDeskTest : public ::testing::Test {
 protected:
  ProgramDeskTest() { machine.root = root.path(); }

  using Ask = std::function<void(Answer answer)>;
  CommandResult answer_to(const Ask& ask) {
    std::optional<CommandResult> answer;
    ask([&answer](const CommandResult& outcome) { answer = outcome; });
    while (!answer) desk.tick();
    return *answer;
  }
  CommandResult read(const json& parameters) {
    return answer_to([&](Answer answer) { desk.read(1, parameters, std::move(answer)); });
  }
  CommandResult write(const json& parameters, int session = 1) {
    return answer_to([&](Answer answer) { desk.write(session, parameters, std::move(answer)); });
  }

  stanok::testing::TemporaryDirectory root;
  FakeMachine machine;
  ProgramDesk desk{machine};
};

TEST_F(ProgramDeskTest, ALongTextComesInPieces) {
  std::string text;
  while (text.size() < ProgramDesk::read_bytes_max + 1000) text += "(ж) G1 X1\n";
  std::ofstream(root.path() / "a.nc", std::ios::binary) << text;
  std::string gathered;
  json piece;
  do {
    piece = *read({{"program", "a.nc"}, {"offset", gathered.size()}});
    gathered += piece["text"].get<std::string>();
    EXPECT_EQ(piece["bytes"], text.size());
    EXPECT_EQ(piece["exact"], true);
  } while (piece["complete"] == false);
  EXPECT_EQ(gathered, text);
  EXPECT_EQ((*read({{"program", "a.nc"}, {"offset", text.size() + 5}}))["text"], "");
}

TEST_F(ProgramDeskTest, ALongTextIsWrittenInPieces) {
  EXPECT_TRUE(write({{"program", "a.nc"}, {"text", "G0 "}, {"more", 1}}));
  EXPECT_TRUE(write({{"program", "b.nc"}, {"text", "of another session"}, {"more", 1}}, 2));
  EXPECT_FALSE(std::filesystem::exists(root.path() / "a.nc"));
  const auto written = write({{"program", "a.nc"}, {"text", "X1\n"}});
  EXPECT_EQ((*written)["bytes"], 6);
  const auto back = read({{"program", "a.nc"}});
  EXPECT_EQ((*back)["text"], "G0 X1\n");
  EXPECT_EQ((*back)["version"], (*written)["version"]);
}

TEST_F(ProgramDeskTest, WhatIsOnItsWayIsBounded) {
  const std::string part(900'000, ' ');
  CommandResult answer = json();
  for (std::size_t k = 0; k * part.size() <= ProgramDesk::upload_bytes_max && answer; ++k)
    answer = write({{"program", "a.nc"}, {"text", part}, {"more", 1}});
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, "E9007");
  EXPECT_TRUE(write({{"program", "a.nc"}, {"text", "M30\n"}})) << "begins anew";
  EXPECT_EQ((*read({{"program", "a.nc"}}))["text"], "M30\n");
}

TEST_F(ProgramDeskTest, ThereIsNoPathBeforeASimulation) {
  const auto none = desk.path(json::object(), 1);
  EXPECT_EQ((*none)["pages"], 0);
  EXPECT_TRUE((*none)["geometry"].is_null());
  EXPECT_EQ(desk.path({{"path", 7}}, 1).error().code, "E9018");
}

class GrindingTest : public ProgramDeskTest {
 protected:
  // It is calculated behind everything else that the computer does.
  CommandResult grinding(const std::string& name) {
    std::optional<CommandResult> answer;
    desk.grinding(1, {{"program", name}},
                  [&answer](const CommandResult& outcome) { answer = outcome; });
    while (!answer) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      desk.tick();
    }
    return *answer;
  }
  // An example with another allowance: less of it takes less time to calculate.
  void put(const std::string& name, const std::string& allowance, const std::string& less) {
    std::ifstream example(stanok::testing::source_folder() + "/programs/examples/" + name);
    std::string text{std::istreambuf_iterator<char>(example), {}};
    ASSERT_NE(text.find(allowance), std::string::npos);
    text.replace(text.find(allowance), allowance.size(), less);
    std::ofstream(root.path() / name) << text;
  }
};

TEST_F(GrindingTest, ASheetIsDesigned) {
  put("plunge_grinding.toml", "allowance = 0.3 ", "allowance = 0.1 ");
  const auto found = grinding("plunge_grinding.toml");
  ASSERT_TRUE(found) << found.error().message;
  const auto request = config::read_grinding_file(root.path() / "plunge_grinding.toml");
  const auto design = process::design_cycle(request);
  ASSERT_TRUE(design);
  EXPECT_EQ((*found)["ok"], true);
  EXPECT_EQ((*found)["time_s"], design->verification.run.time_s);
  EXPECT_EQ((*found)["least_time_s"], design->least_time_s);
  EXPECT_EQ((*found)["constant_time_s"], design->constant_safe_time_s);
  const json& samples = (*found)["samples"];
  EXPECT_GT(samples.size(), 300U);
  EXPECT_LE(samples.size(), 601U);
  EXPECT_NEAR(samples.front()[1].get<double>(), 0.1, 1e-3) << "the allowance";
  for (std::size_t k = 1; k < samples.size(); ++k) EXPECT_GT(samples[k][0], samples[k - 1][0]);
  EXPECT_EQ((*found)["law"].size(), design->law.size());
}

// The figures are those of the worked example (docs/programmer/grinding.md).
TEST_F(GrindingTest, AControlFileIsVerified) {
  put("plunge_grinding.txt", "0.3000 ", "0.3000 ");
  const auto found = grinding("plunge_grinding.txt");
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR((*found)["time_s"].get<double>(), 18.06, 0.005);
  EXPECT_NEAR((*found)["ratio_max"].get<double>(), 1.129, 0.0005);
  EXPECT_NE((*found)["findings"].dump().find("W910"), std::string::npos);
}

TEST_F(GrindingTest, FaultsOfASheetHaveTheirPlace) {
  std::ofstream(root.path() / "bad.toml") << "part_radius = 30.0\nwidth = -1.0\n";
  const auto toml = grinding("bad.toml");
  ASSERT_FALSE(toml);
  EXPECT_EQ(toml.error().code, "E9102");
  EXPECT_EQ(toml.error().place.file, "bad.toml");
  std::ofstream(root.path() / "bad.txt") << "no number\n";
  EXPECT_EQ(grinding("bad.txt").error().code, "E9101");
  EXPECT_EQ(grinding("none.toml").error().code, "E7001");
}

std::string decoded(const std::string& text) {
  std::string bytes(text.size(), '\0');
  std::size_t count = 0;
  EXPECT_EQ(
      sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &count, nullptr, sodium_base64_VARIANT_ORIGINAL),
      0);
  bytes.resize(count);
  return bytes;
}

template <class Value>
Value value_at(const std::string& bytes, std::size_t place) {
  Value value;
  std::memcpy(&value, bytes.data() + place * sizeof value, sizeof value);
  return value;
}

TEST_F(ProgramDeskTest, PagesOfAPathHaveTheirPointsAndLines) {
  machine.planned = std::make_shared<jobs::PlannedPath>(5, "a.nc");
  const std::size_t points = jobs::PlannedPath::page_points + 3;
  for (std::size_t k = 0; k < points; ++k) {
    machine.planned->add({.place_mm = {static_cast<float>(k), 0.5F, -1.0F},
                          .on_part_mm = {static_cast<float>(k), 8.5F, -9.0F},
                          .line = static_cast<std::uint32_t>(2 * k),
                          .begins = k == 0,
                          .rapid = k == 2 || k == 3 || k + 1 == points});
  }
  const auto growing = *desk.path(json::object(), 1);
  EXPECT_EQ(growing["pages"], 1) << "what is not full yet is not told";
  EXPECT_EQ(growing["complete"], false);
  machine.planned->complete();
  const auto first = *desk.path(json::object(), 1);
  EXPECT_EQ(first["id"], 5);
  EXPECT_EQ(first["points"], points);
  EXPECT_EQ(first["complete"], true);
  const json& geometry = first["geometry"];
  EXPECT_EQ(geometry["rapid"], json::parse("[[2,4]]"));
  EXPECT_EQ(geometry["begins"], json::parse("[[0,1]]"));
  const std::string bytes = decoded(geometry["base64"].get<std::string>());
  const std::size_t count = geometry["count"].get<std::size_t>();
  ASSERT_EQ(bytes.size(), count * 16);
  const std::size_t point = 7;
  EXPECT_EQ(value_at<float>(bytes, 3 * point), 7.0F);
  EXPECT_EQ(value_at<float>(bytes, 3 * point + 2), -1.0F);
  EXPECT_EQ(value_at<std::uint32_t>(bytes, 3 * count + point), 14U);
  const auto second = *desk.path(geometry["more"]["params"], 1);
  EXPECT_EQ(second["geometry"]["page"], 1);
  EXPECT_EQ(second["geometry"]["count"], 3);
  EXPECT_FALSE(second["geometry"].contains("more"));
  EXPECT_FALSE((*desk.path({{"page", 0}}, 1))["geometry"].contains("more")) << "one is wanted";
  EXPECT_EQ(second["geometry"]["rapid"], json::parse("[[2,3]]"));
}

TEST_F(ProgramDeskTest, AllPagesOfAPathLieInTheSystemThatWasAskedFor) {
  machine.planned = std::make_shared<jobs::PlannedPath>(5, "a.nc");
  machine.planned->lie_on(
      {.scheme = 2,
       .in_base =
           simulation::Pose(Eigen::Translation3d(1.0, -2.0, 3.5) *
                            Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ()))});
  for (std::size_t k = 0; k < jobs::PlannedPath::page_points + 1; ++k)
    machine.planned->add({.place_mm = {1.0F, 0.5F, -1.0F}, .on_part_mm = {2.0F, 8.5F, -9.0F}});
  machine.planned->complete();
  const auto first = *desk.path({{"system", "part"}}, 1);
  EXPECT_EQ(first["system"], "part");
  EXPECT_EQ(first["part"], json::parse(R"({"scheme":2,"pose":[0,-1,0,1,1,0,0,-2,0,0,1,3.5]})"));
  const auto second = *desk.path(first["geometry"]["more"]["params"], 1);
  const std::string bytes = decoded(second["geometry"]["base64"].get<std::string>());
  EXPECT_EQ(value_at<float>(bytes, 1), 8.5F);
  const auto in_work = *desk.path({{"page", 1}}, 1);
  EXPECT_EQ(in_work["system"], "work");
  EXPECT_EQ(value_at<float>(decoded(in_work["geometry"]["base64"].get<std::string>()), 1), 0.5F);
}

TEST_F(ProgramDeskTest, PointsBeyondTheBoundAreLeftOut) {
  jobs::PlannedPath path(1, "a.nc");
  for (std::size_t k = 0; k < jobs::PlannedPath::points_max + 10'000; ++k) path.add({});
  path.complete();
  EXPECT_FALSE(path.state().is_complete);
  EXPECT_LT(path.state().points, jobs::PlannedPath::points_max + 5'000);
}

}  // namespace
}  // namespace stanok::daemon

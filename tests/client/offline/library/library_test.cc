// The real `stanok` over folders of programs: alone, several at a time and from the cache it says
// the same.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "tests/client/stanok_program.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Printed {
  int exit_code = 0;
  std::string data;
  std::string messages;
};

std::string text_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Library : public ::testing::Test {
 protected:
  Library() {
    fs::create_directories(programs() / "sub");
    std::mt19937 random(28);
    for (int k = 0; k < 30; ++k) write("p" + std::to_string(k) + ".nc", program(random));
    write("sub/caller.nc", "#include \"called.inc\"\nG1 X10 F1000\nM98 P1000\nM30\n");
    write("sub/called.inc", "(included)\n");
    write("sub/1000.nc", "G0 X1\nM99\n");
    write("sub/\xff.nc", "G1 X\nM30\n");
  }

  [[nodiscard]] fs::path programs() const { return folder_.path() / "programs"; }
  [[nodiscard]] std::string cache() const { return (folder_.path() / "cache").string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(programs() / name, std::ios::binary) << text;
  }

  // A few moves; one in four has a fault.
  static std::string program(std::mt19937& random) {
    std::uniform_int_distribution<int> place(-40, 40);
    std::string text = "G90 G64 P0.01 F3000\n";
    const int moves = std::uniform_int_distribution<int>(1, 20)(random);
    for (int k = 0; k < moves; ++k) {
      text += "G1 X" + std::to_string(place(random));
      text += " Y" + std::to_string(place(random)) + "\n";
    }
    constexpr std::array faults{"G2 X5\n", "", "", ""};
    text += faults[std::uniform_int_distribution<std::size_t>(0, faults.size() - 1)(random)];
    return text + "M30\n";
  }

  [[nodiscard]] Printed run(const std::string& command, const std::string& options) const {
    const fs::path data = folder_.path() / "data.out";
    const fs::path messages = folder_.path() / "messages.out";
    const std::string line = stanok_program + " " + command + " " + programs().string() +
                             " --machine " + testing::source_folder() +
                             "/config/machines/mill3.toml " + options + " >" + data.string() +
                             " 2>" + messages.string() + " </dev/null";
    const int status = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(status)) << line;
    return {WEXITSTATUS(status), text_in(data), text_in(messages)};
  }
  // Wall times are of this run alone.
  static json without_times(const std::string& text) {
    json value = json::parse(text);
    for (json& file : value.at("files")) file.erase("seconds");
    value.at("totals").erase("seconds");
    return value;
  }

  testing::TemporaryDirectory folder_;
};

TEST_F(Library, IsCheckedAlikeByOneProcessAndBySeveral) {
  const Printed one = run("check", "--json");
  EXPECT_EQ(one.exit_code, 6);
  const Printed several = run("check", "--json --jobs 3");
  EXPECT_EQ(several.exit_code, 6);
  EXPECT_EQ(without_times(several.data), without_times(one.data));
  EXPECT_EQ(without_times(one.data).at("files").size(), 33U);
  EXPECT_EQ(run("check", "--jobs 3").messages, run("check", "").messages);
  EXPECT_EQ(run("check", "--estimate --jobs 2").data, run("check", "--estimate").data);
}

TEST_F(Library, IsCheckedAlikeFromTheCache) {
  const Printed fresh = run("check", "--json --jobs 2 --cache " + cache());
  EXPECT_EQ(fresh.messages, "cache: 0 of 33 results\n");
  const Printed kept = run("check", "--json --jobs 2 --cache " + cache());
  EXPECT_EQ(kept.messages, "cache: 33 of 33 results\n");
  EXPECT_EQ(kept.data, fresh.data);
  EXPECT_EQ(kept.exit_code, fresh.exit_code);
  EXPECT_EQ(run("check", "--json --limit 5 --cache " + cache()).messages,
            "cache: 0 of 33 results\n");
  write("sub/1000.nc", "G0 X2\nM99\n");
  EXPECT_EQ(run("check", "--json --cache " + cache()).messages, "cache: 31 of 33 results\n");
}

TEST_F(Library, ResultsOfTwoProgramRootsLieBesideEachOther) {
  const fs::path other = folder_.path() / "other";
  fs::create_directories(other);
  const std::string elsewhere = "--json --program-root " + other.string() + " --cache " + cache();
  for (const std::string command : {"check", "simulate"}) {
    EXPECT_EQ(run(command, "--json --cache " + cache()).messages, "cache: 0 of 33 results\n");
    EXPECT_EQ(run(command, elsewhere).messages, "cache: 0 of 33 results\n");
    EXPECT_EQ(run(command, "--json --cache " + cache()).messages, "cache: 33 of 33 results\n");
    EXPECT_EQ(run(command, elsewhere).messages, "cache: 33 of 33 results\n");
  }
}

TEST_F(Library, IsSimulatedAlikeBySeveralAndFromTheCache) {
  const Printed one = run("simulate", "--json");
  const Printed several = run("simulate", "--json --jobs 3 --cache " + cache());
  const Printed kept = run("simulate", "--json --cache " + cache());
  EXPECT_EQ(several.data, one.data);
  EXPECT_EQ(kept.data, one.data);
  EXPECT_EQ(kept.messages, "cache: 33 of 33 results\n");
  EXPECT_EQ(one.exit_code, 6);
  const json files = json::parse(one.data).at("files");
  for (const json& file : files) {
    EXPECT_EQ(file.at("ok"), file.at("diagnostics").empty()) << file;
    EXPECT_TRUE(!file.at("ok") || file.at("time_s") > 0.0) << file;
  }
}

TEST_F(Library, AnEndlessProgramEndsAtTheLimit) {
  write("endless.nc", "while (1 != 0) {\n  G1 X1 F6000\n  G1 X0\n}\nM30\n");
  const Printed checked = run("check", "--limit 1000 --jobs 2");
  EXPECT_NE(checked.messages.find("W820"), std::string::npos);
  EXPECT_NE(checked.messages.find("within 1000 blocks"), std::string::npos);
  const Printed simulated = run("simulate", "--limit 2 --jobs 2");
  EXPECT_NE(simulated.messages.find("W821"), std::string::npos);
  EXPECT_NE(simulated.data.find("W821"), std::string::npos);
}

// The processes of a command are ended from outside while each is at a program that takes its time.
// A child that LeakSanitizer has at the end is none of them, and must be left alone.
TEST_F(Library, AProgramWhoseProcessEndsIsTold) {
  fs::remove_all(programs());
  fs::create_directories(programs());
  const std::string slow =
      "num count = 0;\nwhile (count < 1000000000) {\n  count = count + 1;\n}\nM30\n";
  for (const char* name : {"a.nc", "b.nc", "c.nc"}) write(name, slow);
  const fs::path messages = folder_.path() / "messages.out";
  const std::string script =
      "command=$!; while kill -0 $command 2>/dev/null; do "
      "for child in $(cat /proc/$command/task/$command/children 2>/dev/null); do "
      "kill -KILL $child 2>/dev/null; done; sleep 0.05; done; wait $command";
  const std::string line = "ASAN_OPTIONS=detect_leaks=0 bash -c '" + stanok_program + " check " +
                           programs().string() + " --jobs 2 --machine " + testing::source_folder() +
                           "/config/machines/mill3.toml >/dev/null 2>" + messages.string() +
                           " </dev/null & " + script + "'";
  const int status = std::system(line.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 6);
  const std::string told = text_in(messages);
  EXPECT_NE(told.find("E8006"), std::string::npos) << told;
  EXPECT_NE(told.find("signal 9"), std::string::npos) << told;
  for (const char* name : {"a.nc", "b.nc", "c.nc"})
    EXPECT_NE(told.find(name), std::string::npos) << told;
}

TEST_F(Library, WhatBelongsToOneRunIsRefusedForSeveral) {
  EXPECT_EQ(run("simulate", "--log x.lcm").exit_code, 2);
  EXPECT_EQ(run("simulate", "--until 3").exit_code, 2);
  EXPECT_EQ(run("check", "--jobs -1").exit_code, 2);
  EXPECT_EQ(run("check", "--limit 0").exit_code, 2);
}

TEST_F(Library, ACacheThatCannotBeWrittenChangesNothing) {
  write("file", "");
  const Printed done = run("check", "--json --cache " + (programs() / "file").string());
  EXPECT_EQ(without_times(done.data), without_times(run("check", "--json").data));
  EXPECT_NE(done.messages.find("cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace stanok::client

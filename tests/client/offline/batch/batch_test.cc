// The real `stanok batch` with the local engine: chunks give what one process gives, whatever
// happens to the files between them. With Slurm: tests/client/batch_on_slurm_test.sh.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "client/offline/batch/batch_plan.h"
#include "client/offline/batch/slurm.h"
#include "tests/client/stanok_program.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Said {
  int exit_code = 0;
  std::string data;
  std::string messages;
};

class Batch : public ::testing::Test {
 protected:
  Batch() {
    fs::create_directories(folder_.path() / "programs" / "sub");
    for (int k = 0; k < 9; ++k)
      write("p" + std::to_string(k) + ".nc", k % 4 == 2 ? "G2 X5\nM30\n" : "G1 X5 F900\nM30\n");
    write("sub/\xff.nc", "G1 X\nM30\n");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / "programs" / name, std::ios::binary) << text;
  }
  [[nodiscard]] fs::path work() const { return folder_.path() / "work"; }

  [[nodiscard]] Said run(const std::string& arguments) const {
    const fs::path data = folder_.path() / "data.out";
    const fs::path messages = folder_.path() / "messages.out";
    const std::string line = "cd " + folder_.path().string() + " && " + stanok_program + " " +
                             arguments + " >" + data.string() + " 2>" + messages.string() +
                             " </dev/null";
    const int status = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(status)) << line;
    return {WEXITSTATUS(status), text_of(data), text_of(messages)};
  }
  [[nodiscard]] Said submit(const std::string& options) const {
    return run("batch submit programs --work work " + machine() + options);
  }
  static std::string machine() {
    return "--machine " + testing::source_folder() + "/config/machines/mill3.toml ";
  }
  static std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static json without_wall_times(const std::string& text) {
    json value = json::parse(text);
    for (json& file : value.at("files")) file.erase("seconds");
    value.at("totals").erase("seconds");
    return value;
  }

  testing::TemporaryDirectory folder_;
};

TEST_F(Batch, OfChecksGivesWhatACheckGives) {
  const Said one = run("check programs --json " + machine());
  ASSERT_EQ(one.exit_code, 6);
  EXPECT_EQ(submit("--chunk 4 --jobs 2").exit_code, 0);
  const Said batch = run("batch results work --json");
  EXPECT_EQ(batch.exit_code, 6);
  EXPECT_EQ(without_wall_times(batch.data), without_wall_times(one.data));
  EXPECT_EQ(run("batch results work").messages, run("check programs " + machine()).messages);
  const json state = json::parse(run("batch status work --json").data);
  EXPECT_EQ(state.at("chunks"), 3);
  EXPECT_EQ(state.at("done"), 3);
}

TEST_F(Batch, OfSimulationsGivesWhatASimulationGives) {
  const Said one = run("simulate programs --json " + machine());
  EXPECT_EQ(submit("--chunk 3 --task simulate --limit 5").exit_code, 0);
  const Said batch = run("batch results work --json");
  EXPECT_EQ(batch.data, one.data);
  EXPECT_EQ(batch.exit_code, one.exit_code);
}

TEST_F(Batch, OfSimulationsHasThePicturesOfASimulation) {
  for (const std::string name : {"sub/one.nc", "two.nc"}) {
    write(name,
          "#workpiece (0, 0.5, 0, 20, 20, 10, 10, 10, 10)\nG1 X0 Y0 Z5 F3000\nZ-2\nX5\nM30\n");
  }
  const Said one = run("simulate programs --json --pictures pictures " + machine());
  fs::rename(folder_.path() / "pictures", folder_.path() / "of_one");
  EXPECT_EQ(submit("--chunk 3 --task simulate --pictures pictures").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_.path() / "pictures"));
  const Said batch = run("batch results work --json");
  EXPECT_EQ(batch.data, one.data);
  for (const std::string name : {"sub/one.nc.png", "two.nc.png"}) {
    const std::string picture = text_of(folder_.path() / "pictures" / name);
    EXPECT_FALSE(picture.empty()) << name;
    EXPECT_TRUE(picture == text_of(folder_.path() / "of_one" / name)) << name;
  }
  EXPECT_EQ(run("batch submit programs --work other --pictures pictures " + machine()).exit_code,
            2);  // of a check there are none
}

TEST_F(Batch, AChunkThatIsLostOrDamagedIsDoneAgain) {
  ASSERT_EQ(submit("--chunk 2").exit_code, 0);
  const std::string whole = run("batch results work --json").data;
  const fs::path chunk = work() / "results" / "000002";
  const std::string bytes = text_of(chunk);
  for (const std::string& damaged : {std::string(), bytes.substr(0, bytes.size() / 2),
                                     bytes.substr(0, bytes.size() - 1) + '\x01'}) {
    std::ofstream(chunk, std::ios::binary | std::ios::trunc) << damaged;
    const Said results = run("batch results work --json");
    EXPECT_EQ(results.exit_code, 1);
    EXPECT_EQ(results.data, "");
    EXPECT_NE(results.messages.find("chunk 2 of 5"), std::string::npos) << results.messages;
    EXPECT_EQ(run("batch status work").exit_code, 1);
    const Said again = run("batch submit --work work --json");
    EXPECT_EQ(again.exit_code, 0) << again.messages;
    EXPECT_EQ(json::parse(again.data).at("submitted"), json::array({2}));
    EXPECT_EQ(without_wall_times(run("batch results work --json").data), without_wall_times(whole));
  }
}

TEST_F(Batch, AFolderHoldsOneBatch) {
  ASSERT_EQ(submit("--chunk 4").exit_code, 0);
  EXPECT_EQ(submit("--chunk 4").exit_code, 0);
  const Said other = submit("--chunk 4 --limit 3");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.messages.find("another batch"), std::string::npos);
  EXPECT_EQ(run("batch status programs").exit_code, 1);
  EXPECT_EQ(run("batch run work 3").exit_code, 1);                    // there are 0, 1 and 2
  EXPECT_EQ(run("batch submit programs --work other").exit_code, 2);  // no machine
}

TEST_F(Batch, ATaskWithAnotherMachineFileRefuses) {
  fs::copy(testing::source_folder() + "/config/machines", folder_.path() / "machines",
           fs::copy_options::recursive);
  ASSERT_EQ(run("batch submit programs --work work --machine machines/mill3.toml").exit_code, 0);
  fs::remove(work() / "results" / "000000");
  std::ofstream(folder_.path() / "machines" / "mill3.toml", std::ios::app) << "\n# changed\n";
  EXPECT_EQ(run("batch run work 0").exit_code, 1);
  const Said state = run("batch status work");
  EXPECT_EQ(state.exit_code, 1);
  EXPECT_NE(state.data.find(" in 1 chunk: 0 done"), std::string::npos) << state.data;
  EXPECT_NE(state.data.find("chunk 0 failed: stanok or the machine file"), std::string::npos);
}

TEST_F(Batch, ACancelledOneBeginsNothing) {
  ASSERT_EQ(submit("--chunk 4").exit_code, 0);
  fs::remove(work() / "results" / "000001");
  EXPECT_EQ(run("batch cancel work").exit_code, 0);
  EXPECT_EQ(run("batch run work 1").exit_code, 0);
  EXPECT_FALSE(fs::exists(work() / "results" / "000001"));
  EXPECT_EQ(run("batch submit --work work").exit_code, 0);
  EXPECT_TRUE(fs::exists(work() / "results" / "000001"));
}

// Who chose a cluster is not given this computer when the batch is submitted again.
TEST_F(Batch, SubmittedAgainItKeepsItsEngine) {
  const std::string nowhere = "PATH=/nowhere " + stanok_program + " ";
  const auto code_of = [&](const std::string& arguments) {
    const std::string line =
        "cd " + folder_.path().string() + " && " + nowhere + arguments + " 2>messages";
    return WEXITSTATUS(std::system(line.c_str()));
  };
  EXPECT_EQ(code_of("batch submit programs --work work --engine slurm " + machine()), 1);
  EXPECT_EQ(code_of("batch submit --work work"), 1);
  EXPECT_NE(text_of(folder_.path() / "messages").find("squeue"), std::string::npos);
  EXPECT_EQ(code_of("batch submit --work work --engine local"), 0);
  EXPECT_EQ(code_of("batch submit --work work"), 0);
}

TEST_F(Batch, WithoutSlurmItSaysWhatToInstall) {
  const std::string line = "cd " + folder_.path().string() + " && PATH=/nowhere " + stanok_program +
                           " batch submit programs --work elsewhere --engine slurm " + machine() +
                           " 2>messages";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 1);
  EXPECT_NE(text_of(folder_.path() / "messages").find("slurm-client"), std::string::npos);
}

TEST(BatchPlan, ChunksAreAHundredProgramsOrAThousandChunks) {
  EXPECT_EQ(usual_chunk(5), 100U);
  EXPECT_EQ(usual_chunk(100'000), 100U);
  EXPECT_EQ(usual_chunk(100'001), 101U);
  EXPECT_EQ(usual_chunk(1'000'000), 1000U);
}

TEST(BatchPlan, EveryProgramIsInOneChunk) {
  BatchPlan plan;
  plan.chunk = 3;
  for (int k = 0; k < 8; ++k) plan.candidates.programs.push_back({std::to_string(k), ""});
  std::string all;
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk) {
    for (const Candidate& program : plan.programs_of(chunk).programs) all += program.path;
    all += ' ';
  }
  EXPECT_EQ(all, "012 345 67 ");
}

TEST(Slurm, NumbersOfTasksAreRanges) {
  EXPECT_EQ(array_text({0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
  EXPECT_EQ(array_text({5}), "5");
}

TEST(Slurm, TheShellReadsAWordBack) {
  EXPECT_EQ(shell_word("/a b/it's"), "'/a b/it'\\''s'");
}

}  // namespace
}  // namespace stanok::client

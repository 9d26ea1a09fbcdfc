// Logs that are cut, damaged, or lack what their recorder was too late for: repeated as far as they
// are sound, and never reported as different.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "recording/log/log_check.h"
#include "runtime/replay.h"
#include "tests/runtime/recorded_by_chance.h"
#include "tests/support/sanitized.h"

namespace stanok::runtime {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// The log without its check events.
std::filesystem::path without_checks(const std::filesystem::path& log) {
  const std::filesystem::path copy = log.string() + ".old";
  std::ofstream file(copy, std::ios::binary);
  const auto put = [&](const auto& bytes) {
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  };
  auto reader = recording::LogReader::open(log);
  std::int64_t number = 0;
  while (const auto event = reader->next()) {
    if (recording::topic_of(event->channel) == recording::name_of(recording::Topic::log_check))
      continue;
    put(recording::event_header(number++, event->utime, event->channel.size(),
                                event->bytes.size()));
    put(event->channel);
    put(event->bytes);
  }
  return copy;
}

// What `log verify` makes of a file.
struct Judgement {
  bool is_same = false;
  bool differs = false;
  std::int64_t cycles = 0;
};

Judgement judgement_of(const std::filesystem::path& log) {
  try {
    const ReplayResult result = replay(log, {});
    return {result.is_same(), result.difference.has_value(), result.cycles};
  } catch (const std::runtime_error&) {
    return {};
  }
}

// Up to the cut everything is verified; the log as a whole is not.
TEST(Replay, OfALogThatWasCutGoesToTheCut) {
  const RecordedContour run(DriveChoice::ideal, 4, 1500);
  std::filesystem::resize_file(run.path(), std::filesystem::file_size(run.path()) / 2 + 11);
  const ReplayResult result = replay(run.path(), {});
  EXPECT_FALSE(result.difference);
  EXPECT_TRUE(result.is_cut);
  EXPECT_EQ(result.cycles, result.setpoints);
  EXPECT_GT(result.setpoints, 500);
  EXPECT_LT(result.setpoints, 1500);
  ASSERT_FALSE(result.remarks.empty());
  EXPECT_THAT(result.remarks.back(),
              HasSubstr("everything up to cycle " + std::to_string(result.cycles) + " is sound"));
}

// Cut between two events, as far as the machine is known: never a difference, never whole.
TEST(Replay, OfALogThatWasCutBetweenEventsSaysSo) {
  const RecordedContour run(DriveChoice::ideal, 12, 300);
  std::vector<std::int64_t> begins;
  auto reader = recording::LogReader::open(run.path());
  while (const auto event = reader->next()) begins.push_back(event->offset);
  int repeated = 0;
  constexpr std::size_t step = stanok::testing::is_sanitized ? 60 : 6;
  for (std::size_t k = begins.size(); k-- > 0; k -= std::min(k, step)) {
    std::filesystem::resize_file(run.path(), static_cast<std::uintmax_t>(begins[k]));
    const Judgement judgement = judgement_of(run.path());
    EXPECT_FALSE(judgement.is_same) << "cut before event " << k;
    EXPECT_FALSE(judgement.differs) << "cut before event " << k;
    repeated += judgement.cycles > 0 ? 1 : 0;
  }
  EXPECT_GT(repeated, stanok::testing::cases(10));
}

// Any byte: nothing of what is damaged is used, so that no difference is told that there was not.
TEST(Replay, NoticesAnyByteThatChanges) {
  RecordedContour run(DriveChoice::simulated, 13, 200);
  EXPECT_TRUE(judgement_of(run.path()).is_same);
  std::fstream file(run.path(), std::ios::binary | std::ios::in | std::ios::out);
  const auto size = static_cast<int>(std::filesystem::file_size(run.path()));
  for (int n = 0; n < stanok::testing::cases(200); ++n) {
    const int offset = run.chance(size);
    const auto put = [&](char byte) {
      file.seekp(offset);
      file.put(byte);
      file.flush();
    };
    file.seekg(offset);
    const char before = static_cast<char>(file.get());
    put(static_cast<char>(before ^ 1 << n % 8));
    const Judgement judgement = judgement_of(run.path());
    EXPECT_FALSE(judgement.is_same) << "byte " << offset;
    EXPECT_FALSE(judgement.differs) << "byte " << offset;
    put(before);
  }
  EXPECT_TRUE(judgement_of(run.path()).is_same);
}

// As stanok 0.1.0 made them.
TEST(Replay, OfALogWithoutCheckSumsSaysWhatIsNotCovered) {
  const RecordedContour run(DriveChoice::ideal, 14, 500);
  const ReplayResult result = replay(without_checks(run.path()), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_FALSE(result.has_checks);
  EXPECT_EQ(result.cycles, 500);
  EXPECT_THAT(result.remarks, Contains(HasSubstr("without checksums")));
}

TEST(Replay, OfALogOfAnotherVersionSaysSo) {
  const RecordedContour run(DriveChoice::ideal, 14, 500);
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_THAT(result.remarks, Contains(HasSubstr("recorded by stanok test")));
}

// More inputs in one cycle than the ring of the recorder holds: the same up to there, and no word
// of a difference.
TEST(Replay, OfALogThatLacksInputsGoesToTheLoss) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 8);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(1000);
  for (int n = 0; n < 5000; ++n) run.ask(OperatorAction::override_feed, 1, "", 0.5 + 0.0001 * n);
  run.run(1000);
  EXPECT_THAT(run.closing_word(), HasSubstr("W720"));
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_FALSE(result.difference);
  EXPECT_FALSE(result.is_same());
  EXPECT_EQ(result.lost_cycle, 1001);
  EXPECT_EQ(result.cycles, 1000);
  EXPECT_THAT(result.remarks, Contains(HasSubstr("W720")));
}

// The same of a log whose last record says so.
TEST(Replay, OfALogThatEndsWithALossSaysSo) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 9);
  run.run(100);
  run.close();
  const auto copy = changed<log_meta_t>(
      run.path(), recording::Topic::log_meta, [](log_meta_t&) {},
      [](recording::MessageStream& stream) {
        stream.input({.cycle = 101, .content = channels::LostInputs{}});
      });
  const ReplayResult result = replay(copy, {});
  EXPECT_FALSE(result.difference);
  EXPECT_EQ(result.lost_cycle, 101);
  EXPECT_EQ(result.cycles, 100);
}

// What the recorder was too late for is computed again: both sides of each gap are compared.
TEST(Replay, OfALogThatLacksSetpointsComparesAllTheOthers) {
  for (const DriveChoice drives : {DriveChoice::ideal, DriveChoice::simulated}) {
    RecordedByChance run("mill3.toml", drives, 10);
    run.program("contour.nc", contour);
    run.ask(OperatorAction::program_run, 1, "contour.nc");
    run.run(60);
    std::int64_t cycle = 60;
    std::int64_t missing = 0;
    std::vector<SetpointGap> lost;
    for (int gap = 0; gap < 50; ++gap) {
      const int length = 1 + run.chance(40);
      run.ask(OperatorAction::override_feed, 1, "", 0.5 + 0.01 * gap);
      run.lose_outputs(length);
      lost.push_back({cycle + 1, cycle + length});
      missing += length;
      const int between = 1 + run.chance(60);
      run.run(between);
      cycle += length + between;
    }
    run.close();
    EXPECT_TRUE(run.moved());
    const ReplayResult result = replay(run.path(), {});
    EXPECT_FALSE(result.difference) << result.difference->field;
    EXPECT_TRUE(result.is_same());
    EXPECT_EQ(result.cycles, cycle);
    EXPECT_EQ(result.setpoints, cycle - missing);
    ASSERT_EQ(result.gaps.size(), lost.size());
    for (std::size_t k = 0; k < lost.size(); ++k) {
      EXPECT_EQ(result.gaps[k].first, lost[k].first);
      EXPECT_EQ(result.gaps[k].last, lost[k].last);
    }
    EXPECT_THAT(result.remarks, Contains(HasSubstr("no setpoints of cycles 61 to")));
  }
}

// The setpoints of 0.1.0 took inputs with them.
TEST(Replay, OfALogOfTheFirstVersionThatLacksSetpointsGoesToTheGap) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 10);
  run.run(60);
  run.lose_outputs(5);
  run.run(40);
  run.close();
  const ReplayResult result = replay(without_checks(run.path()), {});
  EXPECT_FALSE(result.difference);
  EXPECT_EQ(result.lost_cycle, 61);
  EXPECT_EQ(result.cycles, 60);
}

}  // namespace
}  // namespace stanok::runtime

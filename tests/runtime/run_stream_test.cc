// A log read by a thread of its own: parts in order, programs when they are asked for.
#include "runtime/run_stream.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/runtime/recorded_by_chance.h"

namespace stanok::runtime {
namespace {

using channels::OperatorAction;

program_read_t asked(const std::string& name, const std::string& text, bool found = true) {
  return recording::to_program_read(
      {.name = name, .path = "/" + name, .text = text, .found = found}, {});
}

TEST(RecordedFiles, AnswerTheSameQuestionAsInTheRecordedRun) {
  RecordedFiles files;
  files.add_text(recording::text_hash("one"), "one");
  files.add_text(recording::text_hash("two"), "two");
  files.add(asked("a.nc", "one"));
  files.add(asked("a.nc", "two"));
  files.add(asked("a.nc", "", false));
  EXPECT_EQ((*files.read("a.nc", ""))->text, "one");
  EXPECT_EQ((*files.read("a.nc", ""))->text, "two");
  EXPECT_EQ(files.read("a.nc", "").error().code, "E7001");
}

TEST(RecordedFiles, WhoAsksWaitsForWhatIsStillRead) {
  RecordedFiles files;
  std::atomic<bool> is_answered = false;
  std::string found;
  std::jthread asker([&] {
    found = (*files.read("a.nc", ""))->text;
    is_answered = true;
  });
  while (!files.is_awaited()) std::this_thread::yield();
  files.add(asked("a.nc", "one"));
  EXPECT_FALSE(is_answered) << "the text itself is not there yet";
  files.add_text(recording::text_hash("one"), "one");
  asker.join();
  EXPECT_EQ(found, "one");
  EXPECT_FALSE(files.is_awaited());
}

TEST(RecordedFiles, WhatNeverComesWasNotFound) {
  RecordedFiles files;
  std::jthread asker([&] { EXPECT_EQ(files.read("a.nc", "").error().code, "E7001"); });
  while (!files.is_awaited()) std::this_thread::yield();
  files.finish();
}

TEST(RunStream, HandsOutEverySetpointInItsOrder) {
  RecordedContour recorded(DriveChoice::simulated, 3, 4000);
  RunStream stream(recorded.path());
  EXPECT_EQ(stream.beginning().machine.machine.name, "mill3");
  std::int64_t cycle = 0;
  std::int64_t bytes = 0;
  std::size_t feedback = 0;
  while (const auto part = stream.next()) {
    EXPECT_TRUE(part->is_checked);
    EXPECT_GE(part->bytes_read, bytes);
    bytes = part->bytes_read;
    feedback += part->feedback.size();
    for (const setpoint_t& setpoint : part->setpoints) EXPECT_EQ(setpoint.cycle, ++cycle);
  }
  EXPECT_EQ(cycle, 4000);
  EXPECT_GT(feedback, 500U);
  EXPECT_TRUE(stream.contents().is_sound());
  EXPECT_FALSE(stream.next());
}

// More setpoints stand before the text than are read ahead.
TEST(RunStream, ReadsOnToAProgramThatIsAskedFor) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 1);
  run.run(40'000);
  run.program("late.nc", "G0 X1\nM30\n");
  run.ask(OperatorAction::program_run, 1, "late.nc");
  run.run(300);
  run.close();
  RunStream stream(run.path());
  EXPECT_EQ((*stream.files()->read("late.nc", ""))->text, "G0 X1\nM30\n");
  std::size_t setpoints = 0;
  while (const auto part = stream.next()) setpoints += part->setpoints.size();
  EXPECT_EQ(setpoints, 40'300U);
}

TEST(RunStream, MayBeGivenUpAnywhere) {
  RecordedContour recorded(DriveChoice::ideal, 4, 40'000);
  for (int parts = 0; parts < 3; ++parts) {
    RunStream stream(recorded.path());
    for (int k = 0; k < parts; ++k) EXPECT_TRUE(stream.next());
  }
  RunStream unread(recorded.path());
  EXPECT_TRUE(unread.contents().is_sound());
}

}  // namespace
}  // namespace stanok::runtime

// A part that is cut while an operator holds the program, leads the tool back along the path and
// away from it, and returns: it is the part that nobody has touched, no move by hand cuts anything,
// and the log repeats all of it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "runtime/replay.h"
#include "runtime/workpiece/simulated_workpieces.h"
#include "tests/runtime/recorded_by_chance.h"

namespace stanok::runtime {
namespace {

struct PartCase {
  const char* machine;
  const char* program;
  const char* axis;  // whose positive sense leads away from the part
};

// The example with a coarser workpiece.
std::string coarse(const char* example) {
  std::ifstream file(source_tree / "programs" / "examples" / example);
  std::stringstream all;
  all << file.rdbuf();
  std::string text = all.str();
  const std::size_t at = text.find(", 0.2,", text.find("#workpiece"));
  return text.replace(at, 6, ", 0.5,");
}

class PartInHands {
 public:
  PartInHands(const PartCase& part, std::uint64_t seed)
      : part_(part),
        run_(part.machine, DriveChoice::ideal, seed),
        workpieces_(run_.file(), memory_max, complain) {
    run_.watch([this](const channels::CycleOutput& output) { look(output); },
               [](const channels::Event&) {});
    run_.program("part.nc", coarse(part.program));
    run_.run(300);
    run_.ask(OperatorAction::program_run, 1, "part.nc");
    for (int n = 0; n < 1000 && !channel_.running; ++n) run_.run(10);
  }

  void finish() {
    for (int n = 0; n < 4000 && channel_.running; ++n) run_.run(100);
    EXPECT_FALSE(channel_.running);
    run_.close();
  }
  void use_hands() {
    run_.ask(OperatorAction::program_hold, 1);
    run_.run(500);
    if (!channel_.running) return;
    for (int acts = 1 + run_.chance(4); acts > 0; --acts) {
      const double before = removed();
      if (run_.chance(3) == 0) {
        run_.ask(OperatorAction::jog, 1, part_.axis, 50.0, 0.1 + run_.chance(100) * 0.1);
      } else {
        retrace();
      }
      run_.run(200 + run_.chance(1500));
      EXPECT_NEAR(removed(), before, chords_mm3) << "cut by hand";
    }
    for (int n = 0; n < 600 && channel_.moving; ++n) run_.run(100);
    run_.ask(OperatorAction::program_return, 1, "", 50.0);
    for (int n = 0; n < 600 && (channel_.aside || channel_.moving); ++n) run_.run(100);
    EXPECT_FALSE(channel_.aside);
    run_.ask(OperatorAction::program_resume, 1);
    run_.run(1);
  }
  void run(int cycles) { run_.run(cycles); }
  [[nodiscard]] int chance(int count) { return run_.chance(count); }
  [[nodiscard]] std::filesystem::path log() const { return run_.path(); }
  [[nodiscard]] int moved() const { return moved_; }

  // From the blank so far.
  [[nodiscard]] double removed() {
    simulation::WorkpieceFollower& follower = workpieces_.feeds().front()->follower();
    follower.flush();
    const simulation::Workpiece* const workpiece = follower.at_work();
    return workpiece == nullptr ? 0.0 : workpiece->report().removed_mm3();
  }
  [[nodiscard]] std::size_t findings() {
    return workpieces_.feeds().front()->follower().at_work()->report().findings().size();
  }

 private:
  static constexpr std::uint64_t memory_max = 500'000'000;
  // The workpiece is cut along chords of what the axes do: back along an arc these lie elsewhere.
  static constexpr double chords_mm3 = 0.5;
  static void complain(int /*channel*/, const std::string& code, const std::string& text) {
    ADD_FAILURE() << code << " " << text;
  }
  void retrace() {
    channels::OperatorEvent event;
    event.channel = 1;
    event.command =
        channels::commands::ProgramRetrace{run_.chance(3) == 0 ? channels::RetraceDirection::forward
                                                               : channels::RetraceDirection::back,
                                           0.1 + 0.1 * run_.chance(400)};
    run_.ask(event);
  }
  void look(const channels::CycleOutput& output) {
    workpieces_.observe(output);
    channel_ = output.channels[0];
    if (channel_.aside && channel_.moving) ++moved_;
  }

  PartCase part_;
  RecordedByChance run_;
  SimulatedWorkpieces workpieces_;
  channels::ChannelOutput channel_;
  int moved_ = 0;  // cycles, by hand
};

class HandsOnPart : public ::testing::TestWithParam<PartCase> {};

TEST_P(HandsOnPart, ItIsCutAsIfNobodyHadTouchedIt) {
  PartInHands untouched(GetParam(), 1);
  untouched.finish();
  PartInHands touched(GetParam(), 2);
  for (int holds = 0; holds < 12; ++holds) {
    touched.run(500 + touched.chance(4000));
    touched.use_hands();
  }
  touched.finish();
  EXPECT_GT(touched.moved(), 1000);
  EXPECT_GT(untouched.removed(), 1000.0);
  EXPECT_NEAR(touched.removed(), untouched.removed(), 1e-4 * untouched.removed());
  EXPECT_EQ(touched.findings(), untouched.findings());
  EXPECT_TRUE(replay(touched.log(), {}).is_same());
}

INSTANTIATE_TEST_SUITE_P(All, HandsOnPart,
                         ::testing::Values(PartCase{"e7106mf4.toml", "workpiece.nc", "Z"},
                                           PartCase{"lathe.toml", "turned_part.nc", "X"}),
                         [](const auto& part) {
                           return std::string(part.param.machine).substr(0, 5);
                         });

}  // namespace
}  // namespace stanok::runtime

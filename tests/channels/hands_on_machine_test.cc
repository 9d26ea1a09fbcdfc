// Hands on a machine: programs that are held again and again, and what an operator does meanwhile,
// in any order: jogs, the handwheel, ways back along the path, spindle and coolant, lengths of the
// tool, MDI, returns that are broken off. The program goes on as if nobody had touched it, beside
// the path before by just what the lengths have changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "tests/support/machine/held_program.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using testing::HeldCase;
using testing::HeldProgram;
using Places = HeldProgram::Places;

class Hands {
 public:
  Hands(const HeldCase& at, HeldProgram& scene) : at_(at), scene_(scene) {}

  void act() {
    switch (scene_.pick(0, 9)) {
      case 0:
      case 1:
        return scene_.jog();
      case 2:
        return scene_.turn_wheel();
      case 3:
      case 4:
        return scene_.retrace();
      case 5:
        return switch_off();
      case 6:
      case 7:
        return change_length();
      case 8:
        return ask_for_a_line();
      default:
        return break_off_return();
    }
  }

  [[nodiscard]] const Places& beside() const { return beside_; }
  // Since it was asked last they have switched the spindle off.
  [[nodiscard]] bool takes_off() { return std::exchange(is_off_, false); }
  [[nodiscard]] int lengths() const { return lengths_; }

 private:
  void switch_off() {
    is_off_ = true;
    static_cast<void>(scene_.code_of(commands::SpindleSwitch{Switch::off}));
    static_cast<void>(scene_.code_of(commands::CoolantSwitch{Switch::off}));
  }
  void change_length() {
    if (at_.keys.empty()) return;
    const auto& [key, axis] =
        at_.keys[static_cast<std::size_t>(scene_.pick(0, 99)) % at_.keys.size()];
    const double longer = scene_.real(-1.0, 1.0);
    const Places standing = scene_.axes();
    const std::string code =
        scene_.pick(0, 1) == 0 ? scene_.change(key, longer) : scene_.touch(key, axis, longer);
    if (!code.empty()) {
      EXPECT_EQ(code, "E6097") << "only on the way back along the path";
      return;
    }
    for (int n = 0; n < 20; ++n) scene_.cycle();
    EXPECT_EQ(scene_.axes(), standing) << "the axes stay until they are led";
    beside_[axis] += longer;
    ++lengths_;
  }
  void ask_for_a_line() {
    const Places standing = scene_.axes();
    scene_.bench.ask(OperatorAction::mdi, 1, "G91 G1 X5 F500");
    for (int n = 0; n < 100; ++n) scene_.cycle();
    EXPECT_EQ(scene_.bench.replies().back().code.view(), "E6003");
    EXPECT_EQ(scene_.axes(), standing);
  }
  void break_off_return() {
    if (!scene_.bench.channel(1).aside) return;
    scene_.bench.ask(OperatorAction::program_return, 1, "", scene_.real(2.0, 80.0));
    for (int n = scene_.pick(1, 400); n > 0; --n) scene_.cycle();
    scene_.bench.ask(OperatorAction::program_hold, 1);
    scene_.cycle();
    scene_.rest();
  }

  const HeldCase& at_;
  HeldProgram& scene_;
  Places beside_{};
  bool is_off_ = false;
  int lengths_ = 0;
};

void expect_beside(const std::vector<Places>& course, const std::vector<Places>& untouched,
                   const Places& by) {
  ASSERT_EQ(course.size(), untouched.size());
  for (std::size_t n = 0; n < course.size(); ++n) {
    for (std::size_t k = 0; k < by.size(); ++k)
      ASSERT_NEAR(course[n][k], untouched[n][k] + by[k], 1e-9) << n << " " << k;
  }
}

class HandsOnMachine : public ::testing::TestWithParam<HeldCase> {};

TEST_P(HandsOnMachine, LeaveThePathAsItIs) {
  const unsigned seeds = testing::is_sanitized ? 4 : 250;
  int held = 0;
  int lengths = 0;
  int retraced = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    HeldProgram untouched(GetParam(), seed);
    HeldProgram scene(GetParam(), seed);
    Hands hands(GetParam(), scene);
    for (int holds = scene.pick(1, 3); holds > 0; --holds) {
      const int after = scene.pick(100, 3000);
      for (HeldProgram* one : {&untouched, &scene}) {
        static_cast<void>(one->take_course());
        one->go_on(after);
        one->hold();
      }
      expect_beside(scene.take_course(), untouched.take_course(), hands.beside());
      if (::testing::Test::HasFatalFailure() || !scene.bench.channel(1).running) break;
      ++held;
      const double turned = scene.bench.channel(1).process.spindles[0].target_rev_per_min;
      for (int acts = scene.pick(1, 8); acts > 0; --acts) hands.act();
      const bool is_aside = scene.bench.channel(1).aside;
      scene.come_back();
      if (is_aside && hands.takes_off()) {
        EXPECT_EQ(scene.bench.channel(1).process.spindles[0].rev_per_min, turned);
      }
      expect_beside({scene.axes()}, {untouched.axes()}, hands.beside());
    }
    for (HeldProgram* one : {&untouched, &scene}) {
      static_cast<void>(one->take_course());
      one->go_on(1'000'000);
      EXPECT_FALSE(one->bench.channel(1).running);
    }
    expect_beside(scene.take_course(), untouched.take_course(), hands.beside());
    EXPECT_EQ(scene.bench.alarm_codes(), std::vector<std::string>());
    if (HasFailure()) return;
    lengths += hands.lengths();
    retraced += scene.retraced();
  }
  EXPECT_GE(2 * held, static_cast<int>(seeds));
  EXPECT_GE(retraced, static_cast<int>(seeds) / 8);
  if (!GetParam().keys.empty()) {
    EXPECT_GT(lengths, static_cast<int>(seeds) / 2);
  }
}

INSTANTIATE_TEST_SUITE_P(All, HandsOnMachine,
                         ::testing::Values(testing::held_mill(), testing::held_five_axes(),
                                           testing::held_led_point(), testing::held_lathe()),
                         [](const auto& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace stanok::channels

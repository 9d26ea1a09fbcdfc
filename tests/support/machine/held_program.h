// HeldProgram: a random program on a machine in memory, held and gone on with, and hands that do
// something meanwhile; for tests that compare it with one that nobody has touched.
//
// Every cycle is looked at: no axis leaves its limits of velocity, acceleration and jerk.
#pragma once

#include <array>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {

struct HeldCase {
  const char* name;
  channels::MachineConfig (*machine)();
  std::string head;  // of the program; behind it a feed of 3000 mm/min
  const char* coordinates;
  std::array<const char*, 3> jogged;
  // Values of a tool, and the axis that they move, by its place in the channel.
  std::vector<std::pair<const char*, std::size_t>> keys;
};

// Scheme 2 of two_channel_machine().
[[nodiscard]] channels::MachineConfig five_axis_machine();

// Of the machines of machine_bench.h; in the last but one the scheme leads the point of the tool,
// whose length does not change there.
[[nodiscard]] HeldCase held_mill();
[[nodiscard]] HeldCase held_five_axes();
[[nodiscard]] HeldCase held_led_point();
[[nodiscard]] HeldCase held_lathe();

class HeldProgram {
 public:
  static constexpr std::size_t axis_count = 5;
  using Places = std::array<double, axis_count>;

  // Values of tool 1 are 40 mm, and 0.125 mm of wear.
  HeldProgram(const HeldCase& at, unsigned seed);

  [[nodiscard]] int pick(int low, int high);
  [[nodiscard]] double real(double low, double high);

  // Of the channel; spindles are 0.
  [[nodiscard]] Places axes() const;

  // One cycle; places that differ from the one before are kept in the course.
  void cycle();
  // Begins the program, or goes on with it, until its path has moved in so many cycles or nothing
  // runs any more; goes on at M0, and where a length has changed behind the path.
  void go_on(int cycles);
  void hold();
  void rest();  // until nothing moves

  // The code of the answer; "": it was done.
  [[nodiscard]] std::string code_of(const channels::OperatorCommand& command);
  void set(const char* key, double value, int tool = 1);
  [[nodiscard]] std::string change(const char* key, double by, int tool = 1);
  // The same by touching off, where the point of tool 1 stands, along an axis; wear is changed.
  [[nodiscard]] std::string touch(const char* key, std::size_t axis, double by);
  // What hands do of themselves, each a few times or not, as chance has it; they come to rest. A
  // way that is not free, or leads out of the travel, is refused.
  void jog(const char* axis, double way);
  void jog();
  void turn_wheel();
  void retrace();
  // Back to the path, whatever has happened meanwhile.
  void come_back();

  // Places since it was asked last.
  [[nodiscard]] std::vector<Places> take_course() { return std::exchange(course_, {}); }
  // Moves along the path that were done by hand.
  [[nodiscard]] int retraced() const { return retraced_; }

 private:
  void look();
  void expect_done_or(std::initializer_list<std::string_view> codes, const std::string& code,
                      const char* what);

  const HeldCase at_;
  std::mt19937 random_;
  std::map<std::pair<int, std::string>, double> values_;
  std::vector<Places> course_;
  std::array<Places, 4> newest_{};  // the last cycles, the newest first
  int cycles_ = 0;
  int retraced_ = 0;
  bool has_begun_ = false;

 public:
  MachineBench bench;
};

}  // namespace stanok::testing

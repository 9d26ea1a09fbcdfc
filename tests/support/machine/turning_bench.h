// Cuts on a lathe in memory: the cycles of a cut, and the time that a cut should take.
//
// The axes are so strong that their ramps do not show, the spindle has every speed at once: what a
// law or a cutting speed asks for is then exact, and can be added up.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "channels/contract/output.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::testing {

// Whether the feed of a cut is per revolution, as tables of cuts write it.
inline constexpr bool per_min = false;
inline constexpr bool per_rev = true;

// A word of a program behind those before it, " v_k=120"; "" where the value is 0.
[[nodiscard]] std::string word_unless_zero(const char* name, double value);

// turning_machine() with spindle 1 from `speed_min` to 3000 rev/min; `acceleration` in rev/min/s,
// 0: every speed at once.
[[nodiscard]] channels::MachineConfig lathe_with_spindle(double speed_min, double acceleration);

// The same with every speed at once, and axes of 10 m/s, 10^9 mm/s2, 10^13 mm/s3.
[[nodiscard]] channels::MachineConfig strong_lathe(double speed_min);

// One cycle of a cut.
struct CutCycle {
  double time_s = 0.0;  // from its beginning
  double way = 0.0;     // along the path
  double x = 0.0;       // radius
  double z = 0.0;
  channels::ProcessOutput process;
  bool is_last = false;  // the tool has come to rest
};

// Runs a program and gives the cycles of its one motion at feed, the last of them at its end.
[[nodiscard]] std::vector<CutCycle> cycles_of_cut(MachineBench& bench, const std::string& program);

// What a cut should do: feeds along the path, added up one part after another.
class CutTime {
 public:
  // A further part of the way; `feed` in mm/min at a place of this part.
  void add(double way, const std::function<double(double)>& feed);
  void add(double way, double feed_per_min) {
    add(way, [feed_per_min](double) { return feed_per_min; });
  }

  [[nodiscard]] double total() const { return nodes_.back().time; }
  [[nodiscard]] double way() const { return nodes_.back().way; }
  [[nodiscard]] double at(double way) const;
  // All rises and falls of the feed, in mm/s.
  [[nodiscard]] double variation() const { return variation_; }

 private:
  struct Node {
    double way = 0.0;
    double time = 0.0;
  };
  std::vector<Node> nodes_{{}};
  double feed_ = 0.0;
  double variation_ = 0.0;
};

// What a feed follows. That of a revolution has the speed of the spindle at the beginning of each
// cycle, so that behind a change of the speed the path is late, by a cycle at most.
enum class FeedOf { time, revolution };

// A cut takes the time it should, within one cycle, and is at any time where it should be, within
// one increment, beside what `feed_of` allows.
void expect_cut(const std::vector<CutCycle>& cycles, const CutTime& wanted, FeedOf feed_of);

// n = 1000 v / (pi D), between two limits.
[[nodiscard]] double speed_of_cut(double m_per_min, double diameter, double n_min, double n_max);

}  // namespace stanok::testing

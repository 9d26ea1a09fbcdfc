// AutomaticFeed: a feed law that the cycle forms by itself from a signal of the process.
//
// The modulated law acts while the vibration is too strong: the feed goes down from the programmed
// one and up again in steps along the path, until the vibration is gone. The linear law follows a
// feedback, as the power of the spindle: along each step of path the feed falls by one increment
// while the signal is too high and rises again while it is low. Both only take away from the
// programmed feed. Source: the paper of docs/programmer/feed-laws.md, table of modules ("formed
// automatically by the level of vibration", "with a feedback"). Real-time.
#pragma once

#include <cstdint>
#include <optional>

#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::motion {

// States of a module of the feed.
enum class ModuleState : std::uint8_t {
  reset,    // off
  ready,    // on; the programmed feed holds
  running,  // changes the feed
  fault,    // its sensor gives no value: the feed is the smallest one until it is switched again
};

struct AutomaticFeedConfig {
  LawKind law = LawKind::none;  // modulated or linear; none: there is no such module
  double level = 0.0;           // of the signal, in its unit: above it the law acts
  double release = 0.0;         // below it the law lets go; <= level
  double part_min = 1.0;        // smallest feed, part of the programmed one
  double part_step = 0.1;       // of one increment
  double path_step_mm = 0.1;    // path between two increments
  bool on_at_start = false;
};

class AutomaticFeed {
 public:
  AutomaticFeed() = default;
  explicit AutomaticFeed(const AutomaticFeedConfig& config);

  void switch_on() RT_SAFE { begin(ModuleState::ready); }
  void switch_off() RT_SAFE { begin(ModuleState::reset); }
  // A module that is on begins anew.
  void restart() RT_SAFE { begin(state_ == ModuleState::reset ? state_ : ModuleState::ready); }

  // Once a cycle: the signal, or nothing when its sensor gives none, and the path at feed that the
  // cycle before went, in mm.
  void advance(std::optional<double> signal, double path_mm) RT_SAFE;

  // The part of the programmed feed, from part_min to 1.
  [[nodiscard]] double part() const RT_SAFE { return part_; }
  [[nodiscard]] ModuleState state() const RT_SAFE { return state_; }
  [[nodiscard]] std::uint64_t increments() const RT_SAFE { return increments_; }  // since it runs
  [[nodiscard]] const AutomaticFeedConfig& config() const RT_SAFE { return config_; }

 private:
  // At the programmed feed; where there is no such module, it stays off.
  void begin(ModuleState state) RT_SAFE;
  void modulate(double signal) RT_SAFE;
  void follow(double signal, std::uint64_t steps) RT_SAFE;

  AutomaticFeedConfig config_;
  ModuleState state_ = ModuleState::reset;
  double part_ = 1.0;
  double path_mm_ = 0.0;  // since it runs
  std::uint64_t increments_ = 0;
};

}  // namespace stanok::motion

// ProcessPreparation: what feed and spindle do along the blocks of a channel.
//
// Resolves the feed mode (G93, G94, G95), constant cutting speed (G96) and feed laws into the feed
// and the process of each block. Owner: the channel's preparation.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "channels/contract/machine_config.h"
#include "lang/contract/command.h"
#include "motion/feed_laws/feed_law.h"
#include "motion/path/path.h"

namespace stanok::channels {

class ProcessPreparation {
 public:
  ProcessPreparation(const MachineConfig& machine, const ChannelConfig& channel);

  // No law holds any more; those given out before become invalid. The spindle turns on.
  void forget_laws();
  // The same, and the spindle stands.
  void reset();

  // The speed of the master spindle in rev/min; 0: it stands, or follows the diameter.
  [[nodiscard]] double steady_speed() const {
    return spindle_turns_ && cutting_speed_ <= 0.0 ? spindle_rev_per_min_ : 0.0;
  }

  // Takes over what a command sets up for the motion after it; others are ignored. `diameter_mm`:
  // at which the tool stands.
  void take_state(const lang::Payload& command, double diameter_mm);

  // The length of a block in its own metric, and the smallest diameter that it comes to. Laws hold
  // for ways in mm: a block of rotary axes alone has its feed F, a tap that of its lead, and the
  // path of a law does not count them.
  struct Travel {
    double length = 0.0;
    bool in_mm = true;
    double diameter_min_mm = 0.0;
  };
  // Gives a block its feed and process, or says why it has none.
  [[nodiscard]] std::optional<Diagnostic> apply(const lang::Move& move, const Travel& travel,
                                                motion::PathBlock& block);

 private:
  struct Law {
    const motion::FeedLaw* law = nullptr;
    double path_start = 0.0;
    bool is_modal = false;
  };
  void take_spindle(const lang::SpindleCommand& command);
  void take_law(const lang::FeedLawChange& change);
  [[nodiscard]] bool is_master(int spindle) const { return spindle <= 0 || spindle == master_; }
  [[nodiscard]] Expected<Law, Diagnostic> law_of(double length);
  [[nodiscard]] std::optional<Diagnostic> apply_law(const Law& law, const Travel& travel,
                                                    motion::PathBlock& block);
  [[nodiscard]] double rev_per_min(double diameter_mm) const;
  [[nodiscard]] double rev_per_min(double cutting_speed, double diameter_mm) const;

  double increment_mm_ = 0.0;  // Z0
  int master_ = 0;             // id of the master spindle: its speeds are meant below
  double speed_min_ = 0.0;     // rev/min
  double speed_max_ = 0.0;

  bool spindle_turns_ = false;
  double spindle_rev_per_min_ = 0.0;
  double cutting_speed_ = 0.0;  // G96, m/min; 0: off
  double speed_limit_ = 0.0;    // of G96; 0: none

  std::deque<std::unique_ptr<const motion::FeedLaw>> laws_;
  lang::FeedLaw modal_;
  const motion::FeedLaw* modal_law_ = nullptr;  // made from `modal_`
  double modal_path_ = 0.0;                     // that it has run
  std::optional<lang::FeedLaw> of_block_;
};

}  // namespace stanok::channels

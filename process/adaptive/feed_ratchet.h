// FeedRatchet: the feed rises at most one step above the last one to which the power has answered.
//
// A dead sensor may show anything but an answer, so that each rise of the feed is a question: the
// mean of the force before it, of the force after it, and at least half of the rise that the feed
// demands, y ln (h / h_0). The means are taken over stretches so long that chance makes half an
// answer in one of a hundred thousand (`MeanNoise`). Where there is no answer the feed goes back,
// and the force is measured once more: an answer that a cut becoming lighter had hidden shows
// against the mean of both. A question without an answer is a refusal; the next one is asked over
// twice the time, and after three the power is stuck. Once a minute of steady cut the question may
// be asked downwards, by less feed. So the force of a cut that does not change rises by one step at
// most whatever the sensor shows (docs/process/dead-sensors.md).
//
// Part of the process observer of a channel, in the cycle; allocates nothing. Invariant: the
// ceiling is `feed_step` over the confirmed feed at most.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "process/adaptive/force_control_config.h"
#include "process/adaptive/mean_noise.h"

namespace stanok::process {

// Means over a stretch of a cut.
struct Measured {
  double feed = 0.0;  // mm/rev
  double force_n = 0.0;
};

class FeedRatchet {
 public:
  explicit FeedRatchet(const ForceControlConfig& config) : config_(config) {}

  struct Inputs {
    double cycle_s = 0.001;
    double force_n = 0.0;     // measured
    double wanted_n = 0.0;    // the setpoint
    double count_n = 0.0;     // the smallest step of what is measured
    double feed = 0.0;        // h that the controller asks for, mm/rev
    double feed_max = 0.0;    // that others allow
    double settling_s = 0.1;  // of chip and sensor, to a change of the feed
    bool follows = false;     // the path goes at the feed asked for
  };
  // Each cycle in the cut. False: three refusals, one after the other.
  [[nodiscard]] bool look(const Inputs& inputs) RT_SAFE;
  // Out of the cut, where no power answers. What is confirmed stays: a dead power that comes and
  // goes about that of the air would raise the feed step by step otherwise.
  void leave_cut() RT_SAFE;
  // Another setpoint of the force, and with it another feed.
  void scale(double factor) RT_SAFE;

  // What the feed may be, mm/rev.
  [[nodiscard]] double ceiling() const RT_SAFE;
  // Means of the last whole stretch, or of the first half second, second, two seconds, and so on;
  // 0: none yet in this cut.
  [[nodiscard]] Measured measured() const RT_SAFE { return measured_.means; }
  [[nodiscard]] double confirmed() const RT_SAFE { return confirmed_; }
  [[nodiscard]] int refusals() const RT_SAFE { return refusals_; }

 private:
  static constexpr double first_stretch_s = 0.5;

  // before: the mean at a feed that is confirmed. rising: the controller raises the feed. after:
  // the mean at that feed. again: the mean back at the feed confirmed. lowered: the mean at less
  // feed.
  enum class Phase { before, rising, after, again, lowered };
  class Stretch {
   public:
    void add(const Inputs& inputs) RT_SAFE;
    [[nodiscard]] double force_n() const RT_SAFE { return force_sum_ / time_s_; }
    [[nodiscard]] double feed() const RT_SAFE;  // geometric mean
    [[nodiscard]] double time_s() const RT_SAFE { return time_s_; }
    // It has stood for a while, as that of a sensor that is frozen, or there are enough of them.
    [[nodiscard]] bool has_values() const RT_SAFE;

   private:
    double force_sum_ = 0.0;
    double log_feed_sum_ = 0.0;
    double time_s_ = 0.0;
    double newest_n_ = 0.0;
    int changes_ = 0;
    double unchanged_s_ = 0.0;
  };

  void begin(Phase phase) RT_SAFE;
  void follow(const Inputs& inputs) RT_SAFE;
  void follow_down() RT_SAFE;
  [[nodiscard]] bool is_long_enough(const Stretch& stretch, double asked,
                                    const Inputs& inputs) const RT_SAFE;
  // ln of the force that the feed demands in `to` over that in `from`.
  [[nodiscard]] double asked(const Stretch& from, const Stretch& to) const RT_SAFE;
  // The feed has come as far up as it may.
  [[nodiscard]] bool is_up(const Inputs& inputs) const RT_SAFE;
  void measure(const Inputs& inputs) RT_SAFE;
  void measure_before(const Inputs& inputs) RT_SAFE;
  void rise(const Inputs& inputs) RT_SAFE;
  void measure_after(const Inputs& inputs) RT_SAFE;
  void measure_again(const Inputs& inputs) RT_SAFE;
  void measure_lowered(const Inputs& inputs) RT_SAFE;
  void confirm(const Stretch& at) RT_SAFE;

  ForceControlConfig config_;
  MeanNoise noise_;
  Phase phase_ = Phase::before;
  bool is_in_cut_ = false;
  double confirmed_ = 0.0;  // mm/rev, over all cuts; 0: none yet
  double top_ = 0.0;        // to which the feed has risen, or is lowered
  struct {
    double feed = 0.0;
    double force_n = 0.0;
  } smooth_;
  bool wants_more_ = false;
  double waits_s_ = 0.0;  // before what is measured counts; while the feed rises, since it last did
  std::optional<Stretch> before_;
  Stretch after_;
  Stretch now_;
  int refusals_ = 0;
  struct {
    Measured means;
    double next_s = first_stretch_s;  // of the stretch that is measured next
  } measured_;
  double since_answer_s_ = 0.0;
};

}  // namespace stanok::process

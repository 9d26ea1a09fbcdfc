// QuenchingLaw: the oscillation of the force that quenches the self-oscillation which is there now.
//
// A vibration that has come above its level and stays gets the force of equation (2) times a
// reserve (oscillation.h). From then on the law follows what the sensor shows, in the dead zone as
// well:
//  - the vibration stays in spite of the force: its amplitude and frequency now are those of the
//    law, whether they grow or fall later;
//  - it falls under the force, to the amplitude a, while the force moves the mass by B: then it
//    would have a_0 = sqrt(a^2 + 2 B^2) without (van der Pol), and the law has that;
//  - it has died out: what it would be without the force is not seen. The force falls, slowly at
//    first, until the vibration shows again;
//  - at another frequency it is another vibration;
//  - where the force has become that of a vibration within the permissible level, or the cut ends,
//    the law ends.
// A line at the frequency of the force itself is no vibration. Real-time.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "process/adaptive/oscillation.h"
#include "process/adaptive/vibration_amplifier.h"

namespace stanok::process {

class QuenchingLaw {
 public:
  // `reserve`: of the force over equation (2).
  explicit QuenchingLaw(double reserve) : reserve_(reserve) {}

  // Frequency of the force, and the reduced mass; 0: nothing is formed.
  void set(double mass_kg, double frequency_hz) RT_SAFE;
  [[nodiscard]] bool can_form() const RT_SAFE { return mass_kg_ > 0.0 && frequency_hz_ > 0.0; }
  [[nodiscard]] double mass_kg() const RT_SAFE { return mass_kg_; }

  struct Inputs {
    double cycle_s = 0.001;
    double revolution_s = 0.1;
    Vibration above{};      // behind the dead zone
    Vibration sensed{};     // in front of it
    double least_um = 0.0;  // below it a vibration needs no law
    Oscillation formed{};   // of the cycle before
    bool cuts = false;
  };
  void advance(const Inputs& inputs) RT_SAFE;

  [[nodiscard]] bool is_on() const RT_SAFE { return self_.amplitude_um > 0.0; }
  [[nodiscard]] Oscillation wanted(double revolution_s) const RT_SAFE;

 private:
  // Since when the vibration and the force have been about these.
  struct Steady {
    double amplitude_um = 0.0;
    double force_n = 0.0;
    double s = 0.0;
  };

  // What the vibration did under the force that is formed for it.
  enum class Response : std::uint8_t { not_seen, none, falls };

  void forget() RT_SAFE;
  void take(const Vibration& vibration, Response response) RT_SAFE;
  void begin(const Inputs& inputs) RT_SAFE;
  void follow(const Inputs& inputs) RT_SAFE;
  void meet(const Vibration& now, const Oscillation& formed) RT_SAFE;
  void fade(const Inputs& inputs) RT_SAFE;
  void watch_steadiness(const Vibration& vibration, double force_n, double cycle_s) RT_SAFE;
  [[nodiscard]] double moved_um(const Oscillation& formed) const RT_SAFE;

  double reserve_;
  double mass_kg_ = 0.0;
  double frequency_hz_ = 0.0;
  Vibration self_;  // what the force is formed for; 0: nothing
  Steady steady_;
  double cutting_s_ = 0.0;
  double above_s_ = 0.0;  // above the level without a law
  double quiet_s_ = 0.0;  // died out
  Response response_ = Response::not_seen;
};

}  // namespace stanok::process

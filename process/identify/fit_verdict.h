// Whether a model fits what was recorded, and what is wrong where it does not. Off line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stanok::process {

enum class Misfit : std::uint8_t {
  none,
  dead_sensor,  // the reading stands still while the spindle turns or the cut changes
  saturated,    // readings pile up at their greatest value
  coarse,       // the step of the readings is greater than their noise and matters
  steps,        // the force changes at a place: hardness, depth
  drift,        // the force grows or falls over the record: wear, warming up
  force_law,    // the force does not follow the thickness of the chip as the law says
  lag,          // after steps of the cut the power comes otherwise than behind one lag
  bounds,       // a figure is none of a cut
  open,         // the record leaves a figure open
};

enum class FitState : std::uint8_t {
  fits,
  widened,  // the intervals hold what the misfit may have done to the figures
  refused,  // the figures are not those of the cut
};

struct FitVerdict {
  FitState state = FitState::fits;
  Misfit kind = Misfit::none;
  std::string reason;  // "the model does not fit because ..."; empty: it fits
  std::string remedy;

  [[nodiscard]] bool is_refused() const { return state == FitState::refused; }
};

// dead_sensor, as faces write it.
[[nodiscard]] std::string_view name_of(Misfit kind);

// `because`: what was seen, as "the force changes by 25 % at Z -20.0".
[[nodiscard]] FitVerdict verdict(FitState state, Misfit kind, const std::string& because);

// A further verdict of the same fit. Where both say something, the reason is the first one.
void add_verdict(const FitVerdict& further, FitVerdict& to);

}  // namespace stanok::process

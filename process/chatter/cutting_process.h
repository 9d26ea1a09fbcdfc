// CuttingProcess: what a cut with regeneration depends on: machine, tool and engagement.
//
// Turning: one cutting edge, the force and the modes in the direction of the chip's thickness.
// Milling: teeth of even pitch between the angles at which they enter and leave the cut, measured
// from the normal of the feed in the sense of rotation; the feed is along x. Tangential force
// K_t b h, radial force K_r times that (Y. Altintas, E. Budak, Analytical Prediction of Stability
// Lobes in Milling, CIRP Annals 44 (1995) 357). Thrust and helix are left out.
#pragma once

#include <numbers>
#include <vector>

#include "process/chatter/vibration_mode.h"

namespace stanok::process {

enum class CutKind : std::uint8_t { turning, milling };

struct CuttingProcess {
  CutKind kind = CutKind::milling;
  double force_n_per_mm2 = 0.0;  // K_t; turning: of the force along the chip's thickness
  double radial_ratio = 0.0;     // K_r; milling only
  int teeth = 1;
  double entry_rad = 0.0;  // milling only
  double exit_rad = std::numbers::pi;
  std::vector<VibrationMode> modes_x;  // along the feed; turning: along the chip's thickness
  std::vector<VibrationMode> modes_y;  // across it; milling only
};

// Entry and exit of a cut of so much of the diameter's width.
enum class MillingSense : std::uint8_t { up, down };  // down: climb
void engage(CuttingProcess& process, MillingSense sense, double width_per_diameter);

}  // namespace stanok::process

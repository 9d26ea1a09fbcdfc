// CuttingProcess: what a cut with regeneration depends on: machine, tool and engagement.
//
// Grinding: layer of the part and the force normal to it. Turning: one cutting edge, the force and
// the modes in the direction of the chip's thickness. Milling: teeth of even pitch between the
// angles at which they enter and leave the cut, measured from the normal of the feed in the sense
// of rotation; the feed is along x. Tangential force K_t b h, radial force K_r times that (Y.
// Altintas, E. Budak, Analytical Prediction of Stability Lobes in Milling, CIRP Annals 44 (1995)
// 357). Lobes leave thrust and helix out.
#pragma once

#include <numbers>
#include <vector>

#include "process/chatter/vibration_mode.h"

namespace stanok::process {

enum class CutKind : std::uint8_t { turning, milling, grinding };

// Of plunge grinding: wheel and part, and where they touch (process/chatter/grinding_lobes.h).
struct GrindingContact {
  double part_radius_mm = 0.0;
  double wheel_radius_mm = 0.0;
  double wheel_rev_per_min = 0.0;
  double length_mm = 0.0;            // of the contact
  double stiffness_n_per_mm2 = 0.0;  // of the contact, for a unit of width; 0: rigid
  double grinding_ratio = 0.0;       // volume of part for one of wheel; 0: the wheel does not wear
};

struct CuttingProcess {
  CutKind kind = CutKind::milling;
  // K_t; turning: of the force along the chip's thickness; grinding: of the normal force of a
  // layer.
  double force_n_per_mm2 = 0.0;
  double radial_ratio = 0.0;  // K_r; milling only
  int teeth = 1;
  // Of the forces along a program alone (process/milling): edges that rub, and the helix.
  double edge_n_per_mm = 0.0;         // K_te
  double edge_radial_n_per_mm = 0.0;  // K_re
  double helix_rad = 0.0;
  double entry_rad = 0.0;  // milling only
  double exit_rad = std::numbers::pi;
  // Along the feed; turning: along the chip's thickness; grinding: along the infeed.
  std::vector<VibrationMode> modes_x;
  std::vector<VibrationMode> modes_y;  // across it; milling only
  GrindingContact grinding{};
};

// Entry and exit of a cut of so much of the diameter's width.
enum class MillingSense : std::uint8_t { up, down };  // down: climb
void engage(CuttingProcess& process, MillingSense sense, double width_per_diameter);

}  // namespace stanok::process

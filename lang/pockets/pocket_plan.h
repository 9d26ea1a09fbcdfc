// The ways of a tool that clears a pocket with islands, level by level the same.
//
// On each level the tool comes down at the start point, goes to the edge of where its middle may be
// and around all of it, then to and fro on lines `step` apart. Every way leads through that region,
// so that neither the outline nor an island is touched; a way from line to line goes along the edge
// that is cut already, and where that would be long the tool is lifted, and comes down on the edge.
// What lies between two lines less than a diameter apart, or between a line and the edge, is cut:
// nothing stays but what the radius of the tool leaves in corners. Plane coordinates, mm.
#pragma once

#include <cstdint>
#include <string>

#include "base/expected.h"
#include "lang/pockets/pocket_region.h"

namespace stanok::lang {

// An element of the outline, and the line of the program that has it.
struct OutlineElement {
  PlaneElement element;
  std::uint32_t line = 0;
};

enum class ScanLines : std::uint8_t { along_first, along_second };  // axes of the plane

struct PocketWish {
  std::vector<OutlineElement> outline;  // closed, the pocket on its left
  PlanePoint start;                     // where the tool comes down
  double radius_mm = 0.0;               // of the tool
  double finish_mm = 0.0;  // what stays at walls and islands for the last pass; 0: none
  double step_mm = 0.0;    // between lines
  ScanLines lines = ScanLines::along_first;
};

// Where the tool goes at feed without a stop; the first point is reached from above, or by the way
// before where that ends there.
using PocketWay = std::vector<PlanePoint>;

struct PocketPlan {
  std::vector<PocketWay> level;   // the first way begins at the start point
  std::vector<PocketWay> finish;  // behind the last level, in its depth
};

struct PocketFault {
  std::string message;
  std::string help;
  std::uint32_t line = 0;  // of the outline; 0: of the cycle
};

// The outline is no pocket, or the tool does not fit into it, not everywhere, or not from the start
// point.
[[nodiscard]] Expected<PocketPlan, PocketFault> plan_pocket(const PocketWish& wish);

}  // namespace stanok::lang

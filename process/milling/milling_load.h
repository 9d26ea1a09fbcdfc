// MillingLoad: force, torque and deflection of a milling tool while its teeth turn through what
// they meet at one place of the path.
//
// The edge between two heights takes a chip of the thickness h = f (v . N), f the feed per tooth, v
// the direction of the feed, N the normal of the tool's envelope; on it act the tangential force
// (K_t h + K_te) db and the radial one (K_r K_t h + K_re) db, db the length of the edge (Y.
// Altintas, Manufacturing Automation, 2nd ed. 2012, ch. 2.5). Heights lag behind the tip by the
// helix. The tool gives way by the compliance of its modes at rest. Forces are in the plane across
// the axis of the tool: x along the feed, y to its left, seen from the spindle. A pure function of
// its inputs.
#pragma once

#include <cstdint>
#include <vector>

#include "process/chatter/cutting_process.h"

namespace stanok::process {

// The edge between two heights of the tool, and where there is material in front of it.
struct EngagedSlice {
  double height_mm = 0.0;  // of its middle over the tip
  double width_mm = 0.0;   // along the axis
  double radius_mm = 0.0;
  double slope = 0.0;  // of the radius over the height: 0 on a cylinder
  // At equal angles from the left of the feed on, in the sense of rotation: 0 where it cuts air.
  std::vector<std::uint8_t> meets;
};

// Parts of the direction of the feed; their squares add up to 1.
struct FeedDirection {
  double across = 1.0;  // the axis of the tool
  double along = 0.0;   // towards the spindle
};

// Over one tooth period.
struct MillingForces {
  double mean_x_n = 0.0;
  double mean_y_n = 0.0;
  double peak_n = 0.0;         // of the resultant
  double torque_n_mm = 0.0;    // mean
  double deflection_mm = 0.0;  // greatest
};

class MillingLoad {
 public:
  MillingLoad(const CuttingProcess& process, const std::vector<EngagedSlice>& slices,
              const FeedDirection& feed);

  // With this feed per tooth, mm.
  [[nodiscard]] MillingForces at(double feed_per_tooth_mm) const;
  // The greatest feed per tooth whose peak force is at most that; 0: the edges alone take more;
  // infinity: nothing is cut.
  [[nodiscard]] double feed_of_peak(double peak_n) const;
  // Volume for a unit of feed: the area of the cut across the feed, mm2.
  [[nodiscard]] double area_mm2() const { return area_mm2_; }

 private:
  // With the teeth at one angle: what grows with the feed, per mm, and what the edges take.
  struct Step {
    double x = 0.0;
    double y = 0.0;
    double torque = 0.0;
    double edge_x = 0.0;
    double edge_y = 0.0;
    double edge_torque = 0.0;
  };

  std::vector<Step> steps_;
  double area_mm2_ = 0.0;
  double compliance_x_ = 0.0;  // mm/N
  double compliance_y_ = 0.0;
};

}  // namespace stanok::process

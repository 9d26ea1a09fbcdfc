// The load of a milling tool by the material that is in front of it on its virtual workpiece.
#pragma once

#include "process/chatter/cutting_process.h"
#include "process/milling/milling_load.h"
#include "simulation/workpiece_follower.h"

namespace stanok::jobs {

// Half the resolution of the workpiece in front of the tool (simulation/engagement.h), which goes
// in the unit direction `direction_K`. `follower` has a workpiece; what it followed so far is cut.
[[nodiscard]] process::MillingLoad load_ahead(simulation::WorkpieceFollower& follower,
                                              const simulation::WorkpieceFollower::ToolAtWork& tool,
                                              const simulation::Vector& direction_K,
                                              double rev_per_min,
                                              const process::CuttingProcess& cut);

}  // namespace stanok::jobs

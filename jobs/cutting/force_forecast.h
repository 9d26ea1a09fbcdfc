// Forces along a turning program before it is run, and the feeds that keep them at a set value.
//
// The program is interpreted, its tool led through the stock of [simulation.cutting] of the machine
// file: what each block meets is known then. Straight blocks at feed in X and Z that run once get
// feeds; others keep theirs.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "jobs/cutting/feed_plan.h"
#include "jobs/cutting/forecast_job.h"
#include "jobs/cutting/program_feeds.h"

namespace stanok::jobs {

struct ForecastRequest {
  ForecastJob job;
  double force_n = 0.0;
  double feed_min = 0.0;  // mm per turn; 0: a twentieth of the programmed feed
  double feed_max = 0.0;  // 0: the programmed feed
  // Of tool and part across the cut; 0: it is not known, and there is no deflection.
  double stiffness_n_per_um = 0.0;
};

// A place of the path.
struct ForcePlace {
  std::uint32_t line = 0;
  double path_mm = 0.0;  // at feed since the begin of the program
  double x_mm = 0.0;     // radius
  double z_mm = 0.0;
  double depth_mm = 0.0;
  double rev_per_min = 0.0;
  double feed_programmed = 0.0;  // mm per turn
  double force_programmed_n = 0.0;
  double feed = 0.0;  // planned
  double force_n = 0.0;
  double power_w = 0.0;        // of the planned cut, at the spindle
  double deflection_um = 0.0;  // under the planned force
};

struct ForceForecast {
  std::vector<ForcePlace> places;
  double time_programmed_s = 0.0;  // at feed
  double time_s = 0.0;
  std::map<std::uint32_t, std::vector<FedPoint>> lines;  // of the program text
};

// Throws std::runtime_error where something is wrong with the program, and where the machine file
// has no stock.
[[nodiscard]] ForceForecast forecast_forces(const ForecastRequest& request);

}  // namespace stanok::jobs

// Forces along a milling program before it is run, and the feeds that keep them at a set value.
//
// The program runs on the virtual clock and cuts its virtual workpiece; at places of the path the
// material in front of the tool is looked at (simulation/engagement.h), and the force follows from
// it (process/milling). Blocks of the main program at feed get one feed each, the least of all
// their places and passes; blocks whose F is an expression keep it.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "jobs/cutting/forecast_job.h"
#include "jobs/cutting/program_feeds.h"
#include "process/chatter/cutting_process.h"
#include "simulation/blank.h"

namespace stanok::jobs {

struct MillingRequest {
  ForecastJob job;
  process::CuttingProcess cut;  // of the tool; engagement comes from the workpiece
  int tool = 0;                 // whose cuts are looked at; 0: all
  double step_mm = 0.0;         // between two places; 0: twice the resolution of the workpiece
  double force_n = 0.0;         // greatest resultant to be kept; 0: forces as programmed alone
  double feed_min = 0.0;        // mm per turn; 0: a twentieth of the programmed feed
  double feed_max = 0.0;        // 0: the programmed feed
  std::uint64_t memory_max = simulation::memory_default;  // of the virtual workpiece, bytes
};

// A place of the path. Feeds in mm/min, coordinates in the program's frame where it announced its
// blank.
struct MillingPlace {
  std::uint32_t line = 0;
  std::uint16_t file = 0;
  double path_mm = 0.0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double z_mm = 0.0;
  double rev_per_min = 0.0;
  double feed_programmed = 0.0;
  double feed_run = 0.0;  // as the axes have it there
  double area_mm2 = 0.0;  // of the cut across the feed
  double force_mean_n = 0.0;
  double force_peak_n = 0.0;
  double power_w = 0.0;  // of the cut
  double deflection_um = 0.0;
  double feed_planned = 0.0;
  double force_planned_n = 0.0;  // peak
};

struct MillingForecast {
  std::vector<MillingPlace> places;
  double time_programmed_s = 0.0;  // at feed: distance over the feed of the block
  double time_s = 0.0;
  std::map<std::uint32_t, std::vector<FedPoint>> lines;  // of the program text
};

// Throws std::runtime_error where something is wrong with the program, where the program
// announces no workpiece, and where a program that is to be planned has feeds that cannot be.
[[nodiscard]] MillingForecast forecast_milling(const MillingRequest& request);

}  // namespace stanok::jobs

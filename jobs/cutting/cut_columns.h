// The columns of the forces along a program: what the CSV of `stanok process optimise`, its
// pictures, the protocol and Python give. Feeds in mm/min, but feed_..._mm in mm per turn.
#pragma once

#include "jobs/columns/columns.h"
#include "jobs/cutting/force_forecast.h"
#include "jobs/cutting/milling_forecast.h"

namespace stanok::jobs {

[[nodiscard]] const Columns<ForcePlace>& turning_columns();
[[nodiscard]] const Columns<MillingPlace>& milling_columns();

// Those that process.forces gives of either cut, in its order: path, forces as programmed and
// planned, feeds as programmed and planned, power, depth (turning) or area (milling), deflection.
[[nodiscard]] Columns<ForcePlace> turning_overview();
[[nodiscard]] Columns<MillingPlace> milling_overview();

// The largest value of a column; 0 without places.
template <class Place>
[[nodiscard]] double greatest(const std::vector<Place>& places, double Place::* quantity) {
  double most = 0.0;
  for (const Place& place : places) most = std::max(most, place.*quantity);
  return most;
}

}  // namespace stanok::jobs

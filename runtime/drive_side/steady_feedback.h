// SteadyFeedback: what the drives tell, without the noise of encoders at rest.
//
// The last digit of an encoder flickers for ever. While the whole machine rests its cycle is given
// the position that it was given last, as long as the drive stands within one increment of it (of
// two, the noise from end to end, it is given one), and a velocity of up to one increment a cycle
// as none; all else, and all in motion, as it comes. So the inputs of a machine at rest do not
// change, nor does what it says. What is given is what is recorded: a replay is exact.
#pragma once

#include <span>
#include <vector>

#include "base/rt_safe.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "drives/bus_config.h"

namespace stanok::runtime {

class SteadyFeedback {
 public:
  // The drives of the bus, those of the axes first, have the increments.
  SteadyFeedback(const channels::MachineConfig& machine, const drives::BusConfig& bus);

  // Of the axes of the machine, or nothing (ideal drives); `last`: the output of the cycle before.
  // Valid until the next call.
  [[nodiscard]] std::span<const channels::AxisFeedback> of(
      std::span<const channels::AxisFeedback> told, const channels::CycleOutput& last) RT_SAFE;

 private:
  double cycles_per_s_;
  std::vector<double> increments_;  // mm or deg, of each axis
  std::vector<channels::AxisFeedback> given_;
};

}  // namespace stanok::runtime

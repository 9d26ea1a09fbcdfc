// ForceControls: the force control of each channel of a machine that has it, for its cycle.
#pragma once

#include <memory>
#include <vector>

#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "process/adaptive/force_control.h"

namespace stanok::runtime {

// Outlives the machine that is made with it.
class ForceControls {
 public:
  explicit ForceControls(const config::MachineFile& file);

  // The options of the machine, with the controls in the order of its channels.
  [[nodiscard]] channels::MachineOptions given_to(channels::MachineOptions options) const;

 private:
  std::vector<std::unique_ptr<process::ForceControl>> controls_;  // nullptr: none
};

}  // namespace stanok::runtime

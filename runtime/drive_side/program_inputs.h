// ProgramInputs: what the inputs of programs are in a cycle: those of the drives, and the contacts
// that are simulated.
//
// Thread: the real-time cycle. Owner: the assembly.
#pragma once

#include <span>

#include "runtime/drive_side/drive_side.h"

namespace stanok::runtime {

class ProgramInputs {
 public:
  // Both outlive the inputs.
  ProgramInputs(std::span<const config::SimulatedContact> contacts,
                const channels::MachineOptions& options)
      : contacts_(contacts), options_(options) {}

  // Nothing (nullptr) where neither the drives nor a contact nor a simulated probe has any. `last`:
  // the output of the cycle before. `touched`: digital inputs that a simulated probe has on.
  [[nodiscard]] const Signals* read(DriveSide& drives, const channels::CycleOutput& last,
                                    const Signals* touched) RT_SAFE;
  // As they were read last.
  [[nodiscard]] const Signals* latest() const RT_SAFE { return has_inputs_ ? &inputs_ : nullptr; }

 private:
  std::span<const config::SimulatedContact> contacts_;  // none of a real machine
  const channels::MachineOptions& options_;
  Signals inputs_;
  bool has_inputs_ = false;  // some were read
};

}  // namespace stanok::runtime

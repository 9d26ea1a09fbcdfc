#include "runtime/drive_side/program_inputs.h"

namespace stanok::runtime {

const Signals* ProgramInputs::read(DriveSide& drives, const channels::CycleOutput& last) RT_SAFE {
  const auto read = drives.signals();
  if (!read && contacts_.empty()) return nullptr;
  inputs_ = options_.outputs_to_inputs ? last.signals : Signals{};
  if (read) inputs_ = *read;
  for (const config::SimulatedContact& contact : contacts_) {
    const double position = drives.position_of(contact.axis, last);
    if (position >= contact.from && position <= contact.to) inputs_.set(contact.input, true);
  }
  return &inputs_;
}

}  // namespace stanok::runtime

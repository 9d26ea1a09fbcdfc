#include "runtime/drive_side/program_inputs.h"

namespace stanok::runtime {

const Signals* ProgramInputs::read(DriveSide& drives, const channels::CycleOutput& last,
                                   const Signals* touched) RT_SAFE {
  const auto read = drives.signals();
  has_inputs_ = read || !contacts_.empty() || touched != nullptr;
  if (!has_inputs_) return nullptr;
  inputs_ = options_.outputs_to_inputs ? last.signals : Signals{};
  if (read) inputs_ = *read;
  for (const config::SimulatedContact& contact : contacts_) {
    const double position = drives.position_of(contact.axis, last);
    if (position >= contact.from && position <= contact.to) inputs_.set(contact.input, true);
  }
  for (int k = 0; touched != nullptr && k < Signals::digital_count; ++k) {
    if (touched->is_on(k)) inputs_.set(k, true);
  }
  return &inputs_;
}

}  // namespace stanok::runtime

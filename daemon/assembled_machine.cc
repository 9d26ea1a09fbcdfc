#include "daemon/assembled_machine.h"

namespace stanok::daemon {

AssembledMachine::AssembledMachine(runtime::Assembly& assembly, Recorder& recorder,
                                   std::filesystem::path program_root,
                                   std::vector<std::filesystem::path> program_roots)
    : assembly_(assembly),
      inputs_(assembly.machine().input_records()),
      recorder_(recorder),
      program_root_(std::move(program_root)),
      foresight_(assembly.file(), std::move(program_roots)) {}

void AssembledMachine::set_real_time_rights(const RealTimeRights& rights) {
  const std::lock_guard lock(mutex_);
  rights_ = rights;
}

void AssembledMachine::cycle() RT_SAFE {
  cycles_ = assembly_.cycle(events_.take()).cycle;
}

void AssembledMachine::note_overrun(std::int64_t periods) RT_SAFE {
  channels::InputRecord record;
  record.cycle = cycles_;
  record.kind = channels::InputKind::overrun;
  record.value = static_cast<double>(periods);
  // A full ring loses the note, not the overrun: the loop counts it.
  static_cast<void>(inputs_.push(record));
}

void AssembledMachine::on_output(const channels::CycleOutput& output) {
  const std::lock_guard lock(mutex_);
  newest_ = output;
}

channels::CycleOutput AssembledMachine::newest_output() {
  const std::lock_guard lock(mutex_);
  return newest_;
}

LoopFigures AssembledMachine::loop_figures() {
  return loop_ == nullptr ? LoopFigures{} : loop_->figures();
}

RealTimeRights AssembledMachine::real_time_rights() {
  const std::lock_guard lock(mutex_);
  return rights_;
}

std::string AssembledMachine::drive_choice() {
  switch (assembly_.drives()) {
    case runtime::DriveChoice::ideal:
      return "ideal";
    case runtime::DriveChoice::simulated:
      return "simulated";
    case runtime::DriveChoice::embedded:
      return "embedded";
    case runtime::DriveChoice::real:
      return "real";
  }
  return "";
}

}  // namespace stanok::daemon

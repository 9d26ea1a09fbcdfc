// What survives the daemon in its state directory: tools, work offsets and reference points
// (tables.toml), and where the axes stood last (positions.toml).
#pragma once

#include <filesystem>
#include <string>

#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "daemon/cycle/running_machine.h"
#include "daemon/start/state_keeper.h"

namespace stanok::daemon {

// The state of the directory becomes that of the machine: its tables, and where its axes start.
// What is not kept stays as in the machine file, also a position that is outside of its axis now;
// names and shapes of tools, and tools that are new, are always those of the machine file. Throws
// StateDirectoryError for a file that cannot be used.
void load_state(const std::filesystem::path& directory, channels::MachineConfig& machine);

// When the positions are written: when the axes stand, and every ten seconds while they do not.
class PositionSnapshot {
 public:
  explicit PositionSnapshot(const channels::MachineConfig& machine);
  [[nodiscard]] std::string operator()(const channels::CycleOutput& newest);

 private:
  const channels::MachineConfig& machine_;
  std::string kept_;
  std::int64_t kept_cycle_ = 0;
};

// Keeps the state of a running machine, which outlives it, until its end.
class KeptState {
 public:
  KeptState(const std::filesystem::path& directory, RunningMachine& machine,
            const StateKeeper::OnFault& on_fault);

  // As StateKeeper::keep, for the tables.
  void keep_tables(StateKeeper::Done done) { table_keeper_.keep(std::move(done)); }

 private:
  PositionSnapshot positions_;
  StateKeeper table_keeper_;
  StateKeeper position_keeper_;
};

}  // namespace stanok::daemon

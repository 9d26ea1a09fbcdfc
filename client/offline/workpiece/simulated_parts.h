// `simulate --workpiece-out`, `--picture`, `--workpiece-report`: the workpieces of all channels,
// which the run cuts and its probes touch, written at its end.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "client/offline/workpiece/workpiece_output.h"
#include "runtime/simulation.h"

namespace stanok::client {

struct WorkpieceOptions {
  WorkpieceFiles files;
  std::uint64_t memory_mib = simulation::memory_default >> 20U;
};

void add_workpiece_options(CLI::App& command, WorkpieceOptions& options);

// As the files of these runs are called; `runs` are kept.
[[nodiscard]] FileNames names_of(const std::vector<channels::RunReport>& runs);

// What a run has left of its blanks, whole, at its end.
[[nodiscard]] std::vector<NamedWorkpiece> finished_workpieces(
    const runtime::SimulatedWorkpieces& simulated, const FileNames& name_of);

enum class RunWas : std::uint8_t { whole, interrupted };

class SimulatedParts {
 public:
  // `file` outlives it.
  SimulatedParts(const config::MachineFile& file, const WorkpieceOptions& options);

  // For the run that cuts them.
  [[nodiscard]] std::shared_ptr<runtime::SimulatedWorkpieces> workpieces() const {
    return simulated_;
  }

  // At the end of the run: what is wanted is written. False when that failed, or when files are
  // wanted and no program has announced a workpiece; the reasons went to stderr. Of a run that was
  // interrupted nobody waits for a surface: the report only, with volumes by rays.
  [[nodiscard]] bool finish(const std::vector<channels::RunReport>& runs, RunWas run);
  void print_summary() const { print(workpieces_, names_); }
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  WorkpieceFiles files_;
  bool refused_ = false;
  std::shared_ptr<runtime::SimulatedWorkpieces> simulated_;
  std::vector<NamedWorkpiece> workpieces_;
  FileNames names_;
};

}  // namespace stanok::client

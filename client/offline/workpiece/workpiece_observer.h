// `simulate --workpiece-out`, `--picture`, `--workpiece-report`: the workpieces of all channels,
// followed as the run goes, written at its end.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "client/offline/workpiece/workpiece_output.h"
#include "runtime/simulation.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::client {

struct WorkpieceOptions {
  WorkpieceFiles files;
  std::uint64_t memory_mib = simulation::memory_default >> 20U;
};

void add_workpiece_options(CLI::App& command, WorkpieceOptions& options);

class WorkpieceObserver final : public runtime::CycleObserver {
 public:
  WorkpieceObserver(const channels::MachineConfig& machine, const WorkpieceOptions& options);

  void observe(const channels::CycleOutput& output) override;

  // At the end of the run: what is wanted is written. False when that failed, or when no program
  // has announced a workpiece; the reasons went to stderr.
  [[nodiscard]] bool finish(const std::vector<channels::RunReport>& runs);
  void print_summary() const { print(workpieces_, names_); }
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  WorkpieceFiles files_;
  double cycle_s_;
  bool refused_ = false;
  std::vector<std::unique_ptr<runtime::ChannelFeed>> feeds_;
  std::vector<NamedWorkpiece> workpieces_;
  FileNames names_;
};

}  // namespace stanok::client

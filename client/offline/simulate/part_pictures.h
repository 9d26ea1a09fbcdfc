// PartPictures: what a run leaves of its blanks, as the bytes of PNG files, which pass between
// processes and lie in the cache.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "client/offline/library/program_folder.h"
#include "runtime/simulation.h"

namespace stanok::client {

class PartPictures {
 public:
  // `file` outlives it. `memory_mib`: that a workpiece may take.
  PartPictures(const config::MachineFile& file, std::uint64_t memory_mib);

  // For the run that cuts them.
  [[nodiscard]] std::shared_ptr<runtime::SimulatedWorkpieces> workpieces() const {
    return simulated_;
  }

  // At the end of the run: one for each workpiece, none where no program has announced one.
  [[nodiscard]] std::vector<std::string> drawn(const std::vector<channels::RunReport>& runs);
  // What could not be followed or drawn.
  [[nodiscard]] const Diagnostics& complaints() const { return complaints_; }

 private:
  std::shared_ptr<runtime::SimulatedWorkpieces> simulated_;
  Diagnostics complaints_;
};

// The picture of a program in the folder for them: as the program is called below its own folder,
// with .png behind it.
[[nodiscard]] std::filesystem::path picture_of(const Candidate& program,
                                               const std::filesystem::path& folder);

// Throws CLI::ValidationError where two programs would have one picture.
void check_pictures(const Candidates& candidates, const std::filesystem::path& folder);

}  // namespace stanok::client

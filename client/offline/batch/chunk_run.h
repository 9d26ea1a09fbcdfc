// A chunk of a batch, done by this computer.
#pragma once

#include <cstddef>

#include "client/offline/batch/batch_folder.h"
#include "client/offline/batch/batch_plan.h"

namespace stanok::client {

// Whoever does chunks of a plan: the machine is read once.
class ChunkRun {
 public:
  // Throws std::runtime_error where stanok, or the machine, is here not what the plan was made
  // with.
  ChunkRun(const BatchFolder& folder, const BatchPlan& plan);

  // The exit code: 0 when the results lie in the folder, also where they did before. Throws
  // std::runtime_error where they cannot be written.
  [[nodiscard]] int run(std::size_t chunk) const;

 private:
  const BatchFolder& folder_;
  const BatchPlan& plan_;
  LibraryWork work_;
};

// `stanok batch run FOLDER CHUNK`, what a task of a cluster does: goes to the directory of the plan
// and does the chunk, unless it is done or the batch is cancelled. A fault stands in the folder
// before it is thrown.
[[nodiscard]] int run_task(const BatchFolder& folder, std::size_t chunk);

}  // namespace stanok::client

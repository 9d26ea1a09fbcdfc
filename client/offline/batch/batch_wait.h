// Chunks given to Slurm, and the wait for them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "client/offline/batch/batch_folder.h"
#include "client/offline/batch/batch_plan.h"
#include "client/offline/batch/batch_state.h"

namespace stanok::client {

// The number of the job; throws SlurmError.
std::string submit_chunks(const BatchFolder& folder, const BatchPlan& plan,
                          const std::vector<std::size_t>& chunks);

// Waits until no chunk runs or waits any more, or until an interrupt. Slurm itself begins tasks
// again whose node is lost; chunks that are missing when no task is left are submitted again, a few
// times, unless the batch is cancelled.
[[nodiscard]] BatchState wait_for(const BatchFolder& folder, const BatchPlan& plan);

}  // namespace stanok::client

#include "client/offline/batch/chunk_run.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "client/offline/library/work_pool.h"

namespace stanok::client {
namespace {

int done_by(const BatchFolder& folder, std::size_t chunk) {
  const BatchPlan plan = folder.plan();
  if (chunk >= plan.chunks()) {
    throw std::runtime_error("there is no chunk " + std::to_string(chunk) + ": the batch has " +
                             std::to_string(plan.chunks()));
  }
  std::filesystem::current_path(plan.directory);
  return ChunkRun(folder, plan).run(chunk);
}

}  // namespace

ChunkRun::ChunkRun(const BatchFolder& folder, const BatchPlan& plan)
    : folder_(folder), plan_(plan), work_(work_of(plan)) {
  if (work_.context() == plan.context) return;
  throw std::runtime_error(
      "stanok or the machine file " + plan.job.machine_file +
      " are not those that the batch was submitted with; results would not fit together. Use the "
      "same stanok on all computers, or submit the batch to a new folder");
}

int ChunkRun::run(std::size_t chunk) const {
  if (folder_.results(chunk)) return 0;
  std::vector<PieceResult> results;
  const LibraryOutput output{
      .take = [&](const Candidate& /*program*/, const std::string& result,
                  const std::string& death) { results.push_back({result, death}); },
      .finish =
          [&] {
            if (folder_.keep(chunk, results)) return 0;
            throw std::runtime_error("the results of chunk " + std::to_string(chunk) +
                                     " cannot be written to " + folder_.path().string() +
                                     "; check its permissions and the space of the disk");
          }};
  return run_library(plan_.programs_of(chunk), plan_.library, work_, output);
}

int run_task(const BatchFolder& folder, std::size_t chunk) {
  if (folder.is_cancelled()) return 0;
  try {
    return done_by(folder, chunk);
  } catch (const std::exception& exception) {
    folder.note_fault(chunk, exception.what());
    throw;
  }
}

}  // namespace stanok::client

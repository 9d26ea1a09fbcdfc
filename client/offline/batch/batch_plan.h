// BatchPlan: what a batch is to do, as it lies in its folder for every computer that takes part.
//
// Programs are divided into chunks, in their order; chunk k has those from k * chunk on. Names are
// as they were given, so that results name them alike; relative ones are seen from `directory`.
// docs/developer/adr/0032-batches-of-chunks.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "client/offline/library/library_run.h"
#include "client/offline/machine/job_options.h"

namespace stanok::client {

enum class BatchTask { check, simulate };

struct BatchPlan {
  BatchTask task = BatchTask::check;
  JobOptions job{};
  double limit_s = -1.0;     // of a simulation; < 0: none
  bool drives = false;       // simulated drives
  std::string pictures{};    // of a simulation: folder for them, from `directory`; empty: none
  LibraryOptions library{};  // of each chunk
  std::string directory{};
  // Digest of stanok, the machine and the options: what takes part has the same.
  std::string context{};
  std::size_t chunk = 1;  // programs
  Candidates candidates{};

  [[nodiscard]] std::size_t chunks() const;
  [[nodiscard]] Candidates programs_of(std::size_t chunk_index) const;
};

// Chunks of at least a hundred programs, and so few that Slurm takes them as one array
// (MaxArraySize 1001, unless it is configured otherwise).
[[nodiscard]] std::size_t usual_chunk(std::size_t programs);

[[nodiscard]] std::string plan_record(const BatchPlan& plan);
// Nothing where the bytes are no plan.
[[nodiscard]] std::optional<BatchPlan> plan_of(std::string_view bytes);

// Reads the machine file; throws what it throws.
[[nodiscard]] LibraryWork work_of(const BatchPlan& plan);

enum class BatchText { table, json };
[[nodiscard]] LibraryOutput output_of(const BatchPlan& plan, BatchText text);

}  // namespace stanok::client

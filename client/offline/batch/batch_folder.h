// BatchFolder: the folder of a batch, which all computers that take part share.
//
//   plan             what is to be done (BatchPlan)
//   results/000017   what chunk 17 gave, with a digest; written whole or not at all
//   faults/000017    why chunk 17 could not be done, in words
//   log/17.txt       what the task of chunk 17 wrote, by Slurm
//   cancelled        no chunk is begun any more
//   engine           who works at it: the last choice of `submit`
// A result belongs to the plan beside it: it holds the plan's digest. Nothing else is kept, so
// there is nothing that could say otherwise than the results themselves.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/offline/batch/batch_plan.h"
#include "client/offline/library/work_pool.h"

namespace stanok::client {

enum class EngineKind { local, slurm };

struct Engine {
  EngineKind kind = EngineKind::local;
  std::vector<std::string> options;  // for sbatch
};

class BatchFolder {
 public:
  explicit BatchFolder(const std::filesystem::path& folder);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  // Writes the plan where there is none; the same again is none the worse. Throws
  // std::runtime_error where another plan lies there, or the folder cannot be written.
  void lay_down(const BatchPlan& plan);
  // Throws std::runtime_error where there is none, or one of another version.
  [[nodiscard]] BatchPlan plan() const;
  // A short name of this batch in a queue that it shares with others: of its plan and its place.
  [[nodiscard]] std::string name() const;

  // The results of a chunk; nothing: it is not done. Damaged ones are none.
  [[nodiscard]] std::optional<std::vector<PieceResult>> results(std::size_t chunk) const;
  // False: cannot be written. A fault noted of the chunk before is forgotten.
  [[nodiscard]] bool keep(std::size_t chunk, const std::vector<PieceResult>& results) const;
  void note_fault(std::size_t chunk, std::string_view text) const;
  void forget_fault(std::size_t chunk) const;
  [[nodiscard]] std::string fault(std::size_t chunk) const;  // empty: none

  [[nodiscard]] Engine engine() const;
  void choose(const Engine& engine) const;

  [[nodiscard]] bool is_cancelled() const;
  void cancel() const;
  void allow() const;

 private:
  [[nodiscard]] std::filesystem::path place(const char* kind, std::size_t chunk) const;
  [[nodiscard]] const std::string& plan_digest() const;

  std::filesystem::path folder_;
  mutable std::string plan_digest_;  // empty: not asked for yet
};

}  // namespace stanok::client

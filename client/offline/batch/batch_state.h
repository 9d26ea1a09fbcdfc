// How far a batch is: what lies in its folder, and what waits in the queue of its engine.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "client/offline/batch/batch_folder.h"

namespace stanok::client {

// Every chunk is in one of them.
struct BatchState {
  std::size_t programs = 0;
  std::size_t chunks = 0;
  std::size_t done = 0;
  std::size_t running = 0;
  std::size_t pending = 0;
  // Ended by a fault of its surroundings, in words.
  std::vector<std::pair<std::size_t, std::string>> failed{};
  // Not done and in no queue: not begun, cancelled, or lost with its computer.
  std::vector<std::size_t> missing{};
  EngineKind engine = EngineKind::local;
  bool is_cancelled = false;

  [[nodiscard]] bool is_over() const { return running + pending == 0; }
  [[nodiscard]] bool is_complete() const { return done == chunks; }
};

// Asks the queue only where a chunk is not done; throws SlurmError.
[[nodiscard]] BatchState state_of(const BatchFolder& folder, const BatchPlan& plan);
[[nodiscard]] std::string state_text(const BatchState& state);
[[nodiscard]] nlohmann::ordered_json state_json(const BatchState& state);

// Chunks that `submit` has to see to: what failed and what is missing, in ascending order.
[[nodiscard]] std::vector<std::size_t> chunks_to_do(const BatchState& state);

}  // namespace stanok::client

#include "client/offline/batch/batch_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "client/offline/batch/slurm.h"

namespace stanok::client {
namespace {

// "1 chunk", "2 chunks".
std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

BatchState state_of(const BatchFolder& folder, const BatchPlan& plan) {
  BatchState state{.programs = plan.candidates.programs.size(),
                   .chunks = plan.chunks(),
                   .engine = folder.engine().kind,
                   .is_cancelled = folder.is_cancelled()};
  std::vector<std::size_t> open;
  for (std::size_t chunk = 0; chunk < state.chunks; ++chunk) {
    if (!folder.results(chunk)) open.push_back(chunk);
  }
  std::map<std::size_t, TaskState> queued;
  if (state.engine == EngineKind::slurm && !open.empty()) queued = queued_tasks(folder.name());
  state.done = state.chunks - open.size();
  for (const std::size_t chunk : open) {
    const auto task = queued.find(chunk);
    if (task != queued.end()) {
      ++(task->second == TaskState::running ? state.running : state.pending);
    } else if (folder.results(chunk)) {  // since it was looked for first
      ++state.done;
    } else if (const std::string fault = folder.fault(chunk); !fault.empty()) {
      state.failed.emplace_back(chunk, fault);
    } else {
      state.missing.push_back(chunk);
    }
  }
  return state;
}

std::string state_text(const BatchState& state) {
  std::string text =
      fmt::format("{} in {}: {} done, {} running, {} waiting, {} failed, {} missing\n",
                  counted(state.programs, "program"), counted(state.chunks, "chunk"), state.done,
                  state.running, state.pending, state.failed.size(), state.missing.size());
  if (state.is_cancelled) text += "cancelled; `stanok batch submit` goes on with it\n";
  for (const auto& [chunk, fault] : state.failed)
    text += fmt::format("chunk {} failed: {}\n", chunk, fault);
  if (!state.missing.empty()) {
    text += "missing: " + array_text(state.missing) +
            (state.engine == EngineKind::slurm
                 ? "; their tasks ended without results (lost node, time, memory, cancelled): see "
                   "log in the folder; `stanok batch submit --work FOLDER` does them again\n"
                 : "; `stanok batch submit --work FOLDER` does them\n");
  }
  return text;
}

nlohmann::ordered_json state_json(const BatchState& state) {
  nlohmann::ordered_json json{{"engine", state.engine == EngineKind::slurm ? "slurm" : "local"},
                              {"programs", state.programs},
                              {"chunks", state.chunks},
                              {"done", state.done},
                              {"running", state.running},
                              {"pending", state.pending},
                              {"cancelled", state.is_cancelled}};
  json["failed"] = nlohmann::ordered_json::array();
  for (const auto& [chunk, fault] : state.failed)
    json["failed"].push_back({{"chunk", chunk}, {"error", fault}});
  json["missing"] = state.missing;
  return json;
}

std::vector<std::size_t> chunks_to_do(const BatchState& state) {
  std::vector<std::size_t> chunks = state.missing;
  std::ranges::transform(state.failed, std::back_inserter(chunks),
                         [](const auto& failed) { return failed.first; });
  std::ranges::sort(chunks);
  return chunks;
}

}  // namespace stanok::client

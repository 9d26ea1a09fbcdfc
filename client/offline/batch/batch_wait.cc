#include "client/offline/batch/batch_wait.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "client/offline/batch/slurm.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/output.h"
#include "client/terminal/progress_line.h"

namespace stanok::client {
namespace {

using std::chrono::milliseconds;

// A chunk that is lost so often has a reason of its own.
constexpr int submissions_again_max = 3;
// squeue costs the controller of a cluster: seldom, once it takes long.
constexpr milliseconds look_first{200};
constexpr milliseconds look_last{10'000};

void rest(milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (!is_interrupted() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::min(time, look_first));
}

}  // namespace

std::string submit_chunks(const BatchFolder& folder, const BatchPlan& plan,
                          const std::vector<std::size_t>& chunks) {
  return submit_tasks({.name = folder.name(),
                       .log = folder.path() / "log",
                       .directory = plan.directory,
                       .processors = std::max(plan.library.jobs, 1),
                       .options = folder.engine().options,
                       .command = {std::filesystem::read_symlink("/proc/self/exe").string(),
                                   "batch", "run", folder.path().string()}},
                      chunks);
}

BatchState wait_for(const BatchFolder& folder, const BatchPlan& plan) {
  catch_interrupts();
  ProgressLine progress;
  milliseconds pause = look_first;
  int submissions_again = 0;
  while (true) {
    BatchState state = state_of(folder, plan);
    progress.show(progress_bar(state.done, state.chunks, "chunks", bar_columns));
    if (is_interrupted()) return state;
    if (state.is_over()) {
      progress.clear();
      if (state.missing.empty() || state.is_cancelled || state.engine != EngineKind::slurm ||
          submissions_again == submissions_again_max)
        return state;
      ++submissions_again;
      const std::string number = submit_chunks(folder, plan, state.missing);
      write_message("chunks " + array_text(state.missing) + " were lost; submitted again as job " +
                    number + "\n");
      pause = look_first;
    }
    rest(pause);
    pause = std::min(pause * 3 / 2, look_last);
  }
}

}  // namespace stanok::client

#include "runtime/recorded_run.h"

#include "runtime/run_stream.h"

namespace stanok::runtime {

std::unique_ptr<RecordedRun> read_run(const std::filesystem::path& log) {
  RunStream stream(log);
  auto run = std::make_unique<RecordedRun>();
  run->beginning = stream.beginning();
  run->files = stream.files();
  run->contents = stream.contents();
  return run;
}

}  // namespace stanok::runtime

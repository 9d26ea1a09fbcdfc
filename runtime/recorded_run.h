// RecordedRun: all that a recorded run depended on, out of its log, in the order of the cycles.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"
#include "config/files/machine_file.h"
#include "lang/contract/environment.h"
#include "recording/format/encode_inputs.h"
#include "recording/read/log_contents.h"
#include "runtime/run_setup.h"

namespace stanok::runtime {

// The programs of the log, in the order in which they were asked for.
class RecordedFiles final : public lang::Files {
 public:
  void add(const program_read_t& read);
  void add_text(std::uint64_t hash, std::string text) { texts_[hash] = std::move(text); }

  // What the same question found in the recorded run, the first time, the second time...
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override;

 private:
  struct Answer {
    bool found = false;
    std::uint64_t hash = 0;
    std::string path;
  };
  std::map<std::uint64_t, std::string> texts_;
  mutable std::map<std::pair<std::string, std::string>, std::deque<Answer>> answers_;
};

struct RecordedRun {
  struct Feedback {
    std::int64_t cycle = 0;
    int channel = 0;
    int axis = 0;
    channels::AxisFeedback value;
  };
  struct Arrival {
    std::int64_t cycle = 0;
    int channel = 0;
    channels::Arrivals value;
  };

  recording::LogContents contents;
  config::MachineFile machine;
  RunSetup setup;
  RecordedFiles files;
  std::vector<channels::InputRecord> inputs;  // ascending cycles, like the others
  std::vector<Feedback> feedback;
  std::vector<Arrival> arrivals;
  std::optional<std::int64_t> first_cycle;  // with a setpoint
  std::optional<std::int64_t> lost_cycle;   // from this one on inputs are missing
};

// Where the part of a log ends whose bytes are as they were written; of one without checks its end.
[[nodiscard]] std::int64_t usable_bytes(const recording::LogContents& contents);

// Reads the usable bytes. Throws std::runtime_error when the log cannot be read, or lacks what a
// run begins with.
[[nodiscard]] std::unique_ptr<RecordedRun> read_run(const std::filesystem::path& log);

}  // namespace stanok::runtime

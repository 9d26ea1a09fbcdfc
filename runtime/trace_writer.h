// Traces: one CSV row per cycle, every number with 17 digits, for judges and plots
// (docs/reference/command-line.md#without-a-daemon).
//
// The tip trace follows the programmed point in the workpiece system, a file per program run, from
// the last cycle at rest before the first move to the first one at rest after the last; the axis
// trace follows the machine axes of a channel through every cycle. Values are those at the
// cycle instant, derivatives are the analytic ones.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "runtime/simulation.h"

namespace stanok::runtime {

// A stdio stream that closes itself. Throws std::system_error when the file cannot be written.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  [[nodiscard]] std::FILE* stream() const { return stream_.get(); }

 private:
  struct Closer {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::unique_ptr<std::FILE, Closer> stream_;
};

class TipTrace final : public CycleObserver {
 public:
  // FILE for the first run, FILE.2, FILE.3, ... for the following ones.
  TipTrace(const channels::MachineConfig& machine, int channel, std::string path);
  void observe(const channels::CycleOutput& output) override;

 private:
  void begin_run(std::uint32_t run);
  [[nodiscard]] std::string row(const channels::CycleOutput& output,
                                const channels::ChannelOutput& channel) const;
  void write(const std::string& text);

  int channel_;
  double cycle_s_;
  std::string path_;
  std::vector<std::string> words_;  // lower case
  std::unique_ptr<OutputFile> file_;
  int runs_ = 0;
  std::uint32_t run_ = 0;
  bool moved_ = false;
  bool stands_ = false;           // the row of the first cycle at rest is written
  std::string standing_rows_;     // of the rest since then; written when it moves on
  channels::CycleOutput before_;  // the last cycle at rest before the first move
};

class AxisTrace final : public CycleObserver {
 public:
  AxisTrace(const channels::MachineConfig& machine, int channel, const std::string& path);
  void observe(const channels::CycleOutput& output) override;

 private:
  int channel_;
  double cycle_s_;
  OutputFile file_;
};

}  // namespace stanok::runtime

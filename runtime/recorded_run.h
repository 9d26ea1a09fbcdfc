// What a recorded run depended on, out of its log: the machine it began with, and its inputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stanok_messages/setpoint_t.hpp>
#include <string>
#include <vector>

#include "channels/contract/input_record.h"
#include "channels/contract/output.h"
#include "config/files/machine_file.h"
#include "recording/read/log_contents.h"
#include "recording/stream/message_stream.h"
#include "runtime/recorded_files.h"
#include "runtime/run_setup.h"

namespace stanok::runtime {

struct RunBeginning {
  config::MachineFile machine;
  RunSetup setup;
};

struct RecordedFeedback {
  std::int64_t cycle = 0;
  int channel = 0;
  int axis = 0;
  channels::AxisFeedback value;
};

struct RecordedArrival {
  std::int64_t cycle = 0;
  int channel = 0;
  channels::Arrivals value;
};

// Of the machine or the setup of a run.
struct BeginningText {
  recording::TextKind kind;
  std::string name;
  std::string text;
};

// A part of a log. All inputs that led to its setpoints are in it, or in those before.
struct LogPart {
  std::vector<BeginningText> texts;
  std::vector<channels::InputRecord> inputs;
  std::vector<RecordedFeedback> feedback;
  std::vector<RecordedArrival> arrivals;
  std::vector<setpoint_t> setpoints;
  std::int64_t bytes_read = 0;  // of the file, up to its end
  bool is_checked = false;      // every byte of it by check sums
};

// A recording without its setpoints, for whoever reads those himself.
struct RecordedRun {
  recording::LogContents contents;
  RunBeginning beginning;
  std::shared_ptr<const RecordedFiles> files;
};

// Throws std::runtime_error when the log cannot be read, or lacks what a run begins with.
[[nodiscard]] std::unique_ptr<RecordedRun> read_run(const std::filesystem::path& log);

}  // namespace stanok::runtime

// LogObserver: writes the whole stream of a simulation into one LCM log.
#pragma once

#include <memory>
#include <string>

#include "recording/log/log_writer.h"
#include "recording/stream/message_stream.h"
#include "runtime/run_setup.h"
#include "runtime/simulation.h"

namespace stanok::runtime {

class LogObserver final : public CycleObserver {
 public:
  // Throws std::runtime_error when the file cannot be written.
  LogObserver(const config::MachineFile& file, const RunSetup& setup, const std::string& path,
              std::string version);

  void begin(const channels::Machine& machine) override {
    stream_->ask_for_situations(
        [&machine](const channels::ChannelOutput& output) { return machine.situation(output); });
  }
  void observe(const channels::CycleOutput& output) override { stream_->cycle(output); }
  void observe(const recording::ProgramRead& read, std::int64_t cycle) override {
    stream_->program_read(read, cycle);
  }
  void observe(const channels::Event& event) override { stream_->event(event); }
  void observe(const channels::InputRecord& input) override {
    stream_->input(input);
    const bool is_loss = std::holds_alternative<channels::LostInputs>(input.content);
    if (is_loss && lost_cycle_ == 0) lost_cycle_ = input.cycle;
  }

  void observe(const channels::InputChange& change) override { stream_->input(change); }

  // Empty, or why the log ends early or cannot be repeated.
  [[nodiscard]] std::string close();

 private:
  std::unique_ptr<recording::LogWriter> writer_;
  std::unique_ptr<recording::MessageStream> stream_;
  std::int64_t lost_cycle_ = 0;  // from this one on inputs are missing; 0: none is
};

}  // namespace stanok::runtime

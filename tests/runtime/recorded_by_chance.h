// Recorded runs for tests of their repetition, and copies of their logs in which something differs.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/log/log_reader.h"
#include "recording/stream/message_stream.h"
#include "runtime/assembly.h"
#include "runtime/log_observer.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {

using channels::OperatorAction;

inline const std::filesystem::path source_tree = stanok::testing::source_folder();

inline config::MachineFile started_at(const channels::AxisRow& starts, config::MachineFile file) {
  for (channels::AxisConfig& axis : file.machine.axes) {
    const auto start = starts.find(axis.name);
    if (start != starts.end()) axis.start = start->second;
  }
  return file;
}

// A run whose preparations come only as far as chance lets them, as threads do.
class RecordedByChance {
 public:
  // `starts`: where axes stand at first that do not stand as in the machine file.
  RecordedByChance(const std::string& machine, DriveChoice drives, std::uint64_t seed,
                   const channels::AxisRow& starts = {})
      : random_(seed),
        assembly_({.file = started_at(starts, config::read_machine_file(source_tree / "config" /
                                                                        "machines" / machine)),
                   .drives = drives,
                   .program_roots = {files_.folder(), source_tree / "programs" / "examples"},
                   .machine = setup_.options,
                   .output_capacity = 128}),
        log_(assembly_.file(), setup_, path().string(), "test") {}

  void program(const std::string& name, const std::string& text) { files_.write(name, text); }

  void ask(OperatorAction action, int channel, const std::string& text = "", double value = 0.0,
           double value_2 = 0.0) {
    channels::OperatorEvent event;
    event.channel = channel;
    event.command =
        channels::command_of(
            {.action = action, .value = value, .value_2 = value_2, .text = std::string_view(text)})
            .value();
    ask(event);
  }
  void ask(channels::OperatorEvent event) {
    event.id = ++last_id_;
    events_.push_back(event);
  }

  [[nodiscard]] std::vector<channels::RunReport> runs() { return assembly_.machine().runs(); }

  void run(int cycles) {
    for (int n = 0; n < cycles; ++n) {
      const channels::CycleOutput& sent = cycle();
      channels::CycleOutput output;
      while (assembly_.outputs().pop(output)) {
        log_.observe(output);
        if (on_output_) on_output_(output);
      }
      if (on_sent_) on_sent_(sent);
      channels::Event event;
      while (assembly_.machine().events().pop(event)) {
        log_.observe(event);
        if (on_event_) on_event_(event);
      }
      channels::OperatorReply reply;
      while (assembly_.machine().replies().pop(reply)) expect_understood(reply);
      moved_ = moved_ || sent.channels[0].path_speed > 1.0;
    }
  }

  // From now on each preparation comes to one step in so many cycles; 0: as chance lets it.
  void prepare_every(int cycles) { cycles_per_step_ = cycles; }
  // Looks at every output and event from now on.
  void watch(std::function<void(const channels::CycleOutput&)> outputs,
             std::function<void(const channels::Event&)> events) {
    on_output_ = std::move(outputs);
    on_event_ = std::move(events);
  }

  // From now on so many periods of the clock pass without a cycle before each one; `sent` looks at
  // what the drives are told.
  void come_late(std::function<std::int64_t()> periods,
                 std::function<void(const channels::CycleOutput&)> sent) {
    lost_before_ = std::move(periods);
    on_sent_ = std::move(sent);
  }
  [[nodiscard]] const config::MachineFile& file() const { return assembly_.file(); }
  // What the drives had told when the last cycle began.
  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() const {
    return assembly_.feedback();
  }

  [[nodiscard]] int chance(int count) {
    return static_cast<int>(random_() % static_cast<std::uint64_t>(count));
  }
  [[nodiscard]] bool moved() const { return moved_; }
  [[nodiscard]] std::filesystem::path path() const { return files_.folder() / "run.lcm"; }
  void close() { EXPECT_EQ(log_.close(), ""); }
  [[nodiscard]] std::string closing_word() { return log_.close(); }
  // Cycles whose outputs do not get to the log; what is asked for takes effect in the first one.
  void lose_outputs(int cycles) {
    for (int n = 0; n < cycles; ++n) {
      cycle();
      channels::CycleOutput lost;
      while (assembly_.outputs().pop(lost)) {
      }
    }
  }

 private:
  // Much is refused by chance, but a text that is wrong tests nothing.
  static void expect_understood(const channels::OperatorReply& reply) {
    const std::string_view code = reply.code.view();
    const bool is_of_language = code.size() > 1 && code[0] == 'E' && code[1] < '5';
    EXPECT_FALSE(is_of_language) << code << " " << reply.text.view();
  }
  const channels::CycleOutput& cycle() {
    prepare_by_chance();
    const std::int64_t lost = lost_before_ ? lost_before_() : 0;
    const channels::CycleOutput& output = assembly_.late_cycle(lost, events_);
    events_.clear();
    for (const auto& read : assembly_.program_reads()) log_.observe(read, output.cycle);
    hand_inputs_on();
    return output;
  }
  void prepare_by_chance() {
    const int channels = static_cast<int>(assembly_.file().machine.channels.size());
    if (cycles_per_step_ > 0) {
      if (++cycles_without_step_ < cycles_per_step_) return;
      cycles_without_step_ = 0;
      for (int k = 0; k < channels; ++k) static_cast<void>(assembly_.machine().prepare(k));
      return;
    }
    for (int k = 0; k < channels; ++k) {
      for (int steps = chance(4); steps > 0; --steps)
        static_cast<void>(assembly_.machine().prepare(k));
    }
  }
  void hand_inputs_on() {
    channels::InputRecord input;
    while (assembly_.machine().input_records().pop(input)) log_.observe(input);
    channels::InputChange change;
    while (assembly_.machine().input_changes().pop(change)) log_.observe(change);
  }

  std::mt19937_64 random_;
  config::TemporaryFiles files_;
  RunSetup setup_{.options = {.on_at_start = true, .changes_kept_s = 1e-3}};
  Assembly assembly_;
  LogObserver log_;
  std::vector<channels::OperatorEvent> events_;
  std::uint64_t last_id_ = 0;
  int cycles_per_step_ = 0;
  int cycles_without_step_ = 0;
  std::function<void(const channels::CycleOutput&)> on_output_;
  std::function<void(const channels::Event&)> on_event_;
  std::function<std::int64_t()> lost_before_;
  std::function<void(const channels::CycleOutput&)> on_sent_;
  bool moved_ = false;
};

inline constexpr const char* contour =
    "#1=0\nG64 P0.05\nM3 S1000\nwhile (#1 < 60) {\n"
    "G1 X[40*cos[#1*12]] Y[40*sin[#1*12]] F6000\n#1=[#1+1]\n}\nM5\nG0 X0 Y0\nM30\n";

// The contour on the mill for so many cycles, its log closed.
class RecordedContour : public RecordedByChance {
 public:
  RecordedContour(DriveChoice drives, std::uint64_t seed, int cycles)
      : RecordedByChance("mill3.toml", drives, seed) {
    program("contour.nc", contour);
    ask(OperatorAction::program_run, 1, "contour.nc");
    run(cycles);
    close();
  }
};

// A copy of a log in which every message of one type went through `change`.
template <class Message, class Change>
std::filesystem::path changed(const std::filesystem::path& log, recording::Topic topic,
                              const Change& change,
                              const std::function<void(recording::MessageStream&)>& go_on = {}) {
  const std::filesystem::path copy = log.string() + ".copy";
  auto reader = recording::LogReader::open(log);
  auto writer = recording::LogWriter::open(copy);
  while (const auto event = reader->next()) {
    std::vector<std::uint8_t> bytes(event->bytes.begin(), event->bytes.end());
    if (recording::topic_of(event->channel) == recording::name_of(topic)) {
      Message message = *recording::decode<Message>(event->bytes);
      change(message);
      message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    }
    (*writer)->send(std::string(event->channel), event->utime, bytes);
  }
  if (go_on) {
    recording::LogDescription machine;
    machine.machine = "mill3";
    recording::MessageStream stream(machine, {writer->get()});
    go_on(stream);
  }
  EXPECT_TRUE((*writer)->flush());
  return copy;
}

}  // namespace stanok::runtime

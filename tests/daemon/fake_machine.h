// FakeMachine: a machine that remembers what it was asked and answers as the test says.
//
// Two channels: 1 "work" with axes X and B, 2 "master". Locked, because a server's thread may ask
// while the test changes it.
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <utility>

#include "daemon/cycle/running_machine.h"
#include "daemon/scope/scope.h"

namespace stanok::daemon {

inline config::MachineFile two_channel_machine() {
  config::MachineFile file;
  file.machine.name = "fake";
  file.machine.axes.resize(2);
  file.machine.axes[0].name = "X2";
  file.machine.axes[1].name = "B";
  channels::ChannelConfig work;
  work.id = 1;
  work.name = "work";
  work.axes = {0, 1};
  work.words = {"X", "B"};
  work.schemes.resize(2);
  work.schemes[0].id = 1;
  work.schemes[0].type = "cartesian";
  work.schemes[0].axes = {0};
  work.schemes[1].id = 2;
  work.schemes[1].type = "head_table";
  work.schemes[1].axes = {0, 1};
  channels::ChannelConfig master;
  master.id = 2;
  master.name = "master";
  master.kind = lang::ChannelKind::master;
  file.machine.channels = {work, master};
  return file;
}

class FakeMachine final : public RunningMachine {
 public:
  // What is done with an event that was taken; called without the lock.
  std::function<void(const channels::OperatorEvent&)> on_submit;

  FakeMachine() : FakeMachine(two_channel_machine()) {
    tables_now.tools.resize(1);
    tables_now.tools[0].number = 32000;
    tables_now.tools[0].length = 77.5;
    output.cycle = 1;
    output.channel_count = 2;
    output.channels[0].id = 1;
    output.channels[0].axis_count = 2;
    output.channels[0].scheme = 1;
    output.channels[1].id = 2;
  }
  // One that has not told of itself yet.
  explicit FakeMachine(config::MachineFile file) : file_(std::move(file)) {
    tables_now = file_.machine.tables;
  }

  // Changes the machine under the lock.
  void change(const std::function<void(FakeMachine&)>& action) {
    const std::lock_guard lock(mutex_);
    action(*this);
  }
  [[nodiscard]] std::vector<channels::OperatorEvent> submitted() {
    const std::lock_guard lock(mutex_);
    return submitted_;
  }

  [[nodiscard]] const config::MachineFile& file() const override { return file_; }
  [[nodiscard]] const std::filesystem::path& program_root() const override { return root; }
  [[nodiscard]] std::vector<std::filesystem::path> program_roots() const override { return {root}; }
  [[nodiscard]] bool submit(const channels::OperatorEvent& event) override {
    {
      const std::lock_guard lock(mutex_);
      if (is_full) return false;
      submitted_.push_back(event);
    }
    if (on_submit) on_submit(event);
    return true;
  }
  [[nodiscard]] bool submit_stop(const channels::OperatorEvent& stop) override {
    return submit(stop);
  }
  [[nodiscard]] std::uint64_t withdraw(std::uint64_t up_to_id) override {
    const std::lock_guard lock(mutex_);
    withdrawn = up_to_id;
    return taking;
  }
  [[nodiscard]] std::optional<channels::OperatorReply> stop_reply() override {
    return std::nullopt;
  }
  [[nodiscard]] std::uint64_t stops_taken() override { return 0; }
  [[nodiscard]] std::int64_t cycles() override { return copy(output).cycle; }
  [[nodiscard]] channels::CycleOutput newest_output() override { return copy(output); }
  [[nodiscard]] std::chrono::nanoseconds output_age() override { return {}; }
  [[nodiscard]] std::vector<channels::RunReport> runs() override { return copy(run_reports); }
  [[nodiscard]] std::vector<channels::AlarmReport> alarms() override { return copy(alarm_reports); }
  [[nodiscard]] std::optional<channels::SearchReport> search(int) override {
    return copy(searched);
  }
  [[nodiscard]] channels::SituationReport situation(const channels::ChannelOutput&) override {
    return copy(situation_report);
  }
  [[nodiscard]] std::vector<channels::AlarmReport> load_diagnostics() override {
    return copy(diagnostics);
  }
  [[nodiscard]] channels::TablesConfig tables() override {
    const std::lock_guard lock(mutex_);
    return tables_now;
  }
  [[nodiscard]] LoopStatistics loop_statistics() override { return {}; }
  [[nodiscard]] RealTimeRights real_time_rights() override { return {}; }
  [[nodiscard]] CycleLosses losses() override { return {.outputs = 0, .inputs = 0, .replies = 2}; }
  [[nodiscard]] std::string drive_choice() override { return choice; }
  [[nodiscard]] drives::BusStatus drive_status() override { return {}; }
  [[nodiscard]] bool reset_drive(const std::string& drive) override {
    resets.push_back(drive);
    return drive != "Q";
  }
  [[nodiscard]] bool inject_fault(const std::string& drive, plant::FaultKind fault) override {
    faults.emplace_back(drive, fault);
    return drive != "Q";
  }
  [[nodiscard]] RecordingStatus recording_status() override {
    RecordingStatus status;
    status.workpieces_allowed = workpieces_allowed;
    status.log_directory = logs;
    status.kept = {.files = 7,
                   .bytes = 70,
                   .bytes_max = 1000,
                   .age_max_s = std::int64_t{48} * 3600,
                   .free_bytes = 5000,
                   .free_bytes_min = 0};
    return status;
  }
  void allow_workpieces(bool allowed) override { workpieces_allowed = allowed; }
  [[nodiscard]] std::optional<Expected<std::filesystem::path, recording::LogError>> start_log()
      override {
    if (log_file) return std::nullopt;
    log_file = "mill.lcm";
    return *log_file;
  }
  [[nodiscard]] std::optional<std::filesystem::path> stop_log() override {
    return std::exchange(log_file, std::nullopt);
  }
  void foresee(int, const std::string& program) override { looked_at.push_back(program); }
  void foreseen_begins(int, jobs::RunsOfChannels) override {}
  [[nodiscard]] jobs::Outlook outlook(int) override { return expected; }
  [[nodiscard]] runtime::LiveWorkpieces* live_workpieces() override { return nullptr; }
  [[nodiscard]] Scope& scope() override { return scope_now; }
  [[nodiscard]] std::shared_ptr<const jobs::PlannedPath> planned_path(int) override {
    return planned;
  }

  // Changed by tests, from another thread only within `change`.
  bool is_full = false;
  std::uint64_t withdrawn = 0;  // up to this id
  std::uint64_t taking = 0;     // the cycle has begun to take events up to this id
  bool workpieces_allowed = false;
  std::string choice = "embedded";
  std::vector<std::string> resets;
  std::vector<std::pair<std::string, plant::FaultKind>> faults;
  channels::CycleOutput output;
  channels::TablesConfig tables_now;
  Scope scope_now;
  std::vector<channels::RunReport> run_reports;
  std::vector<channels::AlarmReport> alarm_reports;
  std::optional<channels::SearchReport> searched;
  channels::SituationReport situation_report;
  std::optional<std::filesystem::path> log_file;
  std::vector<std::string> looked_at;  // programs
  jobs::Outlook expected;
  std::shared_ptr<jobs::PlannedPath> planned;
  std::vector<channels::AlarmReport> diagnostics;
  std::filesystem::path root = std::filesystem::temp_directory_path();
  std::filesystem::path logs;

 private:
  template <class Value>
  Value copy(const Value& value) {
    const std::lock_guard lock(mutex_);
    return value;
  }

  std::mutex mutex_;
  config::MachineFile file_;
  std::vector<channels::OperatorEvent> submitted_;
};

inline channels::OperatorReply accepted(std::uint64_t id) {
  channels::OperatorReply reply;
  reply.id = id;
  return reply;
}

inline channels::OperatorReply refused(std::uint64_t id, std::string_view code,
                                       std::string_view text) {
  channels::OperatorReply reply;
  reply.id = id;
  reply.ok = false;
  reply.code = FixedText<8>(code);
  reply.text = FixedText<240>(text);
  return reply;
}

}  // namespace stanok::daemon

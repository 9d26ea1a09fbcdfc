// AssembledMachine: the runtime's assembly between the real-time loop and the operator's side.
//
// The loop calls `cycle`; the operator server asks through RunningMachine; the publisher thread
// brings the outputs from which workpieces are cut. What passes from one to the other are the event
// queue, the newest output and the statistics of the loop.
#pragma once

#include <atomic>
#include <mutex>

#include "daemon/cycle/event_queue.h"
#include "daemon/cycle/newest_output.h"
#include "daemon/cycle/real_time_loop.h"
#include "daemon/cycle/running_machine.h"
#include "daemon/publish/publisher_thread.h"
#include "daemon/publish/recorder.h"
#include "daemon/scope/scope.h"
#include "runtime/assembly.h"

namespace stanok::daemon {

class AssembledMachine final : public RunningMachine, public CyclicWork, public CycleListener {
 public:
  // All outlive the machine.
  AssembledMachine(runtime::Assembly& assembly, Recorder& recorder,
                   std::filesystem::path program_root,
                   std::vector<std::filesystem::path> program_roots);

  // To be told before the server starts.
  void set_loop(RealTimeLoop& loop) { loop_ = &loop; }
  // Any thread.
  void set_real_time_rights(const RealTimeRights& rights);

  void cycle(std::int64_t lost) RT_SAFE override;

  void on_output(const channels::CycleOutput& output) override;

  [[nodiscard]] const config::MachineFile& file() const override { return assembly_.file(); }
  [[nodiscard]] const std::filesystem::path& program_root() const override { return program_root_; }
  [[nodiscard]] std::vector<std::filesystem::path> program_roots() const override {
    return program_roots_;
  }
  [[nodiscard]] bool submit(const channels::OperatorEvent& event) override {
    return events_.put(event);
  }
  [[nodiscard]] bool submit_stop(const channels::OperatorEvent& stop) override {
    return events_.put_stop(stop);
  }
  [[nodiscard]] std::uint64_t withdraw(std::uint64_t up_to_id) override {
    return events_.withdraw(up_to_id);
  }
  [[nodiscard]] std::optional<channels::OperatorReply> stop_reply() override;
  [[nodiscard]] std::uint64_t stops_taken() override { return events_.stops_put(); }
  [[nodiscard]] std::int64_t cycles() override { return cycles_; }
  [[nodiscard]] channels::CycleOutput newest_output() override { return newest_.get(); }
  [[nodiscard]] std::chrono::nanoseconds output_age() override { return newest_.age(); }
  [[nodiscard]] std::vector<channels::RunReport> runs() override {
    return assembly_.machine().runs();
  }
  [[nodiscard]] std::vector<channels::AlarmReport> alarms() override {
    return assembly_.machine().alarms();
  }
  [[nodiscard]] std::optional<channels::SearchReport> search(int channel) override {
    return assembly_.machine().search(channel);
  }
  [[nodiscard]] channels::SituationReport situation(
      const channels::ChannelOutput& output) override {
    return assembly_.machine().situation(output);
  }
  [[nodiscard]] std::vector<channels::AlarmReport> load_diagnostics() override {
    return assembly_.machine().load_diagnostics();
  }
  [[nodiscard]] channels::TablesConfig tables() override { return assembly_.machine().tables(); }
  void foresee(int channel, const std::string& program) override {
    foresight_.look_at(channel, program, newest_output(), tables());
  }
  void foreseen_begins(int channel, jobs::RunsOfChannels before) override {
    foresight_.begins(channel, std::move(before));
  }
  [[nodiscard]] jobs::Outlook outlook(int channel) override {
    return foresight_.outlook(channel, newest_output());
  }
  [[nodiscard]] std::shared_ptr<const jobs::PlannedPath> planned_path(int channel) override {
    return foresight_.planned_path(channel);
  }
  [[nodiscard]] runtime::LiveWorkpieces* live_workpieces() override { return &workpieces_; }
  [[nodiscard]] Scope& scope() override { return scope_; }
  [[nodiscard]] LoopStatistics loop_statistics() override;
  [[nodiscard]] RealTimeRights real_time_rights() override;
  [[nodiscard]] CycleLosses losses() override {
    return {.outputs = assembly_.outputs_lost(),
            .inputs = machine_.inputs_lost(),
            .replies = machine_.replies_lost()};
  }
  [[nodiscard]] std::string drive_choice() override;
  [[nodiscard]] drives::BusStatus drive_status() override { return assembly_.drive_status(); }
  [[nodiscard]] bool reset_drive(const std::string& drive) override {
    return assembly_.reset_drive(drive);
  }
  [[nodiscard]] bool inject_fault(const std::string& drive, plant::FaultKind fault) override {
    return assembly_.inject_fault(drive, fault);
  }
  [[nodiscard]] RecordingStatus recording_status() override { return recorder_.status(); }
  void allow_workpieces(bool allowed) override { recorder_.allow_workpieces(allowed); }
  [[nodiscard]] std::optional<Expected<std::filesystem::path, recording::LogError>> start_log()
      override {
    return recorder_.logs().start();
  }
  [[nodiscard]] std::optional<std::filesystem::path> stop_log() override {
    return recorder_.logs().stop();
  }

 private:
  runtime::Assembly& assembly_;
  channels::Machine& machine_;  // of the assembly
  Recorder& recorder_;
  std::filesystem::path program_root_;
  std::vector<std::filesystem::path> program_roots_;
  EventQueue events_;
  std::atomic<std::int64_t> cycles_{0};
  RealTimeLoop* loop_ = nullptr;
  NewestOutput newest_;
  std::mutex mutex_;  // of the rights
  RealTimeRights rights_;
  jobs::Foresight foresight_;
  runtime::LiveWorkpieces workpieces_;
  Scope scope_;
};

}  // namespace stanok::daemon

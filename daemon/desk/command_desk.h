// CommandDesk: operator commands on their way into the cycle and their answers on the way back.
//
// A command becomes an OperatorEvent with an id; the machine's reply with that id, some cycles
// later, becomes the answer. With `wait` "done" the answer to a start is kept until the run is
// over. When the cycle itself stands, everything that waits is answered with E9006. Belongs to the
// operator server's thread; `tick` wants to be called some 50 times a second.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/expected.h"
#include "channels/contract/operator_event.h"
#include "daemon/cycle/running_machine.h"
#include "daemon/desk/tables/table_watch.h"
#include "daemon/report/channel_notes.h"
#include "protocol/contract/failure.h"

namespace stanok::daemon {

using CommandResult = Expected<nlohmann::json, protocol::Failure>;
using Answer = std::function<void(const CommandResult&)>;
using SteadyTime = std::chrono::steady_clock::time_point;

// Afterwards the alarms of its channel have been seen.
[[nodiscard]] bool acknowledges_alarms(channels::OperatorAction action);

enum class WaitFor : std::uint8_t { accepted, end_of_run };

class CommandDesk {
 public:
  // Both outlive the desk; `notes` are kept up to date with what the machine accepted.
  CommandDesk(RunningMachine& machine, NotesOfChannels& notes) : machine_(machine), notes_(notes) {}

  // Calls `answer` once, now or later. The id of the event is given here.
  void submit(channels::OperatorEvent event, WaitFor wait, Answer answer);

  void on_reply(const channels::OperatorReply& reply);
  void tick(SteadyTime now);
  // For a command that another desk has had accepted.
  void note_acceptance(const channels::OperatorEvent& event);
  [[nodiscard]] TableWatch& tables() { return tables_; }
  // Of all that is accepted, once.
  void watch(std::function<void(const channels::OperatorEvent&)> on_accepted) {
    on_accepted_ = std::move(on_accepted);
  }

  [[nodiscard]] std::size_t waiting() const { return pending_.size() + awaited_.size(); }

 private:
  struct Pending {
    channels::OperatorEvent event;
    WaitFor wait = WaitFor::accepted;
    Answer answer;
    std::uint64_t diagnostics_before = 0;  // of loads, when the command was given
    jobs::RunsOfChannels runs_before{};    // likewise
  };
  struct AwaitedRun {
    int channel = 0;
    std::uint32_t run = 0;
    Answer answer;
    bool seen_ended = false;
  };

  [[nodiscard]] protocol::Failure refusal(const Pending& pending,
                                          const channels::OperatorReply& reply) const;
  [[nodiscard]] bool is_in_alarm(int channel) const;
  void look_again();
  void await_run(int channel, Answer answer);
  void answer_ended_runs();
  void watch_cycle(SteadyTime now);

  RunningMachine& machine_;
  NotesOfChannels& notes_;
  std::function<void(const channels::OperatorEvent&)> on_accepted_;
  std::uint64_t last_id_ = 0;
  std::map<std::uint64_t, Pending> pending_;
  std::vector<AwaitedRun> awaited_;
  TableWatch tables_{machine_};
  bool tables_have_changed_ = false;
  std::int64_t newest_cycle_ = -1;
  SteadyTime newest_cycle_seen_{};
};

// The result of a run that is over: {"program","ok","blocks","path_mm","time_s"}, or why it ended.
[[nodiscard]] CommandResult command_result(const channels::RunReport& run,
                                           const std::vector<channels::AlarmReport>& alarms,
                                           double cycle_s);

}  // namespace stanok::daemon

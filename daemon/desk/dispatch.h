// Dispatch: one request of one session in, its answer out.
//
// Looks the method up in the command table, checks role and parameters, then hands the command to
// the machine (CommandDesk) or answers itself, by a line of `handlers`. No sockets; belongs to the
// operator server's thread.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "daemon/cycle/asked_at.h"
#include "daemon/desk/channel_control.h"
#include "daemon/desk/command_desk.h"
#include "daemon/desk/command_log.h"
#include "daemon/desk/log_desk.h"
#include "daemon/desk/program_desk.h"
#include "daemon/desk/program_queue.h"
#include "daemon/desk/subscription.h"
#include "daemon/desk/surface_desk.h"
#include "daemon/desk/tables/kept_answers.h"
#include "daemon/desk/tables/touch_desk.h"
#include "daemon/report/measurement_notes.h"
#include "daemon/report/status_report.h"
#include "protocol/contract/json_rpc.h"

namespace stanok::daemon {

// Who asks, and what was agreed with it.
struct SessionState {
  int id = 0;
  protocol::Role role = protocol::Role::observer;
  std::string peer;       // for logs: "uid 1000, pid 4711"
  bool is_named = false;  // who works there was told
  Subscription subscription;
  AskedAt asked_at;  // the current request
};

// Parameters of the server's first message; any thread.
[[nodiscard]] nlohmann::json greeting(RunningMachine& machine, const SessionState& session);
// Numbers and names of its channels.
[[nodiscard]] nlohmann::json channel_names(const config::MachineFile& file);

// What the daemon knows of itself, for system.info.
struct DaemonDescription {
  std::string build;
  std::filesystem::path state_directory;
  std::filesystem::path socket;
  KeepTables keep_tables{};
  Journal* journal = nullptr;  // outlives the server; nullptr: none
};

class Dispatch {
 public:
  // All outlive the dispatch. `on_shutdown` begins the orderly end and returns.
  Dispatch(RunningMachine& machine, DaemonDescription description,
           std::function<void()> on_shutdown);

  // Calls `answer` once, now or later; the session may be gone by then.
  void handle(SessionState& session, const protocol::RpcRequest& request, Answer answer);

  void on_reply(const channels::OperatorReply& reply) { desk_.on_reply(reply); }
  void on_event(const channels::Event& event) { measurements_.take(event); }
  void tick(SteadyTime now) {
    tell_control();
    desk_.tick(now);
    programs_.tick();
    queue_.tick();
    surfaces_.tick();
    logs_.tick();
    kept_answers_.tick();
  }
  void set_clients(std::size_t clients) { service_.clients = clients; }
  // The session has ended.
  void forget(int session);

  // A stop that the reception took was accepted.
  void note_stop(const channels::OperatorEvent& stop) { desk_.note_acceptance(stop); }

  // Any thread.
  [[nodiscard]] CommandLog command_log() const { return CommandLog(description_.journal); }

  // What a subscription shows.
  [[nodiscard]] nlohmann::json snapshot(const Subscription& subscription) const;

 private:
  // A request that was admitted.
  struct Call {
    SessionState& session;
    const protocol::Method& method;
    const protocol::RpcRequest& request;
    const nlohmann::json& parameters;
    Answer answer;
  };
  // What the daemon answers itself: what it sees; what it has done at once; a task that answers
  // now or later.
  using Query = nlohmann::json (*)(Dispatch& self, const nlohmann::json& parameters);
  using Order = CommandResult (*)(Dispatch& self, const Call& call);
  using Task = void (*)(Dispatch& self, Call call);
  using Handler = std::variant<Query, Order, Task>;
  // By method: a line for every one that does not go to the machine.
  [[nodiscard]] static const std::map<std::string_view, Handler>& handlers();

  void command(const Call& call);
  [[nodiscard]] static AskedAt asked_at(const Call& call);
  [[nodiscard]] CommandResult start_queue(const Call& call);
  // An answer that notes what has changed of the tables, where it is no refusal, and is given when
  // the disk has it.
  [[nodiscard]] Answer noted(const SessionState& session, Answer answer);
  void note_control();
  void note_seen(const channels::OperatorEvent& accepted) const;
  void control_channel(Call call);
  void tell_control();
  void tell_control(int channel, Answer answer);
  [[nodiscard]] CommandResult start_log() const;
  [[nodiscard]] CommandResult stop_log() const;
  void load_tables(Call call);
  void write_program(Call call);
  void remove_program(Call call);
  using QueueChange = void (ProgramQueue::*)(const nlohmann::json& parameters, int channel,
                                             Answer answer);
  using Touch = void (TouchDesk::*)(const nlohmann::json&, int, Answer);
  void touch(Call call, Touch way);
  void undo_touch(Call call);
  void change_queue(Call call, QueueChange change);
  [[nodiscard]] Answer logged(const Call& call, Answer answer, nlohmann::json shown) const;
  [[nodiscard]] CommandResult tool_get(const nlohmann::json& parameters) const;
  [[nodiscard]] CommandResult reset_drive(const Call& call);
  [[nodiscard]] CommandResult make_drive_fail(const Call& call);
  [[nodiscard]] CommandResult allow_workpieces(const nlohmann::json& parameters);
  void shut_down(const Call& call);
  [[nodiscard]] static CommandResult lower_role(const Call& call);
  [[nodiscard]] static CommandResult subscribe(const Call& call, const nlohmann::json& topics,
                                               int channel);
  [[nodiscard]] int channel_or_first(const nlohmann::json& parameters) const;
  [[nodiscard]] nlohmann::json system_info() const;

  RunningMachine& machine_;
  DaemonDescription description_;
  NotesOfChannels notes_;
  ChannelControl control_;
  std::map<int, int> told_control_;  // session by channel, as the cycle was told; -1: not known
  CommandDesk desk_;
  TouchDesk touches_;
  ProgramDesk programs_;
  ProgramQueue queue_;
  SurfaceDesk surfaces_;
  LogDesk logs_;
  KeptAnswers kept_answers_;
  StatusReport report_;
  MeasurementNotes measurements_;
  // How the daemon came to be and how it ends, and who looks at it.
  struct Service {
    std::size_t clients = 0;
    SteadyTime started;
    std::function<void()> on_shutdown;
  };
  Service service_;
};

}  // namespace stanok::daemon

#include "daemon/start/daemon.h"

#include <pwd.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <chrono>
#include <optional>
#include <string_view>
#include <thread>

#include "daemon/cycle/preparation_threads.h"
#include "daemon/host/signals.h"
#include "daemon/host/state_directory.h"
#include "daemon/publish/reply_thread.h"
#include "daemon/publish/report_listener.h"
#include "daemon/server/operator_server.h"
#include "daemon/start/assembled_machine.h"
#include "daemon/start/kept_state.h"
#include "daemon/start/machine_history.h"
#include "daemon/start/scope_feed.h"
#include "protocol/contract/socket_location.h"
#include "protocol/contract/version.h"
#include "runtime/standard_cycles.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ns_per_us = 1000;
constexpr int real_time_priority =
    80;  // above what the system runs by default, below its watchdogs
constexpr int drive_bus_priority = 60;
constexpr int exit_machine_fault = 7;
// Before an input is missing in the recording; setpoints are missing after a second.
constexpr double recorder_may_be_late_s = 30.0;

std::string build_description() {
#ifdef __OPTIMIZE__
  constexpr const char* kind = "optimised";
#else
  constexpr const char* kind = "not optimised";
#endif
#ifdef __clang__
  return "clang " + std::string(__clang_version__) + ", " + kind;
#else
  return "g++ " + std::string(__VERSION__) + ", " + kind;
#endif
}

RecorderOptions recorder_options(const DaemonOptions& options, const config::MachineFile& file,
                                 const fs::path& state) {
  RecorderOptions chosen;
  if (options.lcm != "off") chosen.lcm_url = options.lcm.empty() ? file.lcm_url : options.lcm;
  chosen.logs_from_start = !options.log_directory.empty();
  chosen.log_directory = file.recorder.directory.empty() ? state / "log" : file.recorder.directory;
  if (chosen.logs_from_start) chosen.log_directory = options.log_directory;
  return chosen;
}

runtime::AssemblyOptions assembly_options(const DaemonOptions& options,
                                          const config::MachineFile& file,
                                          const fs::path& program_root) {
  runtime::AssemblyOptions chosen;
  chosen.file = file;
  chosen.drives = options.drives.value_or(runtime::DriveChoice::embedded);
  chosen.machine.changes_kept_s = recorder_may_be_late_s;
  chosen.steady_at_rest = true;
  chosen.program_roots = runtime::standard_cycle_folders();
  chosen.program_roots.insert(chosen.program_roots.begin(), program_root);
  return chosen;
}

// Where nobody has said what others may write (umask 000), they may write nothing.
void protect_files_from_others() {
  constexpr ::mode_t usual = 0022;
  const ::mode_t given = ::umask(usual);
  if ((given & S_IWOTH) != 0) ::umask(given);
}

// Those who watch hear of alarms that no cycle raises while this lives.
class Announcement {
 public:
  Announcement(MachineHistory& history, OperatorServer& server) : history_(history) {
    history.announce_to([&server](const channels::Event& event) { server.on_event(event); });
  }
  ~Announcement() { history_.announce_to({}); }
  Announcement(const Announcement&) = delete;
  Announcement& operator=(const Announcement&) = delete;

 private:
  MachineHistory& history_;
};

// What cannot be recorded is told to operators while this lives.
class TroubleOfRecording {
 public:
  TroubleOfRecording(Recorder& recorder, ReportListener& reports, MachineHistory& history)
      : recorder_(recorder) {
    const auto tell = [&history](const std::string& why) { history.tell("E9026", why); };
    recorder.tell_trouble_to(tell);
    reports.tell_trouble_to(tell);
  }
  ~TroubleOfRecording() { recorder_.tell_trouble_to({}); }
  TroubleOfRecording(const TroubleOfRecording&) = delete;
  TroubleOfRecording& operator=(const TroubleOfRecording&) = delete;

 private:
  Recorder& recorder_;
};

// The real-time thread; its rights are taken before its first cycle and told once.
class RealTimeThread {
 public:
  RealTimeThread(RealTimeLoop& loop, AssembledMachine& machine)
      : loop_(loop), thread_([&loop, &machine] {
          const RealTimeRights rights = take_real_time_rights(real_time_priority);
          for (const std::string& note : rights.notes) spdlog::warn("real time: {}", note);
          machine.set_real_time_rights(rights);
          loop.run();
        }) {}
  ~RealTimeThread() {
    loop_.stop();
    thread_.join();
  }
  RealTimeThread(const RealTimeThread&) = delete;
  RealTimeThread& operator=(const RealTimeThread&) = delete;

 private:
  RealTimeLoop& loop_;
  std::thread thread_;
};

CycleRings rings_of(runtime::Assembly& assembly) {
  channels::Machine& machine = assembly.machine();
  return {assembly.outputs(), machine.events(), machine.input_records(), machine.input_changes(),
          [&assembly] { return assembly.program_reads(); }};
}

// Nothing: none is named, or the system has no such user, which keeps no machine from running.
std::optional<uid_t> panel_user(const std::string& name) {
  if (name.empty()) return std::nullopt;
  const passwd* entry = ::getpwnam(name.c_str());  // NOLINT(concurrency-mt-unsafe): at start
  if (entry != nullptr) return entry->pw_uid;
  spdlog::warn("there is no user {}: pages served by this user have the rights of the socket",
               name);
  return std::nullopt;
}

// The drive bus runs while this lives. Late answers trip the drives' watchdogs.
struct RunningDrives {
  explicit RunningDrives(runtime::Assembly& used) : assembly(used) {
    const FifoForNewThreads fifo(drive_bus_priority);
    assembly.start();
  }
  ~RunningDrives() { assembly.stop(); }
  RunningDrives(const RunningDrives&) = delete;
  RunningDrives& operator=(const RunningDrives&) = delete;
  runtime::Assembly& assembly;
};

// Before it nobody knows how the channels stand; whoever asked would be told zeros. Not for ever: a
// cycle that does not come is the server's to tell.
void wait_for_the_first_cycle(AssembledMachine& machine, const std::atomic<bool>& gives_up) {
  constexpr auto longest = std::chrono::seconds(5);
  constexpr auto between_looks = std::chrono::milliseconds(1);
  const auto last = std::chrono::steady_clock::now() + longest;
  while (machine.newest_output().cycle == 0 && !gives_up && std::chrono::steady_clock::now() < last)
    std::this_thread::sleep_for(between_looks);
}

}  // namespace

int run_daemon(const DaemonOptions& options) {
  ignore_harmless_signals();
  protect_files_from_others();
  config::MachineFile file = config::read_machine_file(options.machine_file);
  const std::string& name = file.machine.name;
  const fs::path program_root =
      options.program_root.empty() ? fs::current_path() : fs::absolute(options.program_root);
  const StateDirectory state(options.state_directory.empty()
                                 ? protocol::default_state_directory(name)
                                 : options.state_directory);
  load_state(state.path(), file.machine);
  ListeningSocket socket(options.socket.empty() ? protocol::default_socket(name, state.path())
                                                : options.socket);

  std::optional<FifoForNewThreads> fifo(drive_bus_priority);  // the server of embedded drives
  std::atomic<bool> ends{false};  // nothing waits for a program that is being compiled
  runtime::AssemblyOptions assembled = assembly_options(options, file, program_root);
  assembled.machine.gives_up = [&ends] { return ends.load(std::memory_order_relaxed); };
  runtime::Assembly assembly(assembled);
  fifo.reset();
  const RecorderOptions recording = recorder_options(options, file, state.path());
  Recorder recorder(file, build_description(), recording);
  ReportListener reports(recording.log_directory, file.machine.name);
  AssembledMachine machine(assembly, recorder, program_root, assembled.program_roots);
  MonotonicClock clock;
  RealTimeLoop loop(machine, clock, file.machine.cycle_us * ns_per_us);
  machine.set_loop(loop);
  recorder.ask_for_situations(
      [&machine](const channels::ChannelOutput& output) { return machine.situation(output); });
  MachineHistory history(state.path(), machine, assembly.machine());
  const TroubleOfRecording trouble(recorder, reports, history);
  KeptState kept(state.path(), machine,
                 [&history](std::string_view what, const std::string& fault) {
                   history.tell_not_kept(std::string(what), fault);
                 });
  OperatorServer server(
      socket, machine,
      {build_description(), state.path(), socket.path(),
       [&kept](KeepDone done) { kept.keep_tables(std::move(done)); }, &history.journal()},
      {.panel_user = panel_user(options.panel_user)});
  const Announcement announcement(history, server);

  // First the stop: what is said may need memory.
  const auto fail = [&](std::string_view who, std::string_view name, std::string_view reason) {
    server.fail();
    ends = true;
    spdlog::critical("{}{} failed: {}; the machine is stopped", who, name, reason);
  };
  const RunningDrives drives(assembly);
  ScopeFeed scope_feed(machine.scope(), loop);
  const PublisherThread publisher(
      rings_of(assembly), {&recorder, &machine, &server, &scope_feed, &reports},
      [&](std::string_view reason) { fail("the publisher", "", reason); });
  const ReplyThread replies(
      assembly.machine().replies(), [&] { return machine.cycles(); },
      [&](const channels::OperatorReply& reply) { server.on_reply(reply); },
      [&](std::string_view reason) { fail("the hand-over of replies", "", reason); });
  const PreparationThreads preparation(
      static_cast<int>(file.machine.channels.size()),
      [&](int index) { return assembly.machine().prepare(index); },
      [&](int index) { return assembly.machine().is_urgent(index); },
      [&](int index, std::string_view reason) {
        fail("the preparation of channel ", file.machine.channels[index].name, reason);
      });
  const RealTimeThread real_time(loop, machine);
  spdlog::info("stanokd {} runs {}: cycle {} us, drives {}, socket {}", protocol::version, name,
               file.machine.cycle_us, machine.drive_choice(), socket.path().string());
  history.begin();
  wait_for_the_first_cycle(machine, ends);
  server.run();
  ends = true;
  spdlog::info("stanokd ends");
  return server.has_failed() ? exit_machine_fault : 0;
}

}  // namespace stanok::daemon

// RunningMachine: what the operator's side may ask of the machine that runs.
//
// Everything here is called from the operator server's thread, but for what stops and the orderly
// end need, which is the reception's; nothing of it waits for the cycle. Tests put a machine of
// their own behind it.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "daemon/cycle/real_time_loop.h"
#include "daemon/host/real_time_rights.h"
#include "drives/bus.h"
#include "jobs/foresight/foresight.h"
#include "plant/drive/fault.h"
#include "recording/log/log_writer.h"
#include "runtime/workpiece/live_workpieces.h"

namespace stanok::daemon {

class Scope;

// The logs and flight files that the disk keeps, and their bounds; a bound of 0 is none.
struct KeptLogsStatus {
  std::int64_t files = 0;
  std::int64_t bytes = 0;
  std::int64_t bytes_max = 0;
  std::int64_t age_max_s = 0;
  std::optional<std::int64_t> free_bytes;  // on their disk; nothing: it does not say
  std::int64_t free_bytes_min = 0;
};

// Where the records of the machine go.
struct RecordingStatus {
  std::string lcm_url;  // empty: switched off
  bool lcm_open = false;
  std::int64_t lcm_sent = 0;
  std::int64_t lcm_lost = 0;
  std::filesystem::path log_directory;
  std::string log_file;  // empty: no log is written
  std::int64_t log_bytes = 0;
  std::int64_t log_events = 0;
  std::string log_error;   // why logging stopped; empty: it did not
  bool log_rests = false;  // it goes on when there is room
  KeptLogsStatus kept;
  bool workpieces_allowed = false;
  std::string flight_file;  // what the flight recorder wrote last; empty: nothing
};

// What found no room on its way out of the cycle, since the start.
struct CycleLosses {
  std::uint64_t outputs = 0;  // the recorder was too late for them
  std::uint64_t inputs = 0;   // likewise
  std::uint64_t replies = 0;  // to who had asked for something
};

class RunningMachine {
 public:
  RunningMachine() = default;
  virtual ~RunningMachine() = default;
  RunningMachine(const RunningMachine&) = delete;
  RunningMachine& operator=(const RunningMachine&) = delete;

  [[nodiscard]] virtual const config::MachineFile& file() const = 0;
  [[nodiscard]] virtual const std::filesystem::path& program_root() const = 0;
  // Where programs are looked for, that root first.
  [[nodiscard]] virtual std::vector<std::filesystem::path> program_roots() const = 0;

  // Into the next cycle. False: no room.
  [[nodiscard]] virtual bool submit(const channels::OperatorEvent& event) = 0;
  // The same for a stop; reception's thread. Waits for nothing at all.
  [[nodiscard]] virtual bool submit_stop(const channels::OperatorEvent& stop) = 0;
  // The next reply to one; reception's thread. Waits for nothing at all.
  [[nodiscard]] virtual std::optional<channels::OperatorReply> stop_reply() = 0;
  // How many of them were taken so far; reception's thread.
  [[nodiscard]] virtual std::uint64_t stops_taken() = 0;
  // Cycles so far; any thread.
  [[nodiscard]] virtual std::int64_t cycles() = 0;

  // What waits with an id up to this one takes no effect any more, but for what the cycle has begun
  // to take: the newest id of that. One thread, that of `submit`.
  [[nodiscard]] virtual std::uint64_t withdraw(std::uint64_t up_to_id) = 0;

  // The output of the newest cycle; cycle 0 before the first one.
  [[nodiscard]] virtual channels::CycleOutput newest_output() = 0;
  // How long ago that was.
  [[nodiscard]] virtual std::chrono::nanoseconds output_age() = 0;
  [[nodiscard]] virtual std::vector<channels::RunReport> runs() = 0;
  [[nodiscard]] virtual std::vector<channels::AlarmReport> alarms() = 0;
  [[nodiscard]] virtual std::vector<channels::AlarmReport> load_diagnostics() = 0;
  [[nodiscard]] virtual channels::TablesConfig tables() = 0;
  // Where the next run of a channel begins; nothing: at the first block.
  [[nodiscard]] virtual std::optional<channels::SearchReport> search(int channel) = 0;

  // What gives the words of a channel their meaning, as its output tells it.
  [[nodiscard]] virtual channels::SituationReport situation(
      const channels::ChannelOutput& output) = 0;

  // What is known beforehand of programs (foresight.h): one was loaded; it begins, with the runs
  // that were there when it was asked for; what is to be expected of a channel.
  virtual void foresee(int channel, const std::string& program) = 0;
  virtual void foreseen_begins(int channel, jobs::RunsOfChannels before) = 0;
  [[nodiscard]] virtual jobs::Outlook outlook(int channel) = 0;
  // nullptr: nothing is known of it.
  [[nodiscard]] virtual std::shared_ptr<const jobs::PlannedPath> planned_path(int channel) = 0;
  // What is cut while the machine runs; nullptr: nobody follows it. Lives as long as the machine.
  [[nodiscard]] virtual runtime::LiveWorkpieces* live_workpieces() = 0;

  [[nodiscard]] virtual Scope& scope() = 0;
  [[nodiscard]] virtual LoopStatistics loop_statistics() = 0;
  [[nodiscard]] virtual RealTimeRights real_time_rights() = 0;
  [[nodiscard]] virtual CycleLosses losses() = 0;
  // "ideal", "embedded", "real".
  [[nodiscard]] virtual std::string drive_choice() = 0;
  [[nodiscard]] virtual drives::BusStatus drive_status() = 0;
  // Acknowledges the fault of a drive. False: no such drive.
  [[nodiscard]] virtual bool reset_drive(const std::string& drive) = 0;
  // Makes an embedded drive fail, or work again. False: no such drive.
  [[nodiscard]] virtual bool inject_fault(const std::string& drive, plant::FaultKind fault) = 0;
  [[nodiscard]] virtual RecordingStatus recording_status() = 0;
  // Announcements of workpieces are recorded and published only while they are allowed.
  virtual void allow_workpieces(bool allowed) = 0;
  // The new log file, or why it cannot be made; nothing: one is being written.
  [[nodiscard]] virtual std::optional<Expected<std::filesystem::path, recording::LogError>>
  start_log() = 0;
  // The log file that ends; nothing: there is none.
  [[nodiscard]] virtual std::optional<std::filesystem::path> stop_log() = 0;
};

}  // namespace stanok::daemon

// StatusReport: the state of the machine as JSON, as the methods that only look answer it.
//
// The members are those of docs/reference/protocol.md, "Results". States carry the words of OPC
// 40501 (channel state) and OPC 40502 (program status). Belongs to the operator server's thread.
#pragma once

#include <map>
#include <nlohmann/json.hpp>

#include "daemon/cycle/running_machine.h"
#include "daemon/report/channel_notes.h"
#include "jobs/foresight/part_place.h"
#include "simulation/machine_geometry.h"

namespace stanok::daemon {

class StatusReport {
 public:
  // Both outlive the report.
  StatusReport(RunningMachine& machine, const NotesOfChannels& notes);

  [[nodiscard]] nlohmann::json machine() const;
  [[nodiscard]] nlohmann::json channel_list() const;
  // The channel exists.
  [[nodiscard]] nlohmann::json channel(int id) const;
  // All channels by their number, as subscriptions send them.
  [[nodiscard]] nlohmann::json channels() const;
  [[nodiscard]] nlohmann::json kinematics_list(int channel) const;
  [[nodiscard]] nlohmann::json kinematics(int channel) const;
  // Feed law, feed and speed of the cutting process.
  [[nodiscard]] nlohmann::json process(int channel) const;
  // `channel` 0: of all channels.
  [[nodiscard]] nlohmann::json alarms_standing(int channel) const;
  [[nodiscard]] nlohmann::json alarm_history(int channel) const;
  // Runs of one channel, or of all for 0, in the order of their start.
  [[nodiscard]] nlohmann::json program_history(int channel) const;

 private:
  // What the machine has beside its newest output.
  struct Books {
    std::int64_t cycle = 0;  // that newest one
    std::vector<channels::AlarmReport> alarms;
    std::vector<channels::RunReport> runs;
    channels::TablesConfig tables;
    drives::BusStatus bus;
  };
  [[nodiscard]] nlohmann::json tool_direction(const channels::ChannelOutput& output) const;
  [[nodiscard]] nlohmann::json on_part(const channels::ChannelOutput& output,
                                       const jobs::PlannedPath* path) const;
  enum class AlarmChoice : std::uint8_t { all, active };
  [[nodiscard]] Books books(std::int64_t cycle) const;
  [[nodiscard]] nlohmann::json channel(const channels::ChannelConfig& config,
                                       const channels::ChannelOutput& output,
                                       const Books& books) const;
  [[nodiscard]] nlohmann::json alarm_rows(int channel, AlarmChoice choice) const;
  [[nodiscard]] ChannelNotes notes_of(int channel) const;
  [[nodiscard]] bool is_active(const channels::AlarmReport& alarm,
                               const channels::CycleOutput& output) const;

  RunningMachine& machine_;
  const NotesOfChannels& notes_;
  std::map<int, simulation::MachineGeometry> geometries_;  // by channel
  std::map<int, jobs::PartPlace> part_places_;             // likewise
};

// An alarm as clients get it, with what the catalogue says of it.
[[nodiscard]] nlohmann::json alarm_json(const channels::AlarmReport& alarm);
// A channel of the machine by its id.
[[nodiscard]] const channels::ChannelConfig& config_of(const channels::MachineConfig& machine,
                                                       int channel);
// Output of a channel by its id; the output of a channel that has none yet is all zeros.
[[nodiscard]] channels::ChannelOutput output_of(const channels::CycleOutput& output, int channel);

}  // namespace stanok::daemon

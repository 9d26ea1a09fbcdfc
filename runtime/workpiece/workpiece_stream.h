// WorkpieceStream: the virtual workpieces of a machine out of its LCM messages, recorded or live.
//
// Setpoints lead the tools, TOOL says which, TOOL_ROW how they are, PROCESS whether the spindle
// turns, WORKPIECE what is cut; program texts give names to the runs. Messages of other machines
// are left alone.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <stanok_messages/setpoint_t.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lang/contract/environment.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::runtime {

class WorkpieceStream {
 public:
  // Takes what cannot be followed: channel, code of the catalogue and text.
  using Complaint =
      std::function<void(int channel, const std::string& code, const std::string& text)>;
  // Of the programs by channel and run, the program itself first.
  using FilesOfRuns = std::map<std::pair<int, std::uint32_t>, std::vector<std::string>>;

  // `machine` and `texts` outlive it. `texts`: of the programs, for the names of files that they
  // include and call; nullptr: not to be had.
  WorkpieceStream(const channels::MachineConfig& machine, std::uint64_t memory_max,
                  const Complaint& complain, const lang::Files* texts = nullptr);

  // A message on the LCM channel of that name.
  void take(std::string_view channel_name, std::span<const std::uint8_t> bytes);

  // Machine time of the latest setpoint, s.
  [[nodiscard]] double time_s() const { return time_s_; }
  // Setpoints that did not come, of all channels, and when the first of them was due.
  struct Missing {
    std::int64_t count = 0;
    double first_s = 0.0;
  };
  [[nodiscard]] const Missing& missing() const { return missing_; }
  // Of a channel of the machine; nullptr: it has no such channel.
  [[nodiscard]] ChannelFeed* feed(int channel);
  // Of all channels with axes.
  [[nodiscard]] std::vector<ChannelFeed*> feeds();
  [[nodiscard]] FilesOfRuns files() const;

 private:
  struct Followed {
    std::unique_ptr<ChannelFeed> feed;
    WorkpieceNews news;
    channels::ToolAtWork tool;
    double spindle_rev_per_min = 0.0;
    std::int64_t next_cycle = 0;                              // of its setpoints; 0: none came yet
    std::map<std::uint32_t, std::vector<std::string>> files;  // of the programs, by run
  };

  [[nodiscard]] Followed* followed(int channel);
  template <class Message, class Use>
  void take_of_channel(std::span<const std::uint8_t> bytes, Use use);
  void follow(const setpoint_t& setpoint);
  void count_missing(Followed& channel, std::int64_t cycle);
  [[nodiscard]] std::vector<std::string> files_of_program() const;

  const lang::Files* texts_;
  std::string prefix_;  // of the names of the machine's channels
  double cycle_s_;
  double time_s_ = 0.0;
  Missing missing_;
  std::map<int, Followed> channels_;
  std::string program_;  // read last for an operator or a channel, not for another program
};

}  // namespace stanok::runtime

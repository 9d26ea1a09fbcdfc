// ChannelNotes: what the operator's side remembers of a channel beyond its newest output.
//
// Written when the machine has accepted a command; belongs to the operator server's thread.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace stanok::daemon {

// Programs that wait (program_queue.h).
struct QueueNotes {
  std::size_t programs = 0;
  bool is_started = false;
  std::uint64_t version = 0;  // another one with every change
};

struct ChannelNotes {
  std::string program;  // loaded last
  double rapid_override_percent = 100.0;
  double spindle_override_percent = 100.0;
  bool single_block = false;
  bool optional_stop = false;
  bool first_part = false;
  std::set<int> levels_skipped;  // block skip
  std::string controlled_by;     // a session; empty: nobody alone
  // Numbers of the newest alarm that was. What is cleared is never active again.
  std::uint64_t alarms_acknowledged = 0;
  std::uint64_t alarms_cleared = 0;
  QueueNotes queue;
};

// By channel id.
using NotesOfChannels = std::map<int, ChannelNotes>;

}  // namespace stanok::daemon

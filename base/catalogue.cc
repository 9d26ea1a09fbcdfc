#include "base/catalogue.h"

#include <algorithm>
#include <array>

namespace stanok {
namespace {

constexpr auto end = Reaction::program_end;

// Sorted by code. One line a row: code, title, reaction, remedy, how to go on.
constexpr auto rows = std::to_array<CatalogueRow>({
    {"A1001", "emergency stop by an operator", Reaction::all_axes_off, "find and remove the cause",
     "reset the channels, switch the machine on and start again"},
    {"A3001", "a drive does not answer", Reaction::feed_hold,
     "check power and bus of the drive; drive status shows which one",
     "reset the channel and switch the machine on"},
    {"A3002", "a drive reports a fault", Reaction::axis_stop,
     "see the fault code in drive status and the manual of the drive",
     "clear the fault, reset the channel and switch the machine on"},
    {"E4021", "feed per revolution while the spindle stands", end,
     "program S and M3 or M4 before the move, or feed per minute with G94",
     "correct the program and start it again"},
    {"E5101", "a pose is beyond an axis limit", end,
     "check work offset, tool length and kinematic scheme, or move the workpiece",
     "correct the cause and start the program again"},
    {"E5201", "the channel has no such kinematic scheme", end,
     "name a scheme of the machine file; kinematics list shows them",
     "correct the program and start it again"},
    {"E5202", "the channel whose kinematics shall change is running or held", end,
     "wait for the end of its program with channel_wait before #kinematics",
     "correct the program and start it again"},
    {"E5204", "a parked position is beyond the limits of its axis", end,
     "correct the parked position in the scheme file",
     "correct the scheme file and restart the runtime"},
    {"E6001", "no such channel", end, "name a channel of the machine file; channel list shows them",
     "give the command again"},
    {"E6002", "too many commands at once", end, "wait for the answers to the commands before",
     "give the command again"},
    {"E6003", "the channel is running or held", end, "wait for its program to end, or stop it",
     "give the command again"},
    {"E6004", "the channel has an alarm", end, "find and remove the cause, then reset the channel",
     "reset the channel and start again"},
    {"E6005", "no program is loaded", end, "load a program first", "load and start"},
    {"E6006", "the machine is off", end, "switch it on: stanok machine on", "start again"},
    {"E6007", "nothing was running", end, "nothing needs to be done", "go on"},
    {"E6010", "the awaited program ended abnormally or too late", end,
     "see the alarm of the channel that was awaited", "reset both channels and start again"},
    {"E6020", "channels would wait for each other for ever", end,
     "break the circle of channel_wait calls named in the text",
     "correct the programs and start again"},
    {"E7001", "file not found", end, "check the name and the program root",
     "correct the program and load it again"},
    {"E7002", "a file name that must not be used", end,
     "name the file relative to the program root, without ..",
     "correct the program and load it again"},
    {"E7003", "not a regular file", end, "name a file, not a folder, pipe or device",
     "correct the program and load it again"},
    {"E7004", "a file cannot be read", end, "check the permissions of the file",
     "load the program again"},
    {"E9001", "not a request", Reaction::warning,
     "send one JSON-RPC 2.0 request per line, at most 1 MiB (docs/protocol.md)",
     "send the request again"},
    {"E9002", "unknown method", Reaction::warning, "rpc.discover lists all methods",
     "send the request again"},
    {"E9003", "wrong parameter", Reaction::warning,
     "compare the parameters with rpc.discover or stanok NOUN VERB --help",
     "give the command again"},
    {"E9004", "not permitted", Reaction::warning,
     "use a connection with the role that the method needs", "give the command again"},
    {"E9005", "not supported in this release", Reaction::warning,
     "see docs/protocol.md for what is there", "use another command"},
    {"E9006", "the machine does not answer", Reaction::warning,
     "look at stanok machine status and at the daemon's log: the real-time cycle stands or is late",
     "give the command again"},
    {"E9007", "too many requests at once", Reaction::warning,
     "wait for the answers to the requests before; stops are still accepted",
     "give the command again"},
    {"E9008", "too many clients", Reaction::warning, "close connections that are not needed",
     "connect again"},
    {"E9009", "the client does not read", Reaction::warning,
     "read what the daemon sends, or subscribe to less", "connect again"},
    {"E9010", "the program was ended before its end", Reaction::warning,
     "somebody stopped or reset the channel, or the daemon ends", "start the program again"},
    {"W0001", "warning of a program", Reaction::warning,
     "see the text; it comes from warn() in the program", "nothing needs to be done"},
    {"W2099", "M99 in the main program ends the run", Reaction::warning, "end the program with M30",
     "nothing needs to be done"},
});

}  // namespace

std::span<const CatalogueRow> catalogue() {
  return rows;
}

const CatalogueRow* find_in_catalogue(std::string_view code) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const CatalogueRow& r) { return r.code == code; });
  return row == rows.end() ? nullptr : &*row;
}

}  // namespace stanok

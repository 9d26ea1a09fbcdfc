// TableLoading: the tools and work offsets of a text become those of the machine, value by value.
//
// Each value that differs is a command of its own to the machine, as if an operator had set it: it
// is refused while a program runs, recorded, and comes out the same in a replay. Entries that the
// text does not name keep their values. Belongs to the operator server's thread.
#pragma once

#include <string>
#include <vector>

#include "daemon/desk/command_desk.h"

namespace stanok::daemon {

// The commands that make the machine's tables those of `text`, in the form of the tables file
// (docs/reference/configuration.md#tables-file); `name` stands for the text in
// messages. All of it is refused for one fault: E9014, or E9015 for what is fixed when the daemon
// starts; and for values that are not likely, E6095, unless they are confirmed.
enum class Confirmed { no, yes };
[[nodiscard]] Expected<std::vector<channels::OperatorEvent>, protocol::Failure> commands_to_load(
    RunningMachine& machine, const std::string& text, const std::string& name, Confirmed confirmed);

// Gives one command after the other and answers {"values": how many}, or with the refusal of the
// first one that is refused. The desk outlives it.
void submit_one_by_one(CommandDesk& desk, std::vector<channels::OperatorEvent> commands,
                       Answer answer);

}  // namespace stanok::daemon

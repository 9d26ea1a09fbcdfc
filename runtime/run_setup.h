// RunSetup: what a run depends on before its first cycle, to a log and back.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "recording/stream/message_stream.h"

namespace stanok::runtime {

struct RunSetup {
  channels::MachineOptions options{};
  std::vector<std::pair<int, int>>
      schemes{};               // channel, scheme at start; the others by machine file
  bool unnamed_tools = true;   // as in MachineConfig
  channels::AxisRow starts{};  // where axes stand at first; the others by machine file
};

// One line for each key. Reading throws std::runtime_error for what is none.
[[nodiscard]] std::string text_of(const RunSetup& setup);
[[nodiscard]] RunSetup setup_of(const std::string& text);

// What a log of the machine says of itself first.
[[nodiscard]] recording::LogDescription description_of(const config::MachineFile& file,
                                                       std::string version, std::string build);

// Sends the setup, with the starts and tools of `file.machine`, and the files of the machine, named
// from the folder of the machine file.
void record_setup(const RunSetup& setup, const config::MachineFile& file,
                  recording::MessageStream& stream);

// Compiler and its version: bit identity is promised for equal builds.
[[nodiscard]] std::string this_build();

}  // namespace stanok::runtime

// The daemon: all its parts put together, started in order and ended in the reverse order.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "runtime/assembly.h"

namespace stanok::daemon {

struct DaemonOptions {
  std::filesystem::path machine_file;
  std::filesystem::path state_directory;       // empty: the usual one
  std::filesystem::path socket;                // empty: the usual one
  std::string lcm;                             // empty: as the machine file says; "off": none
  std::filesystem::path program_root;          // empty: the working directory
  std::optional<runtime::DriveChoice> drives;  // nothing: embedded where the machine has drives
  std::filesystem::path log_directory;         // empty: no log file
  std::string panel_user;                      // empty: none
};

// Serves until a signal (signals.h) or system.shutdown; 0, or 7 when a thread of the daemon failed.
// Throws ConfigError, StateDirectoryError, SocketError and std::runtime_error before any axis has
// power.
[[nodiscard]] int run_daemon(const DaemonOptions& options);

}  // namespace stanok::daemon

// TableKeeper: tools and work offsets on disk, so that they are there after the next start.
//
// What programs and operators change is written within a second, and at the end. A disk that does
// not take it stops nothing: it is told, once, and tried again.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "channels/machine_config.h"

namespace stanok::daemon {

// Of the state directory; nothing in it: those of the machine file stay. Throws StateDirectoryError
// for a file that cannot be used.
void load_tables(const std::filesystem::path& state, channels::MachineConfig& machine);

class TableKeeper {
 public:
  using Snapshot = std::function<channels::TablesConfig()>;

  // `snapshot` may be called from another thread while this lives.
  TableKeeper(const std::filesystem::path& state, Snapshot snapshot);
  // Writes a last time.
  ~TableKeeper();
  TableKeeper(const TableKeeper&) = delete;
  TableKeeper& operator=(const TableKeeper&) = delete;

 private:
  void save_when_changed();

  std::filesystem::path file_;
  Snapshot snapshot_;
  std::string saved_;
  bool has_told_fault_ = false;
  std::jthread thread_;  // last: it uses the members above
};

}  // namespace stanok::daemon

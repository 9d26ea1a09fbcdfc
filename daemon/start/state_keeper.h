// StateKeeper: a text on disk that follows what it is made from, so that it is there after the next
// start.
//
// What changes is written within a second, and at the end. A disk that does not take it stops
// nothing: it is told, once, and tried again.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "daemon/host/durable_file.h"

namespace stanok::daemon {

class StateKeeper {
 public:
  using Snapshot = std::function<std::string()>;

  // `snapshot` may be called from another thread while this lives. What it gives now is on disk, or
  // needs not be.
  StateKeeper(std::filesystem::path file, const DurableKind& kind, Snapshot snapshot);
  // Writes a last time.
  ~StateKeeper();
  StateKeeper(const StateKeeper&) = delete;
  StateKeeper& operator=(const StateKeeper&) = delete;

 private:
  void try_to_save();
  void save_when_changed();

  std::filesystem::path file_;
  DurableKind kind_;
  Snapshot snapshot_;
  std::string saved_;
  bool has_told_fault_ = false;
  std::jthread thread_;  // last: it uses the members above
};

}  // namespace stanok::daemon

// StateKeeper: a text on disk that follows what it is made from, so that it is there after the next
// start.
//
// What changes is written within a second, at once for who waits for it, and at the end. A disk
// that does not take it stops nothing: it is told, once, and tried again.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "daemon/host/durable_file.h"

namespace stanok::daemon {

class StateKeeper {
 public:
  using Snapshot = std::function<std::string()>;

  // What the disk does not take, and why; from the thread of the keeper.
  using OnFault = std::function<void(std::string_view what, const std::string& fault)>;

  // `snapshot` may be called from another thread while this lives. What it gives now is on disk, or
  // needs not be.
  StateKeeper(std::filesystem::path file, const DurableKind& kind, Snapshot snapshot,
              OnFault on_fault);
  // Writes a last time.
  ~StateKeeper();
  StateKeeper(const StateKeeper&) = delete;
  StateKeeper& operator=(const StateKeeper&) = delete;

  // At once. `done` is told, from the thread of the keeper, when what the snapshot gives from now
  // on is on the disk, or why it is not. Any thread.
  using Done = std::function<void(const std::optional<std::string>& fault)>;
  void keep(Done done);

 private:
  [[nodiscard]] std::optional<std::string> try_to_save();
  [[nodiscard]] std::optional<std::string> save_when_changed();
  void tell(const std::string& fault);
  void save_for(const std::vector<Done>& waiting);

  std::filesystem::path file_;
  DurableKind kind_;
  Snapshot snapshot_;
  OnFault on_fault_;
  std::string saved_;
  bool has_told_fault_ = false;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Done> waiting_;  // for what is saved next
  std::jthread thread_;        // last: it uses the members above
};

}  // namespace stanok::daemon

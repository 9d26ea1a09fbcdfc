// Journal: what happened on the machine, on the disk: runs and where they are, alarms, what
// operators did, starts and ends of the daemon.
//
// A file `journal.jsonl` of the state directory, made short when it is long. A thread of its own
// writes what was added, and what there is to see of the machine, every 50 ms, and waits for the
// disk: nobody else does. Where the disk does not take it, it is told once, kept in memory and
// tried again. What stands there when it is opened is what earlier daemons have left behind.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "daemon/journal/journal_contents.h"
#include "daemon/journal/journal_file.h"

namespace stanok::daemon {

class Journal {
 public:
  // Makes no file. What cannot be read is told in the log of the daemon and put aside as
  // `journal.jsonl.damaged`.
  explicit Journal(const std::filesystem::path& directory);
  // Notes an orderly end, when it was begun.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // What has come to be since it was asked last; called from the journal's thread.
  using Watch = std::function<std::vector<nlohmann::json>()>;
  // Why the disk does not take it; from the journal's thread, once for each time it fails.
  using OnFault = std::function<void(const std::string& fault)>;
  // From now on it is written. Both outlive the journal.
  void begin(Watch watch, OnFault on_fault);

  // Any thread; waits for no disk. A record gets the time of now where it has none.
  void add(nlohmann::json record);

  // Before `begin`.
  [[nodiscard]] const JournalContents& before() const { return contents_; }
  // The same as long as the file is there: numbers of runs and alarms count up in it. Any thread.
  [[nodiscard]] const std::string& id() const { return id_; }
  // What operators did, starts and ends of the daemon, the newest last. Any thread.
  [[nodiscard]] std::vector<nlohmann::json> actions() const;
  // Why the disk does not take it; nothing: it does. Any thread.
  [[nodiscard]] std::optional<std::string> fault() const;

 private:
  void read();
  void run(const std::stop_token& stop);
  void write();
  [[nodiscard]] std::optional<std::string> bring_to_disk();
  void note_outcome(const std::optional<std::string>& fault);

  JournalFile file_;
  std::filesystem::path path_;
  Watch watch_;
  OnFault on_fault_;
  std::string id_;
  std::vector<nlohmann::json> unwritten_;  // of the thread
  bool is_behind_ = false;                 // the file lacks more than is unwritten; of the thread
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  JournalContents contents_;
  std::vector<nlohmann::json> added_;
  std::optional<std::string> fault_;
  std::jthread thread_;  // last: it uses the members above
};

}  // namespace stanok::daemon

// MachineHistory: the journal of a running machine from its start to its end, and the notices that
// operators get of it.
//
// What earlier daemons have left behind becomes the past of the machine. A run that none of them
// has ended is closed as cut off, with an alarm that says where it was; what cannot be kept on the
// disk is an alarm, too.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

#include "channels/machine/machine.h"
#include "daemon/cycle/running_machine.h"
#include "daemon/journal/journal.h"
#include "daemon/journal/machine_watch.h"

namespace stanok::daemon {

class MachineHistory {
 public:
  // Before the first cycle. The machine, and what of it has the reports, outlive the history.
  MachineHistory(const std::filesystem::path& state_directory, RunningMachine& machine,
                 channels::Machine& reports);

  [[nodiscard]] Journal& journal() { return journal_; }
  // From now on it is written, also what was found at the start.
  void begin();
  // Who tells those who watch the machine of an alarm, as of what the cycle tells; nothing: nobody.
  // Called from any thread, not behind the next call of this.
  using Announce = std::function<void(const channels::Event& event)>;
  void announce_to(Announce announce);

  // An alarm that no cycle raises; it stands in the first channel, as operators look at channels.
  // Any thread.
  void tell(std::string_view code, const std::string& text);
  // Something (`what`) is not on the disk. Any thread.
  void tell_not_kept(const std::string& what, const std::string& fault);

 private:
  void close(const JournalContents::CutOff& cut);

  RunningMachine& machine_;
  channels::Machine& reports_;
  std::mutex mutex_;
  Announce announce_;
  MachineWatch watch_;
  Journal journal_;  // last: it looks through the watch until its end
};

}  // namespace stanok::daemon

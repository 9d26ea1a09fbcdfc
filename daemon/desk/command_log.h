// CommandLog: every command of a client and its outcome, in the daemon's own log and in its
// journal.
//
// Any thread; waits for nothing.
#pragma once

#include <cstdint>
#include <string>

#include "daemon/desk/command_desk.h"
#include "daemon/journal/journal.h"
#include "protocol/contract/json_rpc.h"

namespace stanok::daemon {

// Who gave it: the number of the session, and who is behind it ("uid 1000, pid 4711").
struct Asker {
  int session = 0;
  std::string peer;
};

class CommandLog {
 public:
  // `journal` outlives the log; nullptr: there is none.
  explicit CommandLog(Journal* journal) : journal_(journal) {}

  void note(const Asker& asker, const protocol::RpcRequest& request,
            const CommandResult& outcome) const;
  // Somebody has seen the alarms of a channel up to this number.
  void note_seen(int channel, std::uint64_t number) const;

 private:
  Journal* journal_;
};

}  // namespace stanok::daemon

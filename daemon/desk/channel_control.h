// ChannelControl: a session may have a channel to itself.
//
// What moves or sets something of that channel is then refused to all others with E6080, until the
// session gives the channel back or ends; so is what concerns all channels or the tables that they
// share (channels::control_scope). Stops and questions are never refused for that. The cycle is
// told who has a channel, too: it stops what would come by way of programs. Belongs to the operator
// server's thread.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "channels/contract/operator_event.h"
#include "protocol/contract/failure.h"

namespace stanok::daemon {

struct SessionState;

class ChannelControl {
 public:
  // Why the session may not take the channel; nothing: it has it now.
  [[nodiscard]] std::optional<protocol::Failure> take(int channel, const SessionState& session);
  // Does nothing where the session does not have the channel.
  void give_back(int channel, int session);
  void forget(int session);

  // Why the session may not do this with the channel.
  [[nodiscard]] std::optional<protocol::Failure> obstacle(channels::OperatorAction action,
                                                          int channel, int session) const;
  // Why the session may not do what concerns all channels.
  [[nodiscard]] std::optional<protocol::Failure> obstacle_to_all(int session) const;
  // 0: nobody has it.
  [[nodiscard]] int session_with(int channel) const;
  // "session 4 (uid 1000, pid 4711)"; empty: nobody has it.
  [[nodiscard]] std::string holder(int channel) const;

 private:
  struct Holder {
    int session = 0;
    std::string peer;
  };
  std::map<int, Holder> holders_;  // by channel
};

}  // namespace stanok::daemon

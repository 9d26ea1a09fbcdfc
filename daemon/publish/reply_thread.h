// ReplyThread: brings what the cycle answers to those who asked, whatever the recorder is doing.
//
// Who hears of an answer finds the newest output behind the cycle that gave it: the thread waits
// for the end of that cycle. The only consumer of its ring; with a priority of its own, where that
// is granted, and little to do.
#pragma once

#include <cstdint>
#include <functional>
#include <thread>

#include "base/ring.h"
#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"

namespace stanok::daemon {

class ReplyThread {
 public:
  using Cycles = std::function<std::int64_t()>;  // that are over
  using Tell = std::function<void(const channels::OperatorReply&)>;
  using OnFault = std::function<void(std::string_view reason)>;

  // The ring outlives the thread.
  ReplyThread(Ring<channels::OperatorReply>& replies, Cycles cycles, Tell tell, OnFault on_fault);

 private:
  void run(const std::stop_token& stop);

  Ring<channels::OperatorReply>& replies_;
  Cycles cycles_;
  Tell tell_;
  OnFault on_fault_;
  std::jthread thread_;  // last: it uses the members above
};

}  // namespace stanok::daemon

// StopDesk: stops on their way into the cycle and their answers on the way back.
//
// Does for the reception's thread what CommandDesk does for the server's: it waits for nothing that
// another thread holds. When the cycle itself stands, everything that waits is answered with E9006.
#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "daemon/cycle/running_machine.h"
#include "daemon/desk/command_desk.h"
#include "daemon/desk/operator_command.h"

namespace stanok::daemon {

class StopDesk {
 public:
  using OnAccepted = std::function<void(const channels::OperatorEvent& stop)>;

  // The machine outlives the desk.
  StopDesk(RunningMachine& machine, OnAccepted on_accepted)
      : machine_(machine), on_accepted_(std::move(on_accepted)) {}

  // False: the request is no stop. Else it is in the cycle's queue by then, or refused; `answer` is
  // called once, now or later.
  [[nodiscard]] bool take(protocol::Role role, const protocol::RpcRequest& request, Answer answer);
  // The machine as a whole, without an answer.
  void order(const channels::OperatorCommand& command);

  // Whether the reply belongs to a stop; any thread.
  [[nodiscard]] static bool is_ours(const channels::OperatorReply& reply) {
    return (reply.id & channels::stop_id_mark) != 0;
  }
  void on_reply(const channels::OperatorReply& reply);
  [[nodiscard]] bool waits_for_reply() const { return !pending_.empty(); }
  void tick(SteadyTime now);

 private:
  struct Pending {
    channels::OperatorEvent stop;
    Answer answer;
  };

  RunningMachine& machine_;
  OnAccepted on_accepted_;
  std::uint64_t last_id_ = 0;
  std::map<std::uint64_t, Pending> pending_;
  std::int64_t newest_cycle_ = -1;
  SteadyTime newest_cycle_seen_{};
};

}  // namespace stanok::daemon

// Reception: reads and writes all clients, and takes their stops, in a thread of its own.
//
// A request that is a stop in the command table goes into the cycle's queue at once, whatever the
// operator server is doing; all others are handed to it, with the number of stops taken before
// them. Does nothing that may take long: cuts lines, reads short ones, and writes what others give
// it. Runs with a priority above all but the cycle, where that is granted, and then with at most
// half of a processor, so that who floods it starves nobody.
//
// At most 64 clients have a place; an observer makes room for an operator. Who finds none is told
// so (E9008) and may still send a stop, for two seconds; so it is when the system has no
// descriptors left, for some are kept in reserve. The orderly end is here too: it needs nobody
// else, and no memory that is not there already.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "daemon/cycle/running_machine.h"
#include "daemon/server/listening_socket.h"
#include "daemon/server/session.h"

namespace stanok::daemon {

struct ServerLimits {
  std::size_t clients_max = 64;
  std::chrono::milliseconds frame_time_max{10000};  // from the first byte of a frame to its end
  std::size_t turned_away_max = 1024;  // clients without a place who are still listened to
  std::optional<uid_t> panel_user{};   // whose connections have the role of the owner
};

// Who has the requests that are no stops. Called from the reception's thread; must not wait.
class Counter {
 public:
  Counter() = default;
  virtual ~Counter() = default;
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  virtual void on_arrival(std::shared_ptr<Session> session) = 0;
  // To be told when it is done with: Session::frame_is_done_soon.
  virtual void on_frame(std::shared_ptr<Session> session, protocol::TextFrame frame,
                        const AskedAt& asked_at) = 0;
  virtual void on_departure(int session) = 0;
  virtual void on_stop_answered(const Asker& asker, const protocol::RpcRequest& request,
                                const CommandResult& outcome) = 0;
  virtual void on_stop_accepted(const channels::OperatorEvent& stop) = 0;
  // The orderly end is over.
  virtual void on_end() = 0;
};

class Reception {
 public:
  // All outlive the reception.
  Reception(ListeningSocket& socket, RunningMachine& machine, Counter& counter,
            const ServerLimits& limits);
  ~Reception();
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  // Serves until the orderly end is over.
  void run();

  // Any thread; needs no memory. Begin the orderly end; the same because of a fault of ours, whose
  // text is constant.
  void end();
  void fail();
  [[nodiscard]] bool has_failed() const;

  // Clients that have a place; any thread.
  [[nodiscard]] std::size_t clients() const;
  // Listens there from now on; takes the descriptor. Any thread.
  void listen_on(int descriptor);
  // A reply to a stop; any thread.
  void on_reply(const channels::OperatorReply& reply);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stanok::daemon

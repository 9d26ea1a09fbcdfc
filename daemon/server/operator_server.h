// OperatorServer: serves the clients on the unix socket: two threads, and none of them waits for
// the other.
//
// The reception (reception.h) reads and writes the clients, takes stops and does the orderly end.
// This thread lets Dispatch answer all other requests, those of a session in their order and
// sessions by turns (frame_turns.h), and pushes status and events to those who subscribed; what it
// is busy with delays no stop.
#pragma once

#include <functional>
#include <memory>

#include "daemon/desk/dispatch.h"
#include "daemon/publish/publisher_thread.h"
#include "daemon/server/listening_socket.h"
#include "daemon/server/reception.h"

namespace stanok::daemon {

class OperatorServer final : public CycleListener {
 public:
  // All outlive the server.
  OperatorServer(ListeningSocket& socket, RunningMachine& machine, DaemonDescription description,
                 ServerLimits limits = {});
  ~OperatorServer() override;

  // Serves until the orderly end is over.
  void run();

  // Begin the orderly end; the same because of a fault of ours. Any thread; they need no memory.
  void end();
  void fail();
  [[nodiscard]] bool has_failed() const;

  // From other threads; handed over to the server's.
  void on_event(const channels::Event& event) override;
  void on_reply(const channels::OperatorReply& reply);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stanok::daemon

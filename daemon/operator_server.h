// OperatorServer: accepts clients on the unix socket and serves them, one thread, no waiting.
//
// Greets each client, cuts its bytes into requests, lets Dispatch answer them, pushes status and
// events to those who subscribed. At most 64 clients; an observer makes room for an operator.
// Signals (signals.h) arrive here like commands: feed hold, drives off, orderly end.
#pragma once

#include <functional>
#include <memory>

#include "daemon/dispatch.h"
#include "daemon/listening_socket.h"
#include "daemon/publisher_thread.h"

namespace stanok::daemon {

struct ServerLimits {
  std::size_t clients_max = 64;
  std::chrono::milliseconds frame_time_max{10000};  // from the first byte of a frame to its end
};

class OperatorServer final : public CycleListener {
 public:
  // All outlive the server.
  OperatorServer(ListeningSocket& socket, RunningMachine& machine, DaemonDescription description,
                 ServerLimits limits = {});
  ~OperatorServer() override;

  // Serves until the orderly end is over.
  void run();

  // Begin the orderly end; any thread.
  void end();

  // From the publisher thread; handed over to the server's.
  void on_event(const channels::Event& event) override;
  void on_reply(const channels::OperatorReply& reply) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stanok::daemon

// WebServer: listens, and keeps the connections within their bounds.
//
// One thread serves all. It is no part of the machine: when it ends or is flooded, the daemon sees
// connections that end.
#pragma once

#include <memory>
#include <string>

#include "web/server/web_options.h"

namespace stanok::web {

class WebServer {
 public:
  // Listens from now on. Throws UsageError and std::runtime_error.
  explicit WebServer(const WebOptions& options);
  ~WebServer();

  // A link that lets in who follows it first; before `run` or from its thread.
  [[nodiscard]] std::string new_link();
  // "http://127.0.0.1:8080"
  [[nodiscard]] const std::string& address() const;

  // Until SIGINT or SIGTERM, or `end`.
  void run();
  // Any thread.
  void end();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stanok::web

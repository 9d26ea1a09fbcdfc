// GatewayOptions: what the command line of stanok-gateway says, and what must not be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "gateway/broker/broker_options.h"
#include "gateway/cell/machine_reader.h"
#include "gateway/outbox/outbox.h"

namespace stanok::gateway {

// The command line asks for what is not done; it says what to do instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct GatewayOptions {
  std::vector<MachineAddress> machines;
  BrokerOptions broker;
  bool has_broker = true;
  std::string prefix = "stanok";
  std::string sparkplug_group;         // empty: no Sparkplug
  std::filesystem::path state_folder;  // of the outbox
  std::int64_t events_max = Outbox::usual_events_max;
  double rate_hz = 1.0;
  std::string history;  // a database; empty: none
  int keep_days = 400;

  [[nodiscard]] std::filesystem::path outbox() const { return state_folder / "outbox.sqlite"; }
};

// "NAME=SOCKET", or a socket, which is called like its file. Throws UsageError.
[[nodiscard]] MachineAddress machine_address(const std::string& text);
// "off", "HOST" or "HOST:PORT". Throws UsageError.
void set_broker(const std::string& text, GatewayOptions& options);
// "400d". Throws UsageError.
[[nodiscard]] int days_of(const std::string& text);
// Throws UsageError.
void check(const GatewayOptions& options);

}  // namespace stanok::gateway

#include "gateway/start/gateway_options.h"

#include <charconv>
#include <set>

#include "gateway/cell/topics.h"
#include "gateway/database/database.h"

namespace stanok::gateway {
namespace {

int integer_in(std::string_view text, int smallest, int largest, const std::string& wanted) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  if (!is_whole || number < smallest || number > largest) throw UsageError(wanted);
  return number;
}

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

}  // namespace

MachineAddress machine_address(const std::string& text) {
  const std::size_t sign = text.find('=');
  MachineAddress address;
  address.socket = sign == std::string::npos ? text : text.substr(sign + 1);
  address.name = sign == std::string::npos ? address.socket.stem().string() : text.substr(0, sign);
  if (!is_level(address.name) || address.name == topic::gateway)
    throw UsageError("--daemon " + text +
                     ": a machine needs a name without /, + and #, other than " +
                     std::string(topic::gateway) + ": --daemon NAME=SOCKET");
  return address;
}

void set_broker(const std::string& text, GatewayOptions& options) {
  options.has_broker = text != "off";
  if (!options.has_broker) return;
  constexpr int port_max = 65535;
  const std::size_t colon = text.rfind(':');
  options.broker.host = text.substr(0, colon);
  if (colon != std::string::npos)
    options.broker.port = integer_in(std::string_view(text).substr(colon + 1), 1, port_max,
                                     "--broker needs HOST:PORT, such as 127.0.0.1:1883, or off");
}

int days_of(const std::string& text) {
  constexpr int days_max = 36500;
  const std::string_view number = std::string_view(text).substr(0, text.find('d'));
  return integer_in(number, 1, days_max, "--keep needs a number of days, such as 400d");
}

void check(const GatewayOptions& options) {
  if (options.machines.empty())
    throw UsageError("no machine: name the socket of a daemon with --daemon NAME=SOCKET");
  std::set<std::string> names;
  for (const MachineAddress& machine : options.machines)
    if (!names.insert(machine.name).second)
      throw UsageError("two machines have the name " + machine.name + ": --daemon NAME=SOCKET");
  const BrokerOptions& broker = options.broker;
  if (broker.tls_certificate.empty() != broker.tls_key.empty())
    throw UsageError("--tls-cert and --tls-key belong together");
  if (!broker.password_file.empty() && broker.user.empty())
    throw UsageError("--password-file belongs to --user");
  if (!broker.password_file.empty() && broker.tls_ca.empty() && !is_loopback(broker.host))
    throw UsageError("a password must not travel unencrypted: add --tls-ca FILE");
  if (!options.sparkplug_group.empty() && !is_level(options.sparkplug_group))
    throw UsageError("--sparkplug needs the name of a group without /, + and #");
  if (!options.sparkplug_group.empty() && !options.has_broker)
    throw UsageError("--sparkplug needs a broker: remove --broker off");
  if (holds_password(options.history))
    throw UsageError(
        "--history must not contain a password, because everybody on this computer could read it; "
        "write it to the file that PGPASSFILE names");
}

}  // namespace stanok::gateway

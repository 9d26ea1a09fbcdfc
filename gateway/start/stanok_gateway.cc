// stanok-gateway: machines of a cell to a broker of MQTT and into a history. Command line and exit
// codes; everything else is in gateway/start/gateway.h.
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "base/utf8.h"
#include "gateway/start/gateway.h"
#include "protocol/contract/socket_location.h"
#include "protocol/contract/version.h"

namespace {

using stanok::gateway::GatewayOptions;
using stanok::gateway::UsageError;

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

struct CommandLine {
  std::vector<std::string> daemons;
  std::string broker = "127.0.0.1:1883";
  std::string history;
  std::string keep = "400d";
  int resend_s = 10;
  GatewayOptions options;
};

void add_broker_options(CLI::App& app, CommandLine& given) {
  auto& broker = given.options.broker;
  app.add_option("--broker", given.broker, "MQTT broker, or off; default 127.0.0.1:1883")
      ->type_name("HOST:PORT");
  app.add_option("--topic", given.options.prefix, "prefix of all topics; default: stanok")
      ->type_name("PREFIX");
  app.add_option("--sparkplug", given.options.sparkplug_group,
                 "also publish states as Sparkplug B, as a node of this group")
      ->type_name("GROUP");
  app.add_option("--user", broker.user, "user name at the broker")->type_name("NAME");
  app.add_option("--password-file", broker.password_file, "file whose first line is the password")
      ->type_name("FILE");
  app.add_option("--tls-ca", broker.tls_ca,
                 "use TLS, with a broker certified by these authorities (PEM)")
      ->type_name("FILE");
  app.add_option("--tls-cert", broker.tls_certificate, "certificate of the gateway (PEM)")
      ->type_name("FILE");
  app.add_option("--tls-key", broker.tls_key, "key of the certificate (PEM)")->type_name("FILE");
  app.add_option("--resend", given.resend_s,
                 "resend events that were acknowledged within this time before a connection was "
                 "lost; default 10 s")
      ->check(CLI::Range(0, 86400))
      ->type_name("SECONDS");
}

void add_options(CLI::App& app, CommandLine& given) {
  app.add_option("--daemon", given.daemons,
                 "socket of a daemon and the name of its machine; may be repeated")
      ->type_name("NAME=SOCKET")
      ->allow_extra_args(false);
  add_broker_options(app, given);
  app.add_option("--rate", given.options.rate_hz, "rate at which states are read; default 1 Hz")
      ->check(CLI::Range(0.1, 10.0))
      ->type_name("HZ");
  app.add_option("--state", given.options.state_folder,
                 "folder of the outbox; default: $STATE_DIRECTORY")
      ->type_name("FOLDER");
  app.add_option(
         "--events", given.options.events_max,
         "maximum number of waiting events; beyond it the oldest are discarded; default 1000000")
      ->check(CLI::Range(std::int64_t{100}, std::int64_t{100'000'000}))
      ->type_name("NUMBER");
  app.add_option("--history", given.history,
                 "database of the history: an SQLite file, postgresql://..., or off; default: "
                 "history.sqlite next to the outbox")
      ->type_name("DATABASE");
  app.add_option("--keep", given.keep, "how long the history keeps entries; default 400d")
      ->type_name("DAYS");
}

GatewayOptions complete(CommandLine given) {
  GatewayOptions options = std::move(given.options);
  for (const std::string& text : given.daemons)
    options.machines.push_back(stanok::gateway::machine_address(text));
  stanok::gateway::set_broker(given.broker, options);
  options.broker.resent = std::chrono::seconds(given.resend_s);
  options.keep_days = stanok::gateway::days_of(given.keep);
  if (options.state_folder.empty())
    options.state_folder = stanok::protocol::default_state_directory("gateway");
  if (given.history.empty())
    options.history = (options.state_folder / "history.sqlite").string();
  else if (given.history != "off")
    options.history = given.history;
  return options;
}

// With the time unless a journal adds it.
void log_to_standard_error() {
  auto logger = spdlog::stderr_logger_mt("stanok-gateway");
  // Set by systemd; read before any thread exists.
  const bool has_journal =
      std::getenv("JOURNAL_STREAM") != nullptr;  // NOLINT(concurrency-mt-unsafe)
  logger->set_pattern(has_journal ? "%l: %v" : "%Y-%m-%d %H:%M:%S.%e %l: %v");
  spdlog::set_default_logger(std::move(logger));
}

// The exit code; throws what cannot be handled here.
int run(int argc, char** argv) {
  CLI::App app("stanok-gateway: publishes machines to a broker and keeps their history");
  app.set_version_flag("--version", std::string(stanok::protocol::version));
  CommandLine given;
  add_options(app, given);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  log_to_standard_error();
  std::signal(SIGPIPE, SIG_IGN);
  stanok::gateway::run_gateway(complete(std::move(given)));
  return 0;
}

int fail(const std::exception& error, int exit_code) {
  std::fprintf(stderr, "stanok-gateway: %s\n", stanok::valid_utf8(error.what()).c_str());
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return fail(error, exit_usage);
  } catch (const std::exception& error) {
    return fail(error, exit_failed);
  }
}

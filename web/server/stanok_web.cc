// stanok-web: serves the page with which a machine is seen and worked in a browser. Command line
// and exit codes; everything else is in web/server/web_server.h.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "base/utf8.h"
#include "protocol/contract/socket_location.h"
#include "protocol/contract/version.h"
#include "web/server/listen_address.h"
#include "web/server/page_files.h"
#include "web/server/user_commands.h"
#include "web/server/web_log.h"
#include "web/server/web_server.h"

namespace {

using stanok::web::UsageError;
using stanok::web::WebOptions;

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

struct CommandLine {
  std::string listen = "127.0.0.1:8080";
  WebOptions options;
};

void add_options(CLI::App& app, CommandLine& given) {
  app.add_option("--listen", given.listen,
                 "address and port to listen on; default 127.0.0.1:8080; port 0: any free port")
      ->type_name("ADDRESS:PORT");
  app.add_option("--socket", given.options.sockets,
                 "socket of the daemon; default: the only one that exists; may be repeated for a "
                 "page with several machines, which shows the first one unless another is chosen")
      ->type_name("PATH");
  app.add_option("--history", given.options.history,
                 "history of the gateway to show on the page: an SQLite file or postgresql://...")
      ->type_name("DATABASE");
  app.add_option(
         "--link-socket", given.options.link_socket,
         "socket on which `stanok panel` asks for links; default: next to the socket of the daemon")
      ->type_name("PATH");
  app.add_option("--page", given.options.page, "folder of the page; default: the installed page")
      ->type_name("FOLDER");
  app.add_option("--manual", given.options.manual,
                 "folder of the documents that the page shows; default: the installed documents")
      ->type_name("FOLDER");
  app.add_option("--name", given.options.names,
                 "name under which browsers may reach this server; may be repeated")
      ->type_name("HOST");
  app.add_option("--users", given.options.users,
                 "file of the users; default: no users, access only by links")
      ->type_name("FILE");
  app.add_option("--sessions", given.options.sessions,
                 "file that keeps sessions across restarts of the server; default: "
                 "ADDRESS:PORT.sessions in the state directory, none for port 0")
      ->type_name("FILE");
  app.add_option("--tls-cert", given.options.tls_certificate, "TLS certificate chain (PEM)")
      ->type_name("FILE");
  app.add_option("--tls-key", given.options.tls_key, "key of the certificate (PEM)")
      ->type_name("FILE");
}

WebOptions complete(CommandLine given) {
  const auto endpoint = stanok::web::endpoint_of(given.listen);
  if (!endpoint)
    throw UsageError("--listen needs an address and a port, such as 127.0.0.1:8080 or [::1]:8080");
  WebOptions options = std::move(given.options);
  options.listen = *endpoint;
  if (options.page.empty()) options.page = stanok::web::usual_page_folder();
  if (options.manual.empty()) options.manual = stanok::web::usual_manual_folder();
  if (options.sockets.empty()) {
    const auto socket = stanok::protocol::chosen_socket({});
    if (!socket) throw UsageError(socket.error());
    options.sockets = {*socket};
  }
  if (options.link_socket.empty())
    options.link_socket = stanok::protocol::link_socket(options.sockets.front());
  // A page at another port is another page to browsers.
  if (options.sessions.empty() && endpoint->port() != 0)
    options.sessions = stanok::protocol::default_state_directory("stanok-web") /
                       (stanok::web::text_of(*endpoint) + ".sessions");
  return options;
}

int serve(CommandLine given) {
  stanok::web::log_to_standard_error();
  std::signal(SIGPIPE, SIG_IGN);
  stanok::web::WebServer server(complete(std::move(given)));
  // Only to a terminal: what a service prints stands in a journal, that others read.
  const bool is_seen = ::isatty(STDOUT_FILENO) == 1;
  std::printf("%s\n", is_seen ? server.new_link().c_str() : server.address().c_str());
  std::fflush(stdout);
  server.run();
  return 0;
}

// The exit code; throws what cannot be handled here.
int run(int argc, char** argv) {
  CLI::App app("stanok-web: shows a machine in a browser");
  app.set_version_flag("--version", std::string(stanok::protocol::version));
  CommandLine given;
  add_options(app, given);
  constexpr int not_called = -1;
  int exit_code = not_called;
  stanok::web::add_user_commands(app, given.options.users, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  return exit_code == not_called ? serve(std::move(given)) : exit_code;
}

int fail(const std::exception& error, int exit_code) {
  std::fprintf(stderr, "stanok-web: %s\n", stanok::valid_utf8(error.what()).c_str());
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

#include "web/server/web_server.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <csignal>
#include <optional>
#include <set>

#include "web/server/client_connection.h"
#include "web/server/connection_list.h"
#include "web/server/link_desk.h"
#include "web/server/listen_address.h"
#include "web/server/tls.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr auto round_time = std::chrono::seconds(1);
constexpr auto accept_pause = std::chrono::milliseconds(50);  // when no descriptors are left

OwnNames own_names(const WebOptions& options, Scheme scheme) {
  std::set<std::string> names(options.names.begin(), options.names.end());
  std::array<char, 256> host{};
  const bool is_for_all = !options.listen.address().is_loopback();
  if (is_for_all && ::gethostname(host.data(), host.size() - 1) == 0) names.insert(host.data());
  OwnNames own(scheme, names);
  if (is_for_all) own.allow_addresses();
  return own;
}

void tell_fault(const std::exception_ptr& fault) {
  if (fault == nullptr) return;
  try {
    std::rethrow_exception(fault);
  } catch (const std::exception& error) {
    spdlog::error("a connection failed: {}", error.what());
  }
}

tcp::acceptor listening(asio::io_context& io, const tcp::endpoint& endpoint) {
  try {
    return {io, endpoint};
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(text_of(endpoint) + ": " + error.code().message());
  }
}

}  // namespace

struct WebServer::Parts {
  struct Shown {
    PageFiles page;
    PageFiles manual;  // documents that the page shows
    MachineList machines;
    HistoryDesk history;
  };

  explicit Parts(const WebOptions& options);

  [[nodiscard]] asio::awaitable<void> accept();
  [[nodiscard]] asio::awaitable<void> keep_order();
  void admit(tcp::socket socket);
  void close_all();

  asio::io_context io{1};
  std::optional<asio::ssl::context> tls;
  tcp::acceptor acceptor;
  asio::signal_set signals{io, SIGINT, SIGTERM};
  asio::steady_timer timer{io};
  Scheme scheme;
  std::string address;
  OwnNames names;
  Shown shown;
  Authentication authentication;
  Reception reception;
  Services services;
  std::optional<LinkDesk> link_desk;
  ConnectionList connections;
};

WebServer::Parts::Parts(const WebOptions& options)
    : tls(tls_context(options)),
      acceptor(listening(io, options.listen)),
      scheme(tls ? Scheme::https : Scheme::http),
      address((tls ? "https://" : "http://") + text_of(acceptor.local_endpoint())),
      names(own_names(options, scheme)),
      shown{.page = PageFiles(options.page, "index.html"),
            .manual = PageFiles(options.manual, "README.md"),
            .machines = MachineList(options.sockets),
            .history = HistoryDesk(options.history)},
      authentication(scheme, options.users, options.sessions,
                     [this](const auto& sessions) { connections.end_relays_of(sessions); }),
      reception({.page = shown.page,
                 .manual = shown.manual,
                 .machines = shown.machines,
                 .history = shown.history},
                authentication, names),
      services{.scheme = scheme,
               .reception = reception,
               .authentication = authentication,
               .machines = shown.machines,
               .has_room_for_relay_of = [this](protocol::Role role) {
                 return connections.has_room_for_relay_of(role);
               }} {
  if (!options.listen.address().is_loopback() && !authentication.has_users())
    throw UsageError(
        options.users.string() +
        ": there are no users yet; add one: stanok-web user add NAME --role ROLE --users FILE");
  authentication.set_port(acceptor.local_endpoint().port());
  if (options.link_socket.empty()) return;
  link_desk.emplace(io.get_executor(), options.link_socket,
                    [this] { return address + "/#" + authentication.issue_link(); });
}

asio::awaitable<void> WebServer::Parts::accept() {
  while (acceptor.is_open()) {
    auto [error, socket] = co_await acceptor.async_accept(asio::as_tuple(asio::use_awaitable));
    // Who came before the end and was not served yet is not served any more.
    if (error == asio::error::operation_aborted || !acceptor.is_open()) co_return;
    if (!error) {
      admit(std::move(socket));
      continue;
    }
    spdlog::warn("cannot accept a connection: {}", error.message());
    connections.end_idlest();
    asio::steady_timer pause(io, accept_pause);
    static_cast<void>(co_await pause.async_wait(asio::as_tuple(asio::use_awaitable)));
  }
}

void WebServer::Parts::admit(tcp::socket socket) {
  boost::system::error_code ignored;
  ignored = socket.set_option(tcp::no_delay(true), ignored);
  if (!connections.make_room_for_one()) return;
  const auto connection =
      std::make_shared<ClientConnection>(std::move(socket), tls ? &*tls : nullptr, services);
  const std::uint64_t id = connections.add(connection);
  asio::co_spawn(io, ClientConnection::serve(connection),
                 [this, id](const std::exception_ptr& fault) {
                   tell_fault(fault);
                   connections.forget(id);
                 });
}

asio::awaitable<void> WebServer::Parts::keep_order() {
  while (acceptor.is_open()) {
    timer.expires_after(round_time);
    const auto [error] = co_await timer.async_wait(asio::as_tuple(asio::use_awaitable));
    if (error) co_return;
    authentication.tick(connections.sessions());
    connections.end_stuck(std::chrono::steady_clock::now());
  }
}

void WebServer::Parts::close_all() {
  boost::system::error_code ignored;
  ignored = acceptor.close(ignored);
  ignored = signals.cancel(ignored);
  timer.cancel();
  if (link_desk) link_desk->close();
  connections.end_all();
}

WebServer::WebServer(const WebOptions& options) {
  check(options);
  parts_ = std::make_unique<Parts>(options);
}

WebServer::~WebServer() = default;

std::string WebServer::new_link() {
  return parts_->address + "/#" + parts_->authentication.issue_link();
}

const std::string& WebServer::address() const {
  return parts_->address;
}

void WebServer::run() {
  Parts& parts = *parts_;
  asio::co_spawn(parts.io, parts.accept(), tell_fault);
  asio::co_spawn(parts.io, parts.keep_order(), tell_fault);
  if (parts.link_desk) asio::co_spawn(parts.io, parts.link_desk->serve(), tell_fault);
  parts.signals.async_wait([&parts](const boost::system::error_code& error, int) {
    if (!error) parts.close_all();
  });
  parts.io.run();
}

void WebServer::end() {
  asio::post(parts_->io, [parts = parts_.get()] { parts->close_all(); });
}

}  // namespace stanok::web

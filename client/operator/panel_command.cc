#include "client/operator/panel_command.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/place.h"
#include "base/system_error.h"
#include "client/operator/link_page.h"
#include "client/operator/operator_client.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/socket_location.h"

namespace stanok::client {
namespace {

constexpr int answer_time_max_ms = 5000;
constexpr auto remedy = "; start one next to the daemon: stanok-web --socket PATH";

struct PanelOptions {
  std::string socket;
  std::string link_socket;
  bool opens = true;
  bool json = false;
};

// A descriptor that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

void connect_to_desk(const Descriptor& desk, const std::filesystem::path& socket) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = socket.string();
  const bool fits = path.size() < sizeof address.sun_path;
  if (fits) std::copy(path.begin(), path.end(), address.sun_path);
  errno = ENAMETOOLONG;
  if (!fits ||
      ::connect(desk.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw ConnectionError("no stanok-web provides links at " + path + ": " +
                          system_error_text(errno) + remedy);
  }
}

// All that the desk says until it closes the connection.
std::string text_from(const Descriptor& desk) {
  std::string text;
  std::array<char, 1024> bytes{};
  pollfd wanted{.fd = desk.number(), .events = POLLIN, .revents = 0};
  while (::poll(&wanted, 1, answer_time_max_ms) == 1) {
    const ssize_t count = ::recv(desk.number(), bytes.data(), bytes.size(), 0);
    if (count <= 0) break;
    text.append(bytes.data(), checked_size(count));
  }
  return text;
}

std::string link_from(const std::filesystem::path& socket) {
  const Descriptor desk(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!desk.is_open()) throw ConnectionError("cannot open a socket: " + system_error_text(errno));
  connect_to_desk(desk, socket);
  const auto answer = protocol::json_from_text(text_from(desk));
  const std::string link = answer.is_object() ? answer.value("link", "") : "";
  if (link.empty())
    throw ConnectionError("the stanok-web at " + socket.string() +
                          " provides links only to the user who started it, and to root");
  return link;
}

bool has_screen() {
  const auto is_set = [](const char* variable) {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
    return value != nullptr && *value != '\0';
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

void show_panel(const PanelOptions& options) {
  const std::filesystem::path desk = options.link_socket.empty()
                                         ? protocol::link_socket(choose_socket(options.socket))
                                         : std::filesystem::path(options.link_socket);
  const std::string link = link_from(desk);
  const bool is_opened = options.opens && has_screen() && open_in_browser(link);
  if (options.json) return write_json(nlohmann::json{{"link", link}, {"opened", is_opened}});
  write_data(link + "\n");
  if (!is_opened) write_message("open this link in a browser; it can be used once\n");
}

}  // namespace

void add_panel_command(CLI::App& app, const std::string& socket, int& exit_code) {
  const auto options = std::make_shared<PanelOptions>();
  CLI::App* command =
      app.add_subcommand("panel", "open the web page of the machine, which stanok-web serves");
  command->add_option("--socket", options->socket, "socket of the daemon")->type_name("PATH");
  command
      ->add_option("--link-socket", options->link_socket,
                   "link socket of stanok-web; default: next to the socket of the daemon")
      ->type_name("PATH");
  command->add_flag("--open,!--no-open", options->opens,
                    "open the link if there is a screen (default), or only print it");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &socket, &exit_code] {
    if (options->socket.empty()) options->socket = socket;
    show_panel(*options);
    exit_code = 0;
  });
}

}  // namespace stanok::client

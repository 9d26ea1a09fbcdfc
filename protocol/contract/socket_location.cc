#include "protocol/contract/socket_location.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <system_error>

namespace stanok::protocol {
namespace {

namespace fs = std::filesystem;

// Read once at start, before any thread exists.
std::optional<fs::path> path_from(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
  if (value == nullptr || *value == '\0') return std::nullopt;
  return fs::path(value);
}

fs::path state_home() {
  if (const auto directory = path_from("XDG_STATE_HOME")) return *directory / "stanok";
  if (const auto home = path_from("HOME")) return *home / ".local" / "state" / "stanok";
  return fs::temp_directory_path() / ("stanok-" + std::to_string(getuid()));
}

void append_sockets(std::vector<fs::path>& sockets, const fs::path& directory) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    if (entry.is_socket(error) && entry.path().extension() == ".sock")
      sockets.push_back(entry.path());
  }
}

}  // namespace

fs::path default_state_directory(std::string_view machine) {
  if (const auto directory = path_from("STATE_DIRECTORY")) return *directory;
  return state_home() / machine;
}

fs::path default_socket(std::string_view machine, const fs::path& state_directory) {
  const std::string name = std::string(machine) + ".sock";
  if (const auto directory = path_from("XDG_RUNTIME_DIR")) return *directory / "stanok" / name;
  return state_directory / name;
}

std::vector<fs::path> known_sockets() {
  std::vector<fs::path> sockets;
  if (const auto directory = path_from("XDG_RUNTIME_DIR"))
    append_sockets(sockets, *directory / "stanok");
  std::error_code error;
  for (const auto& machine : fs::directory_iterator(state_home(), error))
    append_sockets(sockets, machine.path());
  std::sort(sockets.begin(), sockets.end());
  return sockets;
}

Expected<fs::path, std::string> chosen_socket(const fs::path& named) {
  if (!named.empty()) return named;
  if (const auto socket = path_from("STANOK_SOCKET")) return *socket;
  const auto sockets = known_sockets();
  if (sockets.size() == 1) return sockets.front();
  std::string text = sockets.empty() ? "no daemon is running here; name its socket with --socket"
                                     : "several daemons may be running; name one with --socket:";
  for (const auto& socket : sockets) text += "\n  " + socket.string();
  return Unexpected<std::string>(text);
}

fs::path link_socket(const fs::path& socket) {
  return fs::path(socket).replace_extension(".panel");
}

}  // namespace stanok::protocol

#include "daemon/server/listening_socket.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "base/system_error.h"

namespace stanok::daemon {
namespace {

constexpr ::mode_t not_for_others = 0117;  // sockets are born with 0777 less this: 0660
constexpr int waiting_connections_max = 128;

[[noreturn]] void throw_socket_error(const std::filesystem::path& path, int error) {
  throw SocketError(path.string() + ": " + system_error_text(error));
}

sockaddr_un address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string text = path.string();
  if (text.size() >= sizeof address.sun_path) {
    throw SocketError(text + ": the name of a socket has at most " +
                      std::to_string(sizeof address.sun_path - 1) +
                      " bytes; choose another with --socket");
  }
  std::copy(text.begin(), text.end(), address.sun_path);
  return address;
}

int new_socket(const std::filesystem::path& path) {
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) throw_socket_error(path, errno);
  return descriptor;
}

// What stands at the path already is removed when it is a socket that nobody listens on.
void clear_the_way(const std::filesystem::path& path, const sockaddr_un& address) {
  struct stat status{};
  if (::lstat(path.c_str(), &status) != 0) return;
  if (!S_ISSOCK(status.st_mode))
    throw SocketError(path.string() + ": a file that is not a socket has this name");
  const int probe = new_socket(path);
  const int outcome = ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  const int error = outcome == 0 ? 0 : errno;
  ::close(probe);
  if (error != ECONNREFUSED)
    throw SocketError(path.string() + ": another daemon is listening there");
  if (::unlink(path.c_str()) != 0) throw_socket_error(path, errno);
}

}  // namespace

ListeningSocket::ListeningSocket(std::filesystem::path path) : path_(std::move(path)) {
  const sockaddr_un address = address_of(path_);
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  if (error) throw SocketError(path_.parent_path().string() + ": " + error.message());
  clear_the_way(path_, address);
  bind_and_listen();
}

void ListeningSocket::renew() {
  if (path_.has_parent_path()) {
    std::error_code error;
    std::filesystem::create_directories(path_.parent_path(), error);
    if (error) throw SocketError(path_.parent_path().string() + ": " + error.message());
  }
  bind_and_listen();
}

bool ListeningSocket::is_there() const {
  struct stat status{};
  return ::lstat(path_.c_str(), &status) == 0 || errno != ENOENT;
}

void ListeningSocket::bind_and_listen() {
  const sockaddr_un address = address_of(path_);
  descriptor_ = new_socket(path_);
  const ::mode_t mask = ::umask(not_for_others);
  const bool is_bound =
      ::bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int bind_error = errno;
  ::umask(mask);
  struct stat status{};
  if (!is_bound || ::listen(descriptor_, waiting_connections_max) != 0 ||
      ::lstat(path_.c_str(), &status) != 0) {
    const int reason = is_bound ? errno : bind_error;
    ::close(std::exchange(descriptor_, -1));
    throw_socket_error(path_, reason);
  }
  inode_ = status.st_ino;
}

ListeningSocket::~ListeningSocket() {
  if (descriptor_ >= 0) ::close(descriptor_);
  struct stat status{};
  if (::lstat(path_.c_str(), &status) == 0 && status.st_ino == inode_) ::unlink(path_.c_str());
}

int ListeningSocket::release() {
  return std::exchange(descriptor_, -1);
}

}  // namespace stanok::daemon

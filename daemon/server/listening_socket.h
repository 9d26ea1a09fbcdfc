// ListeningSocket: the unix socket of the operator server in the file system.
//
// Mode 0660 from its first moment. A socket that a dead daemon left behind is removed; one that
// somebody still listens on is not taken over. One thread at a time.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <stdexcept>

namespace stanok::daemon {

class SocketError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ListeningSocket {
 public:
  // Throws SocketError.
  explicit ListeningSocket(std::filesystem::path path);
  // Removes the file, unless somebody has put another one in its place.
  ~ListeningSocket();
  ListeningSocket(const ListeningSocket&) = delete;
  ListeningSocket& operator=(const ListeningSocket&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // The descriptor; the caller closes it.
  [[nodiscard]] int release();

  // Whether its file is still there.
  [[nodiscard]] bool is_there() const;
  // Another socket at the same path, when the file is gone. Throws SocketError.
  void renew();

 private:
  void bind_and_listen();

  std::filesystem::path path_;
  int descriptor_ = -1;
  ino_t inode_ = 0;
};

}  // namespace stanok::daemon

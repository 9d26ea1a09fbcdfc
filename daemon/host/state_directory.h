// StateDirectory: the folder that belongs to one daemon at a time.
//
// Held by flock(2) on `stanokd.lock`, which also names the pid of the holder; the lock goes with
// the process, however it ends.
#pragma once

#include <filesystem>
#include <stdexcept>

namespace stanok::daemon {

class StateDirectoryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class StateDirectory {
 public:
  // Makes the folder when it is absent. Throws StateDirectoryError when it cannot be made or
  // written, or when another daemon holds it.
  explicit StateDirectory(std::filesystem::path path);
  ~StateDirectory();
  StateDirectory(const StateDirectory&) = delete;
  StateDirectory& operator=(const StateDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace stanok::daemon

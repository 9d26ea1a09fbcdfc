#include "daemon/host/state_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>

#include "base/place.h"
#include "base/system_error.h"
#include "daemon/host/durable_file.h"

namespace stanok::daemon {
namespace {

// Who can open it, even to read, can lock it.
constexpr ::mode_t lock_mode = 0600;

std::string holder_of(int lock) {
  std::array<char, 32> text{};
  const ssize_t count = ::pread(lock, text.data(), text.size() - 1, 0);
  std::string pid(text.data(), count > 0 ? checked_size(count) : 0);
  while (!pid.empty() && pid.back() == '\n') pid.pop_back();
  return pid.empty() ? "unknown" : pid;
}

}  // namespace

StateDirectory::StateDirectory(std::filesystem::path path) : path_(std::move(path)) {
  if (const int error = make_folder_durably(path_); error != 0)
    throw StateDirectoryError("state directory " + path_.string() + ": " +
                              system_error_text(error));
  const std::filesystem::path file = path_ / "stanokd.lock";
  lock_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, lock_mode);
  if (lock_ < 0) throw StateDirectoryError(file.string() + ": " + system_error_text(errno));
  static_cast<void>(::fchmod(lock_, lock_mode));  // one of an older version; of others', refused
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    const std::string holder = holder_of(lock_);
    ::close(lock_);
    throw StateDirectoryError("state directory " + path_.string() +
                              " belongs to a running stanokd, pid " + holder);
  }
  const std::string pid = std::to_string(::getpid()) + "\n";
  const bool is_written =
      ::ftruncate(lock_, 0) == 0 &&
      ::pwrite(lock_, pid.data(), pid.size(), 0) == static_cast<ssize_t>(pid.size());
  if (!is_written) {
    const int write_error = errno;
    ::close(lock_);
    throw StateDirectoryError(file.string() + ": " + system_error_text(write_error));
  }
}

StateDirectory::~StateDirectory() {
  ::close(lock_);
}

}  // namespace stanok::daemon

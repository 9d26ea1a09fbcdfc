#include "web/access/private_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>

#include "base/place.h"
#include "base/system_error.h"

namespace stanok::web {
namespace {

namespace fs = std::filesystem;

constexpr ::mode_t only_for_owner = 0600;
constexpr ::mode_t too_open = 0027;  // written by the group; anything by others

[[noreturn]] void refuse(const fs::path& file, const std::string& text) {
  throw std::runtime_error(file.string() + ": " + text);
}

void write_all(int descriptor, std::string_view text, const fs::path& file) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno != EINTR) refuse(file, system_error_text(errno));
    if (count > 0) text.remove_prefix(checked_size(count));
  }
}

// False: another process writes the file, or has just put it in its place. One that a power failure
// left behind is nobody's.
bool is_alone_with(int descriptor, const fs::path& file) {
  struct stat opened{};
  struct stat named{};
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &opened) == 0 &&
         ::stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino;
}

void sync_folder_of(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void refuse_open_file(const fs::path& file) {
  struct stat status{};
  if (::stat(file.c_str(), &status) != 0) refuse(file, system_error_text(errno));
  if (status.st_uid != ::geteuid() && status.st_uid != 0)
    refuse(file, "it belongs to another user");
  if ((status.st_mode & too_open) != 0)
    refuse(file, "other users may read or write it; only its owner should: chmod 600");
}

void write_private_file(const fs::path& file, std::string_view text) {
  const fs::path fresh = file.string() + ".new";
  const int descriptor =
      ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, only_for_owner);
  if (descriptor < 0) refuse(fresh, system_error_text(errno));
  if (!is_alone_with(descriptor, fresh)) {
    ::close(descriptor);
    refuse(file, "another process is changing it; try again");
  }
  try {
    if (::ftruncate(descriptor, 0) != 0 || ::fchmod(descriptor, only_for_owner) != 0)
      refuse(fresh, system_error_text(errno));
    write_all(descriptor, text, fresh);
    if (::fsync(descriptor) != 0) refuse(fresh, system_error_text(errno));
    if (::rename(fresh.c_str(), file.c_str()) != 0) refuse(file, system_error_text(errno));
  } catch (...) {
    ::close(descriptor);
    ::unlink(fresh.c_str());
    throw;
  }
  ::close(descriptor);
  sync_folder_of(file);
}

}  // namespace stanok::web

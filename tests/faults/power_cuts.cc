// What a disk holds when the power fails: loaded into a program (LD_PRELOAD) it keeps beside the
// folder POWER_ROOT, in the folder POWER_DISK, an image of what was synchronised.
//
// Of a file that is its text at its last fsync or fdatasync, of a folder its entries at its last
// fsync; nothing else counts. What is there when the program begins counts as synchronised. The
// image is written after the call has done its work and before it returns, so that whatever the
// program says afterwards may rely on it. Files are told apart by inode and birth, as inodes are
// used again.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <string_view>

namespace {

using Sync = int (*)(int);

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

struct Image {
  std::string root = environment("POWER_ROOT");
  std::string disk = environment("POWER_DISK");
  std::mutex mutex;
};

Image& image() {
  static Image one;
  return one;
}

std::string key_of(const struct statx& state) {
  return std::to_string(state.stx_ino) + "." + std::to_string(state.stx_btime.tv_sec) + "." +
         std::to_string(state.stx_btime.tv_nsec);
}

bool state_of(int folder, const char* name, int flags, struct statx& state) {
  return ::statx(folder, name, flags, STATX_BASIC_STATS | STATX_BTIME, &state) == 0;
}

// Whole or not there: the program may be killed at any moment.
void write_image(const std::string& name, const std::string& text) {
  const std::string file = image().disk + "/" + name;
  const std::string made = file + ".new";
  const int out = ::open(made.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (out < 0) return;
  const bool is_written =
      ::write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(out);
  if (is_written) ::rename(made.c_str(), file.c_str());
}

std::string text_of(int file) {
  std::string text;
  char part[65536];
  for (ssize_t count = 0;
       (count = ::pread(file, part, sizeof part, static_cast<off_t>(text.size()))) > 0;)
    text.append(part, static_cast<std::size_t>(count));
  return text;
}

// A line for each: its key, "d" or "f", its name.
std::string entries_of(int folder) {
  std::string lines;
  const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* const listing = again < 0 ? nullptr : ::fdopendir(again);
  if (listing == nullptr) return lines;
  while (const dirent* const entry = ::readdir(listing)) {
    const std::string_view name = entry->d_name;
    struct statx state{};
    if (name == "." || name == ".." || !state_of(folder, entry->d_name, AT_SYMLINK_NOFOLLOW, state))
      continue;
    if (!S_ISDIR(state.stx_mode) && !S_ISREG(state.stx_mode)) continue;
    lines += key_of(state) + (S_ISDIR(state.stx_mode) ? " d " : " f ") + entry->d_name + "\n";
  }
  ::closedir(listing);
  return lines;
}

void note(int descriptor, const struct statx& state) {
  const bool is_folder = S_ISDIR(state.stx_mode);
  const int readable =
      ::open(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), O_RDONLY | O_CLOEXEC);
  if (readable < 0) return;
  write_image(key_of(state), is_folder ? entries_of(readable) : text_of(readable));
  ::close(readable);
}

void note_when_ours(int descriptor) {
  char path[PATH_MAX];
  const ssize_t length =
      ::readlink(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), path, sizeof path);
  if (length <= 0 || image().root.empty()) return;
  if (!std::string_view(path, static_cast<std::size_t>(length)).starts_with(image().root)) return;
  struct statx state{};
  if (!state_of(descriptor, "", AT_EMPTY_PATH, state)) return;
  const std::lock_guard lock(image().mutex);
  note(descriptor, state);
}

void note_all_below(const std::string& path) {
  const int opened = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0) return;
  struct statx state{};
  if (state_of(opened, "", AT_EMPTY_PATH, state)) note(opened, state);
  if (S_ISDIR(state.stx_mode)) {
    const int again = ::dup(opened);
    DIR* const listing = again < 0 ? nullptr : ::fdopendir(again);
    while (const dirent* const entry = listing == nullptr ? nullptr : ::readdir(listing)) {
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..") note_all_below(path + "/" + entry->d_name);
    }
    if (listing != nullptr) ::closedir(listing);
  }
  ::close(opened);
}

int synchronise(const char* call, int descriptor) {
  const auto real = reinterpret_cast<Sync>(::dlsym(RTLD_NEXT, call));
  const int result = real(descriptor);
  const int error = errno;
  if (result == 0) note_when_ours(descriptor);
  errno = error;
  return result;
}

[[gnu::constructor]] void begin() {
  if (!image().root.empty()) note_all_below(image().root);
}

}  // namespace

extern "C" {

int fsync(int descriptor) {
  return synchronise("fsync", descriptor);
}
int fdatasync(int descriptor) {
  return synchronise("fdatasync", descriptor);
}
}

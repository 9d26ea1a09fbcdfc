#include "client/operator/link_page.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>

#include "base/file_descriptor.h"
#include "base/place.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

// A browser that is not in memory yet takes its time.
constexpr auto page_time = std::chrono::seconds(30);

// The folder of this login, which only its user enters; else the one for temporary files.
fs::path folder_for_pages() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");  // NOLINT(concurrency-mt-unsafe)
  struct stat status{};
  if (runtime != nullptr && ::stat(runtime, &status) == 0 && S_ISDIR(status.st_mode) &&
      status.st_uid == ::getuid())
    return runtime;
  std::error_code ignored;
  return fs::temp_directory_path(ignored);
}

std::string in_html(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string page_to(const std::string& link) {
  const std::string target = in_html(link);
  return "<!doctype html><meta charset=\"utf-8\"><title>stanok</title>"
         "<meta name=\"referrer\" content=\"no-referrer\">"
         "<meta http-equiv=\"refresh\" content=\"0; url=" +
         target + "\"><a href=\"" + target + "\">stanok</a>\n";
}

void remove_page(const fs::path& page) {
  std::error_code ignored;
  fs::remove(page, ignored);
  fs::remove(page.parent_path(), ignored);
}

// Nothing: there is no place for it.
std::optional<fs::path> written_page(const std::string& link) {
  std::string folder = (folder_for_pages() / "stanok-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return std::nullopt;
  constexpr ::mode_t only_for_owner = 0600;
  fs::path page = fs::path(folder) / "panel.html";
  const FileDescriptor file(
      ::open(page.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, only_for_owner));
  const std::string text = page_to(link);
  const bool is_written = file.is_open() && ::write(file.number(), text.data(), text.size()) ==
                                                static_cast<ssize_t>(text.size());
  if (is_written) return page;
  remove_page(page);
  return std::nullopt;
}

bool start_browser(const fs::path& page) {
  std::string program = "xdg-open";
  std::string place = page.string();
  std::array<char*, 3> arguments{program.data(), place.data(), nullptr};
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0;
}

// In a process of its own, that nothing waits for: it lets go of terminal and pipes.
void remove_later(const fs::path& page) {
  const pid_t process = ::fork();
  if (process < 0) return remove_page(page);
  if (process > 0) return;
  ::setsid();
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(stream);
  std::this_thread::sleep_for(page_time);
  remove_page(page);
  ::_exit(0);
}

}  // namespace

bool open_in_browser(const std::string& link) {
  const auto page = written_page(link);
  if (!page) return false;
  const bool is_started = start_browser(*page);
  if (is_started) {
    remove_later(*page);
  } else {
    remove_page(*page);
  }
  return is_started;
}

}  // namespace stanok::client

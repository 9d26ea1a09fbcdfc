#include "recording/plot/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <fstream>

namespace stanok::recording {
namespace {

constexpr int significant_digits = 9;

// Starts gnuplot on that script; the error number when it cannot be started.
int spawn(const std::filesystem::path& script, pid_t& process) {
  const std::string directory = script.has_parent_path() ? script.parent_path().string() : ".";
  std::string program = "gnuplot";
  std::string name = script.filename().string();
  const std::array<char*, 3> arguments{program.data(), name.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  const int error =
      posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// A file that is there as long as the object.
class TemporaryScript {
 public:
  explicit TemporaryScript(const std::string& text) {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "stanok-picture-XXXXXX").string();
    const int descriptor = mkstemp(pattern.data());
    if (descriptor < 0) return;
    close(descriptor);
    path_ = pattern;
    std::ofstream(path_) << text;
  }
  ~TemporaryScript() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryScript(const TemporaryScript&) = delete;
  TemporaryScript& operator=(const TemporaryScript&) = delete;

  // Empty: it could not be written.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::optional<LogError> run_gnuplot(const std::filesystem::path& script) {
  pid_t process = 0;
  const int error = spawn(script, process);
  if (error == ENOENT) {
    return LogError{error, "gnuplot is not installed; install the package gnuplot-nox"};
  }
  if (error != 0) {
    return log_error("cannot start gnuplot", error);
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::nullopt;
  return LogError{0, "gnuplot failed on " + script.string()};
}

std::optional<LogError> draw(const std::string& script) {
  const TemporaryScript file(script);
  if (file.path().empty()) return log_error("cannot write a temporary file", errno);
  return run_gnuplot(file.path());
}

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < ' ';
    result += is_control ? ' ' : c;
    if (c == '\'') result += c;
  }
  return result + "'";
}

std::string number(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, significant_digits)
                       .ptr;
  return {digits.data(), end};
}

std::string data_block(const std::string& name, const std::vector<std::vector<double>>& rows) {
  std::string text = "$" + name + " << END\n";
  for (const std::vector<double>& row : rows) {
    for (const double value : row) text += number(value) + " ";
    text += "\n";
  }
  return text + "END\n";
}

}  // namespace stanok::recording

#include "client/offline/batch/slurm.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <memory>
#include <sstream>
#include <system_error>

#include "base/file_descriptor.h"

namespace stanok::client {
namespace {

struct Answer {
  int exit_code = 0;
  std::string text;  // what it wrote to both of its outputs
};

std::string all_of(int descriptor) {
  std::string text;
  std::array<char, 1 << 16> part;
  while (true) {
    const ssize_t count = ::read(descriptor, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

SlurmError missing(const std::string& program, int error) {
  return SlurmError("cannot start " + program + ": " + std::generic_category().message(error) +
                    "; install Slurm's commands (Debian: slurm-client) on this computer, or use "
                    "--engine local");
}

Answer ask(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw SlurmError("no pipe can be made");
  const FileDescriptor reading(ends[0]);
  auto writing = std::make_unique<FileDescriptor>(ends[1]);
  std::vector<std::string> own(words);
  std::vector<char*> arguments;
  arguments.reserve(own.size() + 1);
  for (std::string& word : own) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_adddup2(&actions, writing->number(), stream);
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw missing(words.front(), error);
  writing.reset();
  Answer answer{.text = all_of(reading.number())};
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  answer.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return answer;
}

// What the command wrote; throws where it failed.
std::string told(const std::vector<std::string>& words, const std::string& remedy) {
  Answer answer = ask(words);
  if (answer.exit_code == 0) return std::move(answer.text);
  while (!answer.text.empty() && answer.text.back() == '\n') answer.text.pop_back();
  throw SlurmError(words.front() + " failed with exit code " + std::to_string(answer.exit_code) +
                   ": " + answer.text + "\n  help: " + remedy);
}

std::string script_of(const ArrayJob& job) {
  std::string script = "exec";
  for (const std::string& word : job.command) script += " " + shell_word(word);
  return script + " \"$SLURM_ARRAY_TASK_ID\"";
}

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

std::string array_text(const std::vector<std::size_t>& tasks) {
  std::string text;
  for (std::size_t k = 0; k < tasks.size();) {
    std::size_t last = k;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += std::to_string(tasks[k]);
    if (last > k) text += "-" + std::to_string(tasks[last]);
    k = last + 1;
  }
  return text;
}

std::string submit_tasks(const ArrayJob& job, const std::vector<std::size_t>& tasks) {
  std::vector<std::string> words{"sbatch",
                                 "--parsable",
                                 "--requeue",
                                 "--nodes=1",
                                 "--ntasks=1",
                                 "--job-name=" + job.name,
                                 "--cpus-per-task=" + std::to_string(job.processors),
                                 "--chdir=" + job.directory.string(),
                                 "--output=" + (job.log / "%a.txt").string(),
                                 "--open-mode=append"};
  words.insert(words.end(), job.options.begin(), job.options.end());
  words.push_back("--array=" + array_text(tasks));
  words.push_back("--wrap=" + script_of(job));
  std::string number = told(
      words,
      "look with sinfo whether the cluster is up; larger chunks (--chunk) make fewer tasks, if it "
      "does not take so many (MaxArraySize, MaxJobCount); --sbatch passes options on");
  return number.substr(0, number.find_first_of(";\n"));
}

std::map<std::size_t, TaskState> queued_tasks(const std::string& name) {
  constexpr const char* states =
      "--states=PENDING,CONFIGURING,RUNNING,COMPLETING,SUSPENDED,REQUEUED,REQUEUE_FED,REQUEUE_HOLD,"
      "RESIZING,SIGNALING,STAGE_OUT,STOPPED,SPECIAL_EXIT";
  const std::string rows =
      told({"squeue", "--noheader", "--array", "--name=" + name, states, "--format=%K %T"},
           "look with sinfo whether the cluster is up");
  std::map<std::size_t, TaskState> tasks;
  std::istringstream lines(rows);
  std::string number;
  std::string state;
  while (lines >> number >> state) {
    std::size_t task = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), task);
    if (error != std::errc{} || end != number.data() + number.size()) {
      std::getline(lines, state);  // a warning of squeue
      continue;
    }
    const bool runs = state == "RUNNING" || state == "STAGE_OUT" || state == "SIGNALING";
    tasks[task] = runs ? TaskState::running : TaskState::pending;
  }
  return tasks;
}

void cancel_tasks(const std::string& name) {
  static_cast<void>(
      told({"scancel", "--name=" + name}, "look with sinfo whether the cluster is up"));
}

}  // namespace stanok::client

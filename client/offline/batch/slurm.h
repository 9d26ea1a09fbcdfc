// The queue of Slurm, by its own commands: sbatch, squeue, scancel (22.05 and later).
//
// The tasks of a batch are found by the name of their jobs alone: no number of a job has to be kept
// anywhere, and none can be lost between sbatch and a file. Every function throws SlurmError.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace stanok::client {

// A command is missing, or said no: its words, and a remedy.
class SlurmError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class TaskState { pending, running };

struct ArrayJob {
  std::string name;
  std::filesystem::path log;         // folder for what tasks write
  std::filesystem::path directory;   // where tasks run
  int processors = 1;                // of a task
  std::vector<std::string> options;  // for sbatch, as they are
  std::vector<std::string> command;  // the number of the task is added to it
};

// The number of the job. A task whose node is lost is put into the queue again by Slurm.
std::string submit_tasks(const ArrayJob& job, const std::vector<std::size_t>& tasks);
// Tasks of jobs of that name that wait or run.
[[nodiscard]] std::map<std::size_t, TaskState> queued_tasks(const std::string& name);
void cancel_tasks(const std::string& name);

// "0-3,7": numbers in ascending order as sbatch wants them.
[[nodiscard]] std::string array_text(const std::vector<std::size_t>& tasks);
// A word as the shell reads it back.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace stanok::client

// RecordedFiles: the programs of a log, in the order in which they were asked for.
//
// Threads: one reads the log and adds, another one asks, which waits for what may still come.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "lang/contract/environment.h"
#include "recording/format/encode_inputs.h"

namespace stanok::runtime {

class RecordedFiles final : public lang::Files {
 public:
  void add(const program_read_t& read);
  void add_text(std::uint64_t hash, std::string text);
  // Nothing will be added any more.
  void finish();
  // Somebody waits for what has not been added yet.
  [[nodiscard]] bool is_awaited() const;

  // What the same question found in the recorded run, the first time, the second time...
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override;

 private:
  struct Answer {
    bool found = false;
    std::uint64_t hash = 0;
    std::string path;
  };
  using Question = std::pair<std::string, std::string>;

  [[nodiscard]] bool knows(const Question& question) const;

  mutable std::mutex mutex_;
  mutable std::condition_variable news_;
  mutable std::map<Question, std::deque<Answer>> answers_;
  std::map<std::uint64_t, std::string> texts_;
  bool is_finished_ = false;
  mutable bool is_awaited_ = false;
};

}  // namespace stanok::runtime

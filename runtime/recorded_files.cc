#include "runtime/recorded_files.h"

#include "base/utf8.h"
#include "recording/format/encode.h"

namespace stanok::runtime {

using recording::text_of;

void RecordedFiles::add(const program_read_t& read) {
  const std::lock_guard lock(mutex_);
  answers_[{std::string(text_of(read.name)), std::string(text_of(read.from))}].push_back(
      {read.found != 0, static_cast<std::uint64_t>(read.hash), std::string(text_of(read.path))});
  news_.notify_all();
}

void RecordedFiles::add_text(std::uint64_t hash, std::string text) {
  const std::lock_guard lock(mutex_);
  texts_[hash] = std::move(text);
  news_.notify_all();
}

void RecordedFiles::finish() {
  const std::lock_guard lock(mutex_);
  is_finished_ = true;
  news_.notify_all();
}

bool RecordedFiles::is_awaited() const {
  const std::lock_guard lock(mutex_);
  return is_awaited_;
}

bool RecordedFiles::knows(const Question& question) const {
  const auto answers = answers_.find(question);
  if (answers == answers_.end() || answers->second.empty()) return false;
  const Answer& answer = answers->second.front();
  return !answer.found || texts_.contains(answer.hash);
}

Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> RecordedFiles::read(
    std::string_view name, std::string_view from) const {
  const Question question{valid_utf8(name), valid_utf8(from)};  // as a log has them
  std::unique_lock lock(mutex_);
  is_awaited_ = true;
  news_.wait(lock, [&] { return is_finished_ || knows(question); });
  is_awaited_ = false;
  const auto answers = answers_.find(question);
  const bool is_known = answers != answers_.end() && !answers->second.empty();
  const Answer answer = is_known ? answers->second.front() : Answer{};
  if (is_known) answers->second.pop_front();
  const auto text = texts_.find(answer.hash);
  if (!answer.found || text == texts_.end()) {
    Diagnostic fault;
    fault.code = "E7001";
    fault.message = "the file was not found: " + std::string(name);
    return Unexpected<Diagnostic>(std::move(fault));
  }
  auto source = std::make_shared<lang::SourceText>();
  source->name = std::string(name);
  source->path = answer.path;
  source->text = text->second;
  return std::shared_ptr<const lang::SourceText>(std::move(source));
}

}  // namespace stanok::runtime

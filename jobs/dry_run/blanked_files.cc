#include "jobs/dry_run/blanked_files.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "base/utf8.h"

namespace stanok::jobs {

bool BlankedFiles::blank(const Diagnostics& errors) {
  constexpr std::string_view unused_word = "E4003";
  bool is_new = false;
  for (const Diagnostic& error : errors) {
    const Place& place = error.place;
    if (error.severity != Severity::error || place.line <= 0) continue;
    const Word word{place.line, place.column, place.end_column};
    if (error.code == unused_word && place.line == place.end_line &&
        words_[place.file].insert(word).second) {
      is_new = true;
      continue;
    }
    for (int line = place.line; line <= std::max(place.line, place.end_line); ++line)
      is_new = lines_[place.file].insert(line).second || is_new;
  }
  return is_new;
}

bool BlankedFiles::is_blank(const Place& place) const {
  const auto lines = lines_.find(place.file);
  return lines != lines_.end() && lines->second.contains(place.line);
}

bool BlankedFiles::may_miss_before(const Place& place) const {
  const auto lines = lines_.find(place.file);
  const bool only_behind = lines == lines_.end() || *lines->second.begin() > place.line;
  return !only_behind || lines_.size() > (lines == lines_.end() ? 0U : 1U);
}

// Words do not overlap: the one that begins here or before is the only one that can.
bool BlankedFiles::stands_in(const std::set<Word>& words, int line, int column) {
  const auto behind = words.upper_bound({line, column, std::numeric_limits<int>::max()});
  if (behind == words.begin()) return false;
  const Word& word = *std::prev(behind);
  return word.line == line && column < word.end_column;
}

Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> BlankedFiles::read(
    std::string_view name, std::string_view from) const {
  auto read = files_.read(name, from);
  if (!read) return read;
  const auto lines = lines_.find((*read)->name);
  const auto words = words_.find((*read)->name);
  auto text = std::make_shared<lang::SourceText>(**read);
  const auto is_at_fault = [&](int line, int column) {
    if (lines != lines_.end() && lines->second.contains(line)) return true;
    return words != words_.end() && stands_in(words->second, line, column);
  };
  int line = 1;
  int column = 0;  // of characters, as in places
  for (char& c : text->text) {
    if (!continues_character(c)) ++column;
    if (c == '\n') {
      ++line;
      column = 0;
    } else if (c != '\r' && is_at_fault(line, column)) {
      c = ' ';
    }
  }
  return std::shared_ptr<const lang::SourceText>(std::move(text));
}

}  // namespace stanok::jobs

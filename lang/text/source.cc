#include "lang/text/source.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"
#include "lang/text/dialect_line.h"

namespace stanok::lang {
namespace {

std::size_t line_end_from(std::string_view text, std::size_t offset) {
  while (offset < text.size() && !is_line_end(text[offset])) ++offset;
  return offset;
}

// The offset after the line end that stands at `offset` (LF, CRLF or CR).
std::size_t after_line_end(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return text.size();
  const bool pair = text[offset] == '\r' && offset + 1 < text.size() && text[offset + 1] == '\n';
  return offset + (pair ? 2 : 1);
}

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool is_leader(char c) {
  return c == '\0' || is_blank(c) || is_line_end(c);
}

int characters(std::string_view text) {
  return static_cast<int>(character_count(text));
}

// Where the parenthesis at `at` is closed, those inside it counted; npos: it is not.
std::size_t closing_parenthesis(std::string_view text, std::size_t at) {
  for (int open = 0; at < text.size(); ++at) {
    if (text[at] == '(') ++open;
    if (text[at] == ')' && --open == 0) return at;
  }
  return std::string_view::npos;
}

// Behind lines with nothing but blanks and one comment in parentheses or behind `;`.
std::size_t behind_comment_lines(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    const std::size_t end = line_end_from(text, at);
    std::size_t first = at;
    while (first < end && is_blank(text[first])) ++first;
    std::size_t last = end;
    while (last > first && is_blank(text[last - 1])) --last;
    const bool in_parentheses =
        last > first && text[first] == '(' && closing_parenthesis(text, first) == last - 1;
    const bool is_comment = first == last || text[first] == ';' || in_parentheses;
    if (!is_comment) return first;
    at = after_line_end(text, end);
  }
  return at;
}

}  // namespace

Span joined(const Span& first, const Span& last) {
  const std::size_t end = std::max(first.offset + first.length, last.offset + last.length);
  return {first.offset, static_cast<std::uint32_t>(end - first.offset), first.line};
}

const char* behind_line(const char* at, const char* end) {
  while (at != end && !is_line_end(*at)) ++at;
  if (at == end) return at;
  return at + (end - at > 1 && at[0] == '\r' && at[1] == '\n' ? 2 : 1);
}

std::string folded(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(), lower_case);
  return text;
}

Source::Source(std::shared_ptr<const SourceText> text, const TextRules& usual)
    : text_(std::move(text)) {
  if (!is_utf8(text_->text)) {
    auto repaired = std::make_shared<SourceText>(*text_);
    repaired->text = valid_utf8(text_->text);
    text_ = std::move(repaired);
    is_repaired_ = true;
  }
  end_ = text_->text.size();
  if (text_->text.starts_with(utf8_mark)) begin_ = utf8_mark.size();
  find_frame();
  find_dialect(usual);
}

// The first line that is not empty.
Span Source::first_words() const {
  std::size_t first = first_;
  const auto is_space = [&](std::size_t at) {
    return is_blank(text_->text[at]) || is_line_end(text_->text[at]);
  };
  while (first < end_ && is_space(first)) ++first;
  std::size_t last = line_end_from(text_->text, first);
  while (last > first && is_blank(text_->text[last - 1])) --last;
  return {first, static_cast<std::uint32_t>(last - first), line_number(first)};
}

void Source::find_dialect(const TextRules& usual) {
  DialectLine line = dialect_line(text(first_words()), usual);
  const bool says_nothing = !line.rules && line.problem.empty();
  if (first_ != begin_ && says_nothing) {
    first_ = begin_;
    line = dialect_line(text(first_words()), usual);
  }
  rules_ = line.rules.value_or(usual);
  dialect_problem_ = std::move(line.problem);
}

// The frame: an optional line that begins with %, with nothing but comments before it, and its
// partner.
void Source::find_frame() {
  const std::string_view whole = text();
  std::size_t offset = begin_;
  while (offset < whole.size() && is_leader(whole[offset])) ++offset;
  const bool has_leader =
      whole.substr(begin_, offset - begin_).find('\0') != std::string_view::npos;
  first_ = offset;
  offset = behind_comment_lines(whole, offset);
  const bool framed = offset < whole.size() && whole[offset] == '%';
  if (!framed) offset = first_;
  if (framed) {
    lone_frame_mark_ = {offset, 1, line_number(offset)};
    begin_ = after_line_end(whole, line_end_from(whole, offset));
  } else if (has_leader) {
    begin_ = offset;
  }
  if (first_ == offset) first_ = begin_;
  begin_line_ = line_number(begin_);
  for (std::size_t at = begin_; at < whole.size();) {
    const std::size_t line_end = line_end_from(whole, at);
    while (at < line_end && is_blank(whole[at])) ++at;
    if (at < line_end && whole[at] == '%') {
      end_ = at;
      lone_frame_mark_ = framed ? Span{} : Span{at, 1, line_number(at)};
      return;
    }
    at = after_line_end(whole, line_end);
  }
}

std::string_view Source::text(const Span& span) const {
  return text().substr(span.offset, span.length);
}

std::string_view Source::line_at(std::size_t offset) const {
  const std::string_view whole = text();
  std::size_t start = std::min(offset, whole.size());
  while (start > 0 && !is_line_end(whole[start - 1])) --start;
  return whole.substr(start, line_end_from(whole, start) - start);
}

std::uint32_t Source::line_number(std::size_t offset) const {
  const std::string_view whole = text();
  std::uint32_t line = 1;
  for (std::size_t at = line_end_from(whole, 0); at < offset && at < whole.size();) {
    const std::size_t next = after_line_end(whole, at);
    if (next > offset) break;
    ++line;
    at = line_end_from(whole, next);
  }
  return line;
}

std::size_t Source::line_count() const {
  const std::string_view whole = text();
  if (whole.empty()) return 0;
  const std::size_t lines = line_number(whole.size());
  return is_line_end(whole.back()) ? lines - 1 : lines;
}

Span Source::words_of_line(std::uint32_t line) const {
  const std::string_view whole = text();
  std::size_t start = 0;
  for (std::uint32_t at = 1; at < line && start < whole.size(); ++at)
    start = after_line_end(whole, line_end_from(whole, start));
  std::size_t end = line_end_from(whole, start);
  if (start == 0 && whole.starts_with(utf8_mark)) start = utf8_mark.size();
  while (start < end && (line == 1 ? is_leader(whole[start]) : is_blank(whole[start]))) ++start;
  while (end > start && is_blank(whole[end - 1])) --end;
  return {start, static_cast<std::uint32_t>(end - start), line};
}

Place Source::place(const Span& span) const {
  const std::string_view line = line_at(span.offset);
  const std::size_t start = offset_of(line);
  const std::size_t inside = std::min(span.offset - start, line.size());
  const std::size_t length = std::min<std::size_t>(span.length, line.size() - inside);
  Place place;
  place.file = name();
  place.line = static_cast<int>(span.line);
  place.column = characters(line.substr(0, inside)) + 1;
  place.end_line = place.line;
  place.end_column = place.column + std::max(characters(line.substr(inside, length)), 1);
  return place;
}

}  // namespace stanok::lang

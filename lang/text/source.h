// A program text in the hands of the compiler: what of it is read, and where an offset stands.
//
// The text is read once and shared; tokens, trees and compiled code refer to it by byte offsets
// and are turned into file:line:column only when something is said about them. It is UTF-8: bytes
// that are no text become U+FFFD here, so that no name, message or picture of a line holds them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "lang/contract/dialect.h"
#include "lang/contract/environment.h"

namespace stanok::lang {

// A piece of a program text.
struct Span {
  std::size_t offset = 0;
  std::uint32_t length = 0;
  std::uint32_t line = 0;  // of its first byte, 1-based
};

// The span from the first byte of `first` to the last of `last`.
[[nodiscard]] Span joined(const Span& first, const Span& last);

class Source {
 public:
  // `usual`: the rules of a text whose first line does not name a dialect.
  explicit Source(std::shared_ptr<const SourceText> text, const TextRules& usual = {});

  [[nodiscard]] const std::string& name() const { return text_->name; }
  [[nodiscard]] const std::string& path() const { return text_->path; }
  [[nodiscard]] std::string_view text() const { return text_->text; }
  // Whether some bytes of the file were not UTF-8.
  [[nodiscard]] bool is_repaired() const { return is_repaired_; }
  [[nodiscard]] const std::shared_ptr<const SourceText>& shared_text() const { return text_; }
  [[nodiscard]] std::string_view text(const Span& span) const;

  // What is read: without byte order mark, tape leaders and frame lines (%).
  [[nodiscard]] std::size_t begin() const { return begin_; }
  [[nodiscard]] std::size_t end() const { return end_; }
  [[nodiscard]] std::uint32_t begin_line() const { return begin_line_; }
  [[nodiscard]] const TextRules& rules() const { return rules_; }
  // What is wrong with the line that names the dialect, and where; empty: nothing.
  [[nodiscard]] const std::string& dialect_problem() const { return dialect_problem_; }
  [[nodiscard]] Span first_words() const;
  // The only frame mark of a text that has just one; length 0 otherwise.
  [[nodiscard]] Span lone_frame_mark() const { return lone_frame_mark_; }

  [[nodiscard]] Place place(const Span& span) const;
  // Of a character of the text.
  [[nodiscard]] std::size_t offset_of(const char* character) const {
    return static_cast<std::size_t>(character - text_->text.data());
  }
  // Of a part of the text.
  [[nodiscard]] std::size_t offset_of(std::string_view part) const {
    return offset_of(std::to_address(part.begin()));
  }
  // The text of the line in which `offset` stands, without its end.
  [[nodiscard]] std::string_view line_at(std::size_t offset) const;
  [[nodiscard]] std::uint32_t line_number(std::size_t offset) const;
  [[nodiscard]] std::size_t line_count() const;
  // A line without the blanks around it and what comes before the program in it (the mark of UTF-8,
  // a leader); empty beyond the end of the text.
  [[nodiscard]] Span words_of_line(std::uint32_t line) const;

 private:
  void find_frame();
  void find_dialect(const TextRules& usual);

  std::shared_ptr<const SourceText> text_;
  bool is_repaired_ = false;
  std::size_t first_ = 0;  // comments before the frame, or begin_
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint32_t begin_line_ = 1;
  Span lone_frame_mark_;
  TextRules rules_;
  std::string dialect_problem_;
};

[[nodiscard]] constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
[[nodiscard]] constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
[[nodiscard]] constexpr bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
[[nodiscard]] constexpr bool is_name_start(char c) {
  return is_letter(c) || c == '_';
}
[[nodiscard]] constexpr bool is_name_part(char c) {
  return is_name_start(c) || is_digit(c);
}
[[nodiscard]] constexpr char upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
[[nodiscard]] constexpr char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
// The beginning of the line that follows the one at `at`; `end` behind the last.
[[nodiscard]] const char* behind_line(const char* at, const char* end);
[[nodiscard]] std::string folded(std::string_view name);  // ASCII lower case

}  // namespace stanok::lang

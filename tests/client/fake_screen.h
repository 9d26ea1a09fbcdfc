// FakeScreen: a terminal as a grid of characters, after ECMA-48 as far as `stanok` uses it.
//
// A line feed begins a new line (the driver of a terminal adds the carriage return), a character
// behind the last column wraps, the last line scrolls. Anything it does not know is a failure.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "base/utf8.h"

namespace stanok::client {

class FakeScreen {
 public:
  FakeScreen(std::size_t columns, std::size_t lines) : columns_(columns), grid_(lines) {}

  void write(std::string_view text) {
    while (!text.empty()) text.remove_prefix(take(text));
  }

  // The lines without blanks at their ends, down to the last one with anything on it.
  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> shown;
    for (const auto& row : grid_) shown.push_back(text_of(row));
    while (!shown.empty() && shown.back().empty()) shown.pop_back();
    return shown;
  }
  // What has gone off the top.
  [[nodiscard]] const std::vector<std::string>& scrolled() const { return scrolled_; }
  // How often a character had to wrap.
  [[nodiscard]] int wraps() const { return wraps_; }

 private:
  using Row = std::vector<std::string>;  // one character a column

  static std::string text_of(const Row& row) {
    std::string text;
    for (const std::string& character : row) text += character.empty() ? " " : character;
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  }

  std::size_t take(std::string_view text) {
    if (text.starts_with("\033[")) return take_sequence(text);
    if (text[0] == '\n') {
      column_ = 0;
      next_line();
      return 1;
    }
    if (text[0] == '\r') {
      column_ = 0;
      return 1;
    }
    EXPECT_TRUE(text[0] < 0 || text[0] >= ' ') << "control character " << int{text[0]};
    const std::size_t length = std::max<std::size_t>(1, character_length(text, 0));
    put(std::string(text.substr(0, length)));
    return length;
  }

  std::size_t take_sequence(std::string_view text) {
    const std::size_t end = text.find_first_not_of("0123456789;", 2);
    const auto number = static_cast<std::size_t>(std::atoi(std::string(text.substr(2)).c_str()));
    switch (text[end]) {
      case 'F':
        line_ -= std::min(line_, std::max<std::size_t>(1, number));
        column_ = 0;
        break;
      case 'K':
        EXPECT_EQ(number, 0U);
        erase_line();
        break;
      case 'J':
        EXPECT_EQ(number, 0U);
        erase_line();
        for (std::size_t k = line_ + 1; k < grid_.size(); ++k) grid_[k].clear();
        break;
      case 'm':
        break;
      default:
        ADD_FAILURE() << "unknown sequence " << text.substr(1, end);
    }
    return end + 1;
  }

  void erase_line() {
    if (grid_[line_].size() > column_) grid_[line_].resize(column_);
  }

  void put(const std::string& character) {
    if (column_ == columns_) {
      ++wraps_;
      column_ = 0;
      next_line();
    }
    Row& row = grid_[line_];
    if (row.size() <= column_) row.resize(column_ + 1);
    row[column_++] = character;
  }

  void next_line() {
    if (++line_ < grid_.size()) return;
    scrolled_.push_back(text_of(grid_.front()));
    grid_.erase(grid_.begin());
    grid_.emplace_back();
    --line_;
  }

  std::size_t columns_;
  std::vector<Row> grid_;
  std::vector<std::string> scrolled_;
  std::size_t line_ = 0;
  std::size_t column_ = 0;
  int wraps_ = 0;
};

}  // namespace stanok::client

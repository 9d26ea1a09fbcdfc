// The lines of a part program as text: what words they have.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace stanok::jobs {

class ProgramText {
 public:
  explicit ProgramText(const std::string& text);

  // By number, from 1.
  [[nodiscard]] const std::map<std::uint32_t, std::string>& lines() const { return lines_; }
  [[nodiscard]] const std::string* line(std::uint32_t number) const;

  // Outside comments.
  [[nodiscard]] static bool has_word(const std::string& line, const std::string& word);
  // The number behind the first such letter; nothing: there is none, or an expression.
  [[nodiscard]] static std::optional<double> value(const std::string& line, char word);
  // An F that is no number.
  [[nodiscard]] static bool has_feed_expression(const std::string& line);

 private:
  std::map<std::uint32_t, std::string> lines_;
};

}  // namespace stanok::jobs

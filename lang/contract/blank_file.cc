#include "lang/contract/blank_file.h"

#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>

namespace stanok::lang {
namespace {

constexpr std::string_view title = "blank-of-stl-file";
constexpr int digits = 17;  // a double comes back as it was

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

bool names_stl_file(std::string_view name) {
  constexpr std::string_view ending = ".stl";
  if (name.size() <= ending.size()) return false;
  const std::string_view last = name.substr(name.size() - ending.size());
  for (std::size_t k = 0; k < ending.size(); ++k) {
    if (lower(last[k]) != ending[k]) return false;
  }
  return true;
}

std::string text_of(const BlankFile& file) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << title << ' ' << file.fingerprint;
  for (const double value : file.low) text << ' ' << value;
  for (const double value : file.high) text << ' ' << value;
  text << '\n';
  return text.str();
}

std::optional<BlankFile> read_blank_file(std::string_view text) {
  std::istringstream words{std::string(text)};
  words.imbue(std::locale::classic());
  std::string first;
  BlankFile file;
  words >> first >> file.fingerprint;
  for (double& value : file.low) words >> value;
  for (double& value : file.high) words >> value;
  if (!words || first != title) return std::nullopt;
  for (std::size_t k = 0; k < file.low.size(); ++k) {
    if (!std::isfinite(file.low[k]) || !std::isfinite(file.high[k])) return std::nullopt;
  }
  return file;
}

}  // namespace stanok::lang

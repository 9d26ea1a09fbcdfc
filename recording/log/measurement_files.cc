#include "recording/log/measurement_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "recording/log/bounded_text.h"

namespace stanok::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view opening = "measured ";
// Columns of the CSV file; JSON lines have all names.
constexpr std::array columns{"x",       "y",       "z",       "size",       "angle",
                             "error_x", "error_y", "error_z", "error_size", "error_angle"};

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::string_view take_word(std::string_view& text) {
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, blank);
  text.remove_prefix(std::min(blank + 1, text.size()));
  return word;
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string csv_head() {
  std::string head = "utime,cycle,channel,feature";
  for (const char* const column : columns) head += std::string(",") + column;
  return head + "\n";
}

std::string csv_line(const channels::Event& event, std::int64_t utime, const Measurement& one) {
  std::string line = std::to_string(utime) + "," + std::to_string(event.cycle) + "," +
                     std::to_string(event.channel) + "," + one.feature;
  for (const char* const column : columns) {
    line += ",";
    if (const auto value = one.values.find(column); value != one.values.end())
      line += number_text(value->second);
  }
  return line + "\n";
}

std::string json_line(const channels::Event& event, std::int64_t utime, const Measurement& one) {
  std::string line =
      "{\"utime\":" + std::to_string(utime) + ",\"cycle\":" + std::to_string(event.cycle) +
      ",\"channel\":" + std::to_string(event.channel) + ",\"feature\":\"" + one.feature + "\"";
  for (const auto& [name, value] : one.values) line += ",\"" + name + "\":" + number_text(value);
  return line + "}\n";
}

}  // namespace

std::optional<Measurement> measurement_of(std::string_view text) {
  if (!text.starts_with(opening)) return std::nullopt;
  text.remove_prefix(opening.size());
  Measurement measurement;
  measurement.feature = take_word(text);
  if (!is_name(measurement.feature)) return std::nullopt;
  while (!text.empty()) {
    const std::string_view word = take_word(text);
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos || !is_name(word.substr(0, equals))) return std::nullopt;
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto [behind, fault] = std::from_chars(word.data() + equals + 1, end, value);
    if (fault != std::errc() || behind != end || !std::isfinite(value)) return std::nullopt;
    measurement.values[std::string(word.substr(0, equals))] = value;
  }
  return measurement;
}

MeasurementFiles::MeasurementFiles(fs::path directory, std::string name,
                                   std::int64_t size_max_bytes)
    : directory_(std::move(directory)), name_(std::move(name)), size_max_bytes_(size_max_bytes) {}

void MeasurementFiles::take(const channels::Event& event, std::int64_t utime) {
  const auto measurement = measurement_of(event.text.view());
  if (!measurement || !event.code.view().empty()) return;
  error_.clear();
  append("csv", csv_head(), csv_line(event, utime, *measurement));
  append("jsonl", "", json_line(event, utime, *measurement));
}

void MeasurementFiles::append(const char* ending, std::string_view head, const std::string& line) {
  const std::string fault =
      append_line({directory_ / (name_ + "." + ending), head, size_max_bytes_}, line);
  if (!fault.empty()) error_ = fault;
}

}  // namespace stanok::recording

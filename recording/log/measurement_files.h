// MeasurementFiles: what programs measured, one line each, as CSV and as JSON lines, for people and
// for tables of quality.
//
// A measurement is a text that a program logs: "measured FEATURE name=value name=value ...", as the
// cycles of programs/cycles/measure do. Files are NAME.csv and NAME.jsonl; they are made with the
// first measurement and go on with the next run. One that is larger than its bound becomes
// NAME.1.csv, in place of an older one. A disk that is full stops nothing: the reason stands in
// `error`. One thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "channels/contract/output.h"

namespace stanok::recording {

struct Measurement {
  std::string feature;
  std::map<std::string, double> values;  // mm and deg; by name
};

// Nothing: the text is no measurement.
[[nodiscard]] std::optional<Measurement> measurement_of(std::string_view text);

class MeasurementFiles {
 public:
  static constexpr std::int64_t size_max_default = 5'000'000;  // bytes of one file

  MeasurementFiles(std::filesystem::path directory, std::string name,
                   std::int64_t size_max_bytes = size_max_default);

  // `utime`: of the event, us. What is no measurement is left alone.
  void take(const channels::Event& event, std::int64_t utime);

  // Why the last measurement was not written; empty: it was.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void append(const char* ending, std::string_view head, const std::string& line);

  std::filesystem::path directory_;
  std::string name_;
  std::int64_t size_max_bytes_;
  std::string error_;
};

}  // namespace stanok::recording

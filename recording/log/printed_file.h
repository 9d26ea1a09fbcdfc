// PrintedFile: what programs print with DPRNT, line by line, as the text file that a control would
// send to its printer port.
//
// A printed line is a text that a program logs: "printed TEXT". The file is NAME.txt; it is made
// with the first line and goes on with the next run, within the bound of append_line. The name is
// the machine's: a program chooses none, and so no path. A disk that is full stops nothing: the
// reason stands in `error`. One thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "channels/contract/output.h"

namespace stanok::recording {

// The line that a logged text prints, without characters that are none of a line. Nothing: the text
// is no printed line.
[[nodiscard]] std::optional<std::string> printed_line_of(std::string_view text);

class PrintedFile {
 public:
  static constexpr std::int64_t size_max_default = 5'000'000;  // bytes

  PrintedFile(const std::filesystem::path& directory, const std::string& name,
              std::int64_t size_max_bytes = size_max_default)
      : file_(directory / (name + ".txt")), size_max_bytes_(size_max_bytes) {}

  // What prints nothing is left alone.
  void take(const channels::Event& event);

  // Why the last line was not written; empty: it was.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  std::filesystem::path file_;
  std::int64_t size_max_bytes_;
  std::string error_;
};

}  // namespace stanok::recording

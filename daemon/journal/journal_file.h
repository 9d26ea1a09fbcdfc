// JournalFile: records on disk, one behind the other, each there or not there after a power
// failure.
//
// A record is a line: the checksum of its text, a blank, the text, which is JSON. What was appended
// is on the disk when `append` returns. A line that was cut off or does not have its checksum is
// left out when the file is read; what is appended next begins on a line of its own. A file that
// has become too long is replaced at once by another one. Belongs to one thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::daemon {

class JournalFile {
 public:
  explicit JournalFile(std::filesystem::path file) : file_(std::move(file)) {}
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  struct Contents {
    std::vector<nlohmann::json> records;
    std::size_t damaged = 0;  // lines; one that was cut off at the end is none
    std::string fault;        // why it could not be read; empty: it was, or there is none
  };
  [[nodiscard]] Contents read() const;

  // Nothing, or why they are not on the disk: the same records may then be appended again.
  [[nodiscard]] std::optional<std::string> append(const std::vector<nlohmann::json>& records);
  // These instead of all that is there; the same.
  [[nodiscard]] std::optional<std::string> replace(const std::vector<nlohmann::json>& records);
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }

 private:
  [[nodiscard]] std::optional<std::string> open();
  [[nodiscard]] std::optional<std::string> fault(int error);
  void close();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::int64_t bytes_ = 0;  // of whole records
};

// The line of a record, with its end; the record of a line without it; nothing: it is damaged.
[[nodiscard]] std::string journal_line(const nlohmann::json& record);
[[nodiscard]] std::optional<nlohmann::json> journal_record(std::string_view line);

}  // namespace stanok::daemon

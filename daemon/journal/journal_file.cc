#include "daemon/journal/journal_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <utility>

#include "base/system_error.h"
#include "daemon/host/durable_file.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/json_text.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr ::mode_t journal_mode = 0640;
constexpr std::size_t checksum_digits = 16;

std::string lines_of(const std::vector<json>& records) {
  std::string lines;
  for (const json& record : records) lines += journal_line(record);
  return lines;
}

}  // namespace

std::string journal_line(const json& record) {
  const std::string text = protocol::json_text(record);
  return text_checksum(text) + " " + text + "\n";
}

std::optional<json> journal_record(std::string_view line) {
  if (line.size() <= checksum_digits || line[checksum_digits] != ' ') return std::nullopt;
  const std::string_view text = line.substr(checksum_digits + 1);
  if (line.substr(0, checksum_digits) != text_checksum(text)) return std::nullopt;
  json record = protocol::json_from_text(text);
  return record.is_object() ? std::optional(std::move(record)) : std::nullopt;
}

JournalFile::~JournalFile() {
  close();
}

void JournalFile::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

JournalFile::Contents JournalFile::read() const {
  Contents contents;
  errno = 0;
  std::ifstream stream(file_, std::ios::binary);
  if (!stream.is_open()) {
    if (errno != ENOENT) contents.fault = file_.string() + ": " + system_error_text(errno);
    return contents;
  }
  for (std::string line; std::getline(stream, line);) {
    const bool is_whole = !stream.eof();
    if (auto record = journal_record(line))
      contents.records.push_back(std::move(*record));
    else if (is_whole && !line.empty())
      ++contents.damaged;
  }
  if (stream.bad()) contents.fault = file_.string() + ": the file cannot be read to its end";
  return contents;
}

std::optional<std::string> JournalFile::fault(int error) {
  close();
  return file_.string() + ": " + system_error_text(error);
}

// What a power failure has cut off gets an end. The folder each time: it may have failed before.
std::optional<std::string> JournalFile::open() {
  if (descriptor_ >= 0) return std::nullopt;
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, journal_mode);
  if (descriptor_ < 0) return fault(errno);
  struct stat state{};
  if (::fstat(descriptor_, &state) != 0) return fault(errno);
  bytes_ = state.st_size;
  char last = '\n';
  if (bytes_ > 0 && ::pread(descriptor_, &last, 1, bytes_ - 1) != 1) return fault(errno);
  if (last != '\n') {
    if (const int error = write_bytes(descriptor_, "\n"); error != 0) return fault(error);
    ++bytes_;
  }
  if (const int error = sync_folder(file_.parent_path()); error != 0) return fault(error);
  return std::nullopt;
}

// A part that a full disk has taken is taken back, so that it stands in nobody's way.
std::optional<std::string> JournalFile::append(const std::vector<json>& records) {
  if (records.empty()) return std::nullopt;
  if (auto obstacle = open()) return obstacle;
  const std::string lines = lines_of(records);
  int error = write_bytes(descriptor_, lines);
  if (error == 0 && ::fdatasync(descriptor_) != 0) error = errno;
  if (error == 0) {
    bytes_ += static_cast<std::int64_t>(lines.size());
    return std::nullopt;
  }
  static_cast<void>(::ftruncate(descriptor_, bytes_));
  return fault(error);
}

std::optional<std::string> JournalFile::replace(const std::vector<json>& records) {
  close();
  const fs::path made = file_.string() + ".new";
  {
    JournalFile fresh(made);
    ::unlink(made.c_str());
    if (auto obstacle = fresh.append(records)) {
      ::unlink(made.c_str());
      return obstacle;
    }
  }
  if (::rename(made.c_str(), file_.c_str()) != 0) return fault(errno);
  if (const int error = sync_folder(file_.parent_path()); error != 0) return fault(error);
  return std::nullopt;
}

}  // namespace stanok::daemon

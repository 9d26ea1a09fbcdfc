#include "recording/log_writer.h"

#include <lcm/eventlog.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "base/system_error.h"

namespace stanok::recording {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;
constexpr std::int64_t event_header_bytes = 28;  // sync word, number, time, two lengths

}  // namespace

LogError log_error(const std::string& what, int error) {
  return {error, what + ": " + system_error_text(error)};
}

// One file, and the buffer that its stream writes through.
struct LogWriter::Piece {
  std::vector<char> buffer = std::vector<char>(buffer_bytes);
  std::unique_ptr<lcm_eventlog_t, decltype(&lcm_eventlog_destroy)> log{nullptr,
                                                                       &lcm_eventlog_destroy};
};

std::filesystem::path piece_name(const std::filesystem::path& file, int number) {
  if (number <= 1) return file;
  std::filesystem::path name = file.stem();
  name += "." + std::to_string(number);
  name += file.extension();
  return file.parent_path() / name;
}

Expected<std::unique_ptr<LogWriter>, LogError> LogWriter::open(const std::filesystem::path& file,
                                                               std::int64_t size_max_bytes) {
  std::unique_ptr<LogWriter> writer(new LogWriter(file, size_max_bytes));
  if (!writer->begin_piece()) return Unexpected<LogError>(*writer->status_.error);
  return writer;
}

LogWriter::LogWriter(std::filesystem::path file, std::int64_t size_max_bytes)
    : file_(std::move(file)), size_max_bytes_(size_max_bytes) {}

LogWriter::~LogWriter() {
  end_piece();
}

void LogWriter::send(const std::string& channel, std::int64_t utime,
                     std::span<const std::uint8_t> bytes) {
  if (status_.error) return;
  prologue_.take(channel, bytes);
  write(channel, utime, bytes);
  if (status_.error || size_max_bytes_ == 0 || piece_bytes_ < size_max_bytes_) return;
  begin_next_piece(utime);
}

void LogWriter::begin_next_piece(std::int64_t utime) {
  struct Here final : MessageSink {
    explicit Here(LogWriter& used) : writer(used) {}
    void send(const std::string& channel, std::int64_t at,
              std::span<const std::uint8_t> bytes) override {
      if (!writer.status_.error) writer.write(channel, at, bytes);
    }
    LogWriter& writer;
  } here(*this);
  if (!end_piece() || !begin_piece()) return;
  prologue_.send_to(here, utime);
  piece_bytes_ = 0;
}

bool LogWriter::flush() {
  if (status_.error || piece_ == nullptr) return !status_.error;
  if (std::fflush(piece_->log->f) != 0) fail("write");
  return !status_.error;
}

bool LogWriter::begin_piece() {
  const std::filesystem::path name = piece_name(file_, status_.pieces + 1);
  auto piece = std::make_unique<Piece>();
  errno = 0;
  piece->log.reset(lcm_eventlog_create(name.c_str(), "w"));
  if (piece->log == nullptr) {
    fail("create");
    return false;
  }
  std::setvbuf(piece->log->f, piece->buffer.data(), _IOFBF, piece->buffer.size());
  piece_ = std::move(piece);
  piece_bytes_ = 0;
  ++status_.pieces;
  return true;
}

bool LogWriter::end_piece() {
  const bool is_complete = flush();
  if (piece_ != nullptr) piece_->log.reset();  // before the buffer it writes through
  piece_.reset();
  return is_complete;
}

void LogWriter::write(const std::string& channel, std::int64_t utime,
                      std::span<const std::uint8_t> bytes) {
  lcm_eventlog_event_t event{};
  event.timestamp = utime;
  event.channellen = static_cast<std::int32_t>(channel.size());
  event.datalen = static_cast<std::int32_t>(bytes.size());
  event.channel = const_cast<char*>(channel.data());     // only read by the call
  event.data = const_cast<std::uint8_t*>(bytes.data());  // only read by the call
  if (lcm_eventlog_write_event(piece_->log.get(), &event) != 0) {
    fail("write");
    return;
  }
  const std::int64_t written = event_header_bytes + event.channellen + event.datalen;
  piece_bytes_ += written;
  status_.bytes += written;
  ++status_.events;
}

void LogWriter::fail(const char* what) {
  const int error = errno;
  const std::filesystem::path name = piece_name(file_, std::max(status_.pieces, 1));
  status_.error = log_error(std::string("cannot ") + what + " " + name.string(), error);
}

}  // namespace stanok::recording

#include "recording/log/log_writer.h"

#include <lcm/eventlog.h>

#include <cerrno>
#include <cstdio>
#include <stanok_messages/log_check_t.hpp>
#include <utility>

#include "base/place.h"
#include "base/system_error.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/log/log_check.h"

namespace stanok::recording {
namespace {

constexpr std::size_t buffer_bytes = 1UL << 20;
constexpr std::int64_t covered_bytes_max = std::int64_t{64} << 10;  // and the rest of a cycle

std::string check_channel_beside(const std::string& log_meta) {
  const std::size_t stem = log_meta.size() - name_of(Topic::log_meta).size();
  return log_meta.substr(0, stem) + std::string(name_of(Topic::log_check));
}

}  // namespace

LogError log_error(const std::string& what, int error) {
  return {error, what + ": " + system_error_text(error)};
}

// One file, the buffer that its stream writes through, and what its next check covers.
struct LogWriter::Piece {
  std::int64_t bytes = 0;
  std::int64_t covered_from = 0;  // first byte that no check covers
  std::uint32_t sum = 0;          // of the bytes since then
  std::int64_t checks = 0;
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
    : file_(std::move(file)),
      size_max_bytes_(size_max_bytes),
      check_channel_("STANOK_" + std::string(name_of(Topic::log_check))) {}

LogWriter::~LogWriter() {
  finish();
}

bool LogWriter::finish() {
  is_finished_ = true;
  return end_piece(LogEnd::complete);
}

void LogWriter::send(const std::string& channel, std::int64_t utime,
                     std::span<const std::uint8_t> bytes) {
  const std::string_view topic = topic_of(channel);
  if (status_.error || is_finished_ || topic == name_of(Topic::log_check)) return;
  if (topic == name_of(Topic::log_meta)) check_channel_ = check_channel_beside(channel);
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
  if (!end_piece(LogEnd::next_piece) || !begin_piece()) return;
  prologue_.send_to(here, utime);
  piece_bytes_ = 0;
}

bool LogWriter::flush() {
  if (status_.error || piece_ == nullptr) return !status_.error;
  if (piece_->bytes > piece_->covered_from) write_check(LogEnd::goes_on);
  if (status_.error) return false;
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

bool LogWriter::end_piece(LogEnd end) {
  if (piece_ == nullptr) return !status_.error;
  if (!status_.error) write_check(end);
  const bool is_complete = flush();
  piece_->log.reset();  // before the buffer it writes through
  piece_.reset();
  return is_complete;
}

void LogWriter::write(const std::string& channel, std::int64_t utime,
                      std::span<const std::uint8_t> bytes) {
  const std::int64_t cycle = cycle_of(bytes);
  const bool is_due = piece_->bytes - piece_->covered_from >= covered_bytes_max;
  if (is_due && cycle != cycle_) write_check(LogEnd::goes_on);
  if (status_.error) return;
  utime_ = utime;
  cycle_ = cycle;
  write_event(channel, utime, bytes);
  if (!status_.error && piece_->checks == 0) write_check(LogEnd::goes_on);
  ++status_.events;
}

void LogWriter::write_event(const std::string& channel, std::int64_t utime,
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
  const auto header = event_header(event.eventnum, utime, channel.size(), bytes.size());
  piece_->sum = check_sum(piece_->sum, header);
  piece_->sum = check_sum(piece_->sum,
                          {reinterpret_cast<const std::uint8_t*>(channel.data()), channel.size()});
  piece_->sum = check_sum(piece_->sum, bytes);
  const auto written = static_cast<std::int64_t>(header.size() + channel.size() + bytes.size());
  piece_->bytes += written;
  piece_bytes_ += written;
  status_.bytes += written;
}

void LogWriter::write_check(LogEnd end) {
  Piece& piece = *piece_;
  log_check_t check{};
  std::vector<std::uint8_t> bytes(checked_size(check.getEncodedSize()));
  const auto name = std::span(reinterpret_cast<const std::uint8_t*>(check_channel_.data()),
                              check_channel_.size());
  const auto header = event_header(piece.log->eventcount, utime_, name.size(), bytes.size());
  const std::size_t covered = header.size() + name.size() + bytes.size() - check_sum_bytes;
  check.utime = utime_;
  check.cycle = cycle_;
  check.seq = piece.checks++;
  check.begin = piece.covered_from;
  check.size = piece.bytes - piece.covered_from + static_cast<std::int64_t>(covered);
  check.end = static_cast<std::int8_t>(end);
  check.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  std::uint32_t sum = check_sum(check_sum(piece.sum, header), name);
  sum = check_sum(sum, std::span(bytes).first(bytes.size() - check_sum_bytes));
  check.crc = static_cast<std::int32_t>(sum);
  check.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  write_event(check_channel_, utime_, bytes);
  piece.covered_from = piece.bytes;
  piece.sum = 0;
}

void LogWriter::fail(const char* what) {
  const int error = errno;
  const std::filesystem::path name = piece_name(file_, std::max(status_.pieces, 1));
  status_.error = log_error(std::string("cannot ") + what + " " + name.string(), error);
}

}  // namespace stanok::recording

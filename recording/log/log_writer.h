// Writes a standard LCM log, readable by lcm-logplayer and lcm-spy, in pieces of bounded size.
//
// The event's time is the message's utime. Writes go through one large buffer; when the file cannot
// be written any more (disk full), the writer stops, keeps the reason in its status and ignores the
// rest: motion goes on. A new piece begins with the prologue, so that it stands alone. Check events
// (log_check.h) cover every byte: behind the first message, about every 64 kB between two cycles,
// at each flush, and the trailer at the end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/expected.h"
#include "recording/stream/message_sink.h"
#include "recording/stream/prologue.h"

namespace stanok::recording {

// How one file ends, as its last check event says.
enum class LogEnd : std::int8_t { goes_on, complete, next_piece };

struct LogError {
  int system_error = 0;  // errno
  std::string text;      // "cannot write run.lcm: No space left on device"
};

// "WHAT: reason of ERROR", as "cannot write run.lcm" with ENOSPC.
LogError log_error(const std::string& what, int error);

struct LogStatus {
  std::int64_t events = 0;  // messages; check events are not counted
  std::int64_t bytes = 0;   // over all pieces
  int pieces = 0;
  std::optional<LogError> error;  // set: nothing is written any more
};

class LogWriter : public MessageSink {
 public:
  // Pieces are FILE, then FILE with .2, .3, ... before its extension, each of `size_max_bytes` at
  // most plus its prologue and one message; 0: one piece without bound. An existing file is
  // replaced.
  [[nodiscard]] static Expected<std::unique_ptr<LogWriter>, LogError> open(
      const std::filesystem::path& file, std::int64_t size_max_bytes = 0);
  ~LogWriter() override;
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  // Checks of another file, as of a log that is copied, are left out.
  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override;

  // Hands what is buffered to the operating system, with a check. False: see status().error.
  bool flush();
  // Ends the log with its trailer, as the destructor does. What is sent behind it is ignored.
  bool finish();
  [[nodiscard]] const LogStatus& status() const { return status_; }

 private:
  struct Piece;
  LogWriter(std::filesystem::path file, std::int64_t size_max_bytes);
  bool begin_piece();
  bool end_piece(LogEnd end);
  void begin_next_piece(std::int64_t utime);
  void write(const std::string& channel, std::int64_t utime, std::span<const std::uint8_t> bytes);
  void write_event(const std::string& channel, std::int64_t utime,
                   std::span<const std::uint8_t> bytes);
  void write_check(LogEnd end);
  void fail(const char* what);

  std::filesystem::path file_;
  std::int64_t size_max_bytes_;
  std::unique_ptr<Piece> piece_;
  std::int64_t piece_bytes_ = 0;  // behind its prologue
  Prologue prologue_;
  LogStatus status_;
  std::string check_channel_;
  std::int64_t utime_ = 0;  // of the latest message, like its cycle
  std::int64_t cycle_ = 0;
  bool is_finished_ = false;
};

// The name of piece `number` of a log, from 1.
[[nodiscard]] std::filesystem::path piece_name(const std::filesystem::path& file, int number);

}  // namespace stanok::recording

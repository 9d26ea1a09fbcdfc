// HistoryWriter: events of the outbox into the history, in a thread of its own. A database that is
// away, full or slow is waited for; the outbox keeps the events meanwhile.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

namespace stanok::gateway {

class HistoryWriter {
 public:
  static constexpr const char* consumer = "history";

  HistoryWriter(std::string database, std::filesystem::path outbox, int keep_days);

  // Until it is asked to stop.
  void run(const std::stop_token& stop);

 private:
  // As long as the database does what it should.
  void serve(const std::stop_token& stop);

  std::string database_;
  std::filesystem::path outbox_file_;
  int keep_days_;
  bool has_stored_ = false;
};

}  // namespace stanok::gateway

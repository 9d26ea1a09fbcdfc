// OutputQueue: lines on their way to one client, within a bound.
//
// The line that is being written stays in front until it is gone; what is not begun yet can still
// be thrown away for a last word.
#pragma once

#include <cstddef>
#include <deque>
#include <string>

namespace stanok::daemon {

class OutputQueue {
 public:
  // Room for several long answers: texts and pages of a path.
  static constexpr std::size_t bytes_max = 2U << 20;
  // Status waits while more than this is on its way: the next one will contain it.
  static constexpr std::size_t status_bytes_max = 64U << 10;

  // False: the bound is reached; the line is not taken.
  [[nodiscard]] bool push(std::string line) {
    // One answer may be longer than the bound when nothing else waits: rpc.discover, long lists.
    if (bytes_ + line.size() > bytes_max && !lines_.empty()) return false;
    bytes_ += line.size();
    lines_.push_back(std::move(line));
    return true;
  }
  void pop_front() {
    bytes_ -= lines_.front().size();
    lines_.pop_front();
  }
  // Keeps what is being written, drops the rest and puts `line` there.
  void end_with(std::string line) {
    while (lines_.size() > 1) {
      bytes_ -= lines_.back().size();
      lines_.pop_back();
    }
    bytes_ += line.size();
    lines_.push_back(std::move(line));
  }

  [[nodiscard]] bool empty() const { return lines_.empty(); }
  [[nodiscard]] const std::string& front() const { return lines_.front(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] bool has_room_for_status() const { return bytes_ <= status_bytes_max; }

 private:
  std::deque<std::string> lines_;
  std::size_t bytes_ = 0;
};

}  // namespace stanok::daemon

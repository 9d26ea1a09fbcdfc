#include "channels/stores/block_book.h"

#include <algorithm>

namespace stanok::channels {
namespace {

// What is told later of a block holds, and of those behind it.
template <class Entry>
void enter(std::deque<Entry>& entries, Entry entry, std::size_t entries_max) {
  while (!entries.empty() && entries.back().block >= entry.block) entries.pop_back();
  if (entries.size() == entries_max) entries.pop_front();
  entries.push_back(std::move(entry));
}

// The latest entry of the block or before it, or the end.
template <class Entry>
auto latest(const std::deque<Entry>& entries, std::uint64_t block) {
  const auto behind =
      std::upper_bound(entries.begin(), entries.end(), block,
                       [](std::uint64_t at, const Entry& entry) { return at < entry.block; });
  return behind == entries.begin() ? entries.end() : behind - 1;
}

}  // namespace

void BlockBook::begin_run(std::uint32_t run) {
  const std::lock_guard lock(mutex_);
  run_ = run;
  lang::CodeChange newest = changes_.back();
  newest.block = 0;
  changes_.assign(1, newest);
  ends_.clear();
}

void BlockBook::tell_codes(const lang::CodeChange& change) {
  const std::lock_guard lock(mutex_);
  enter(changes_, change, blocks_max);
}

void BlockBook::tell_end(const motion::BlockTag& tag, const motion::Point& end_W) {
  const std::lock_guard lock(mutex_);
  enter(ends_, {tag.block, end_W}, blocks_max);
}

BlockReport BlockBook::newest() {
  const std::lock_guard lock(mutex_);
  return newest_locked();
}

BlockReport BlockBook::at(const motion::BlockTag& tag) {
  const std::lock_guard lock(mutex_);
  BlockReport report = newest_locked();
  if (tag.run != run_) return report;
  const auto change = latest(changes_, tag.block);
  report.codes = change == changes_.end() ? changes_.front().codes : change->codes;
  const auto end = latest(ends_, tag.block);
  if (end != ends_.end()) report.end_W = end->end_W;
  return report;
}

}  // namespace stanok::channels

#include "channels/stores/situation_book.h"

#include <algorithm>

namespace stanok::channels {

void SituationBook::begin_run(std::uint32_t run) {
  const std::lock_guard lock(mutex_);
  run_ = run;
  ends_.clear();
}

std::uint32_t SituationBook::enter(const lang::Meaning& meaning) {
  const std::lock_guard lock(mutex_);
  if (meanings_.size() == blocks_max) meanings_.pop_front();
  meanings_.push_back(meaning);
  return ++newest_;
}

// What is told later of a block holds, and of those behind it.
void SituationBook::tell_end(const motion::BlockTag& tag, const motion::Point& end_W) {
  const std::lock_guard lock(mutex_);
  while (!ends_.empty() && ends_.back().block >= tag.block) ends_.pop_back();
  if (ends_.size() == blocks_max) ends_.pop_front();
  ends_.push_back({tag.block, end_W});
}

SituationReport SituationBook::at(const motion::BlockTag& tag) {
  const std::lock_guard lock(mutex_);
  const std::size_t age = std::min<std::size_t>(newest_ - tag.situation, meanings_.size() - 1);
  SituationReport report{.number = tag.situation, .meaning = meanings_[meanings_.size() - 1 - age]};
  forget_behind(tag);
  if (tag.run != run_) return report;
  const auto behind =
      std::upper_bound(ends_.begin(), ends_.end(), tag.block,
                       [](std::uint64_t block, const End& end) { return block < end.block; });
  if (behind != ends_.begin()) report.end_W = (behind - 1)->end_W;
  return report;
}

void SituationBook::forget_behind(const motion::BlockTag& tag) {
  const std::size_t ahead = newest_ - tag.situation;
  while (meanings_.size() > ahead + 1 + kept_behind) meanings_.pop_front();
  if (tag.run != run_) return;
  while (ends_.size() > kept_behind && ends_[kept_behind].block <= tag.block) ends_.pop_front();
}

std::size_t SituationBook::size() {
  const std::lock_guard lock(mutex_);
  return meanings_.size() + ends_.size();
}

}  // namespace stanok::channels

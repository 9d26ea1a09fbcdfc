// ChannelHistory: the newest reports of each channel, in the order in which they came.
//
// Each gets a number, 1, 2, ... in its channel, that it keeps, also over starts of the machine.
// Where a channel has too many its oldest go, so that a channel that raises alarms without end
// takes none from the others. What went shows in the numbers (channels/contract/reports.h). Belongs
// to its owner's thread or lock.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <ranges>
#include <utility>
#include <vector>

namespace stanok::channels {

template <class Report>
class ChannelHistory {
 public:
  explicit ChannelHistory(std::size_t kept_max) : kept_max_(kept_max) {}

  // The oldest of the channel go until `count` more find room, and no more than there are.
  void make_room(int channel, std::size_t count) {
    Count& of_channel = counts_[channel];
    const std::size_t others_max = kept_max_ - std::min(count, kept_max_);
    while (of_channel.kept > others_max) {
      reports_.erase(std::ranges::find(reports_, channel, &Report::channel));
      --of_channel.kept;
    }
  }

  // Makes no room. The reference holds until the next change.
  Report& add(Report report) {
    Count& of_channel = counts_[report.channel];
    report.number = ++of_channel.given;
    ++of_channel.kept;
    reports_.push_back(std::move(report));
    return reports_.back();
  }

  // One with a number of its own, from before: numbers go on behind it. Makes no room.
  void recall(Report report) {
    go_on_behind(report.channel, report.number);
    ++counts_[report.channel].kept;
    reports_.push_back(std::move(report));
  }

  // This number was given already.
  void go_on_behind(int channel, std::uint64_t number) {
    Count& of_channel = counts_[channel];
    of_channel.given = std::max(of_channel.given, number);
  }

  // The newest for which the condition holds; nullptr: none.
  template <class Condition>
  [[nodiscard]] Report* newest(const Condition& condition) {
    auto backwards = std::views::reverse(reports_);
    const auto found = std::ranges::find_if(backwards, condition);
    return found == backwards.end() ? nullptr : &*found;
  }

  [[nodiscard]] const std::vector<Report>& all() const { return reports_; }

 private:
  struct Count {
    std::uint64_t given = 0;
    std::size_t kept = 0;
  };

  std::size_t kept_max_;
  std::vector<Report> reports_;
  std::map<int, Count> counts_;  // by channel
};

}  // namespace stanok::channels

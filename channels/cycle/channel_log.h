// ChannelLog: what a channel tells people: events, and alarms with the place in the program.
//
// Thread: the real-time cycle. Owner: the channel. What finds no place is counted where it goes.
#pragma once

#include <string_view>

#include "base/rt_safe.h"
#include "channels/axes/channel_constants.h"
#include "channels/contract/output.h"
#include "channels/cycle/channel_terms.h"
#include "channels/cycle/run_book.h"
#include "channels/messages/channel_link.h"
#include "channels/stores/event_book.h"
#include "channels/stores/report_book.h"

namespace stanok::channels {

class ChannelLog {
 public:
  // All outlive the log.
  ChannelLog(std::int32_t channel, const RunBook& runs, const ChannelLink& link, EventBook& events,
             ReportBook& reports)
      : channel_(channel), runs_(runs), link_(link), events_(events), reports_(reports) {}

  // An event, now: a message, or with a code a warning or alarm.
  void tell(std::string_view code, std::string_view text, const motion::BlockTag& tag) RT_SAFE;
  // An alarm: its first line is an event, too.
  void alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag) RT_SAFE;

  [[nodiscard]] const ChannelAlarm& last_alarm() const RT_SAFE { return last_alarm_; }
  // Of a block of this run; else empty.
  [[nodiscard]] const FileName& file_name(const motion::BlockTag& tag) const RT_SAFE;

 private:
  std::int32_t channel_;
  const RunBook& runs_;
  const ChannelLink& link_;
  EventBook& events_;
  ReportBook& reports_;
  ChannelAlarm last_alarm_;
};

}  // namespace stanok::channels

#include "channels/cycle/channel_log.h"

#include <algorithm>

namespace stanok::channels {
namespace {

constexpr FileName no_name;

std::string_view headline(std::string_view text) RT_SAFE {
  text.remove_suffix(text.size() - std::min(text.find('\n'), text.size()));
  return text;
}

}  // namespace

void ChannelLog::tell(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  Event event;
  event.cycle = runs_.cycle();
  event.channel = channel_;
  event.code = FixedText<8>(code);
  event.tag = tag;
  event.text = FixedText<240>(text);
  events_.put(event);
}

void ChannelLog::alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  AlarmRecord record;
  record.channel = channel_;
  record.cycle = runs_.cycle();
  record.tag = tag;
  record.code = FixedText<8>(code);
  record.text = FixedText<1024>(text);
  record.file = file_name(tag);
  last_alarm_ = {runs_.run(), tag.line, record.code, record.file};
  reports_.put(record);
  tell(code, headline(text), tag);
}

const FileName& ChannelLog::file_name(const motion::BlockTag& tag) const RT_SAFE {
  if (tag.run != runs_.run()) return no_name;
  return link_.file_names[std::min<std::size_t>(tag.file, link_.file_names.size() - 1)];
}

}  // namespace stanok::channels

#include "recording/read/log_contents.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stanok_messages/log_check_t.hpp>
#include <stanok_messages/log_rest_t.hpp>
#include <stanok_messages/program_chunk_t.hpp>
#include <stanok_messages/situation_t.hpp>
#include <string_view>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_input_record.h"
#include "recording/format/encode_inputs.h"
#include "recording/format/encode_tool_row.h"

namespace stanok::recording {
namespace {

// What every message of ours says, whatever its type.
struct Heading {
  Stamp stamp;
  int channel = 0;
};

template <class Message>
std::optional<Heading> heading_as(std::span<const std::uint8_t> bytes) {
  const auto message = decode<Message>(bytes);
  if (!message) return std::nullopt;
  Heading heading{.stamp = {message->utime, message->cycle, message->seq}};
  if constexpr (requires { message->channel; }) heading.channel = message->channel;
  return heading;
}

struct MessageType {
  Topic topic;
  const char* name;
  std::optional<Heading> (*heading)(std::span<const std::uint8_t>);
};

template <class Message>
MessageType type_of(Topic topic) {
  return {topic, Message::getTypeName(), &heading_as<Message>};
}

const MessageType* type_on(std::string_view channel_name) {
  static const std::array types{type_of<setpoint_t>(Topic::setpoint),
                                type_of<channel_state_t>(Topic::state),
                                type_of<drive_status_t>(Topic::drive),
                                type_of<process_status_t>(Topic::process),
                                type_of<force_status_t>(Topic::force),
                                type_of<event_t>(Topic::event),
                                type_of<input_t>(Topic::input),
                                type_of<program_chunk_t>(Topic::program),
                                type_of<workpiece_t>(Topic::workpiece),
                                type_of<tool_t>(Topic::tool),
                                type_of<tool_row_t>(Topic::tool_row),
                                type_of<situation_t>(Topic::situation),
                                type_of<arrival_t>(Topic::arrival),
                                type_of<feedback_t>(Topic::feedback),
                                type_of<log_meta_t>(Topic::log_meta),
                                type_of<log_types_t>(Topic::log_types),
                                type_of<log_check_t>(Topic::log_check),
                                type_of<log_rest_t>(Topic::log_rest),
                                type_of<program_read_t>(Topic::program_read),
                                type_of<path_t>(Topic::path)};
  const auto type = std::find_if(types.begin(), types.end(), [&](const MessageType& t) {
    return topic_of(channel_name) == name_of(t.topic);
  });
  return type == types.end() ? nullptr : &*type;
}

// Whole numbers between both, without them; none when the second is not above the first. Of numbers
// of a damaged log, which may be any.
std::uint64_t count_between(std::int64_t first, std::int64_t second) {
  if (second <= first) return 0;
  return static_cast<std::uint64_t>(second) - static_cast<std::uint64_t>(first) - 1;
}

std::int64_t total_of(std::int64_t count, std::uint64_t more) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  return more > static_cast<std::uint64_t>(most - count) ? most
                                                         : count + static_cast<std::int64_t>(more);
}

// Faults of what could be read but for its check sum; what could not be read is told already.
void add_faults(LogContents& contents) {
  const std::vector<Damage> read = contents.damage;
  for (const Damage& fault : contents.coverage.faults) {
    const bool is_told = std::ranges::any_of(read, [&](const Damage& damage) {
      return damage.offset < fault.offset + fault.bytes &&
             fault.offset < damage.offset + damage.bytes;
    });
    if (!is_told) contents.damage.push_back(fault);
  }
  std::ranges::sort(contents.damage, {}, &Damage::offset);
}

}  // namespace

// Counts events; keeps the running number that each channel must go on with.
class ContentsReading::Count {
 public:
  explicit Count(LogContents& contents) : contents_(contents) {}

  // The setpoint that it is; nullptr: it is none.
  const setpoint_t* add(const LogEvent& event) {
    setpoint_.reset();
    if (contents_.events++ == 0) contents_.utime_first = event.utime;
    contents_.utime_last = event.utime;
    auto [entry, is_new] = contents_.channels.try_emplace(std::string(event.channel));
    ChannelContents& channel = entry->second;
    if (is_new) channel.utime_first = event.utime;
    channel.utime_last = event.utime;
    ++channel.messages;
    if (event.is_in_file()) channel.bytes += static_cast<std::int64_t>(event.bytes.size());
    if (const MessageType* type = type_on(event.channel)) add_ours(event, *type, channel);
    return setpoint_ ? &*setpoint_ : nullptr;
  }

 private:
  void add_ours(const LogEvent& event, const MessageType& type, ChannelContents& channel) {
    channel.type = type.name;
    const auto heading =
        type.topic == Topic::setpoint ? heading_of_setpoint(event) : type.heading(event.bytes);
    if (!heading) {
      ++channel.undecodable;
      return;
    }
    if (type.topic == Topic::log_meta && !contents_.description) {
      contents_.description = from_log_meta(*decode<log_meta_t>(event.bytes));
    }
    if (type.topic == Topic::setpoint) {
      contents_.setpoint_channels.try_emplace(heading->channel, event.channel);
    }
    const auto [last, is_first] = last_seq_.try_emplace(&channel, heading->stamp.seq);
    if (is_first) channel.cycle_first = heading->stamp.cycle;
    // A setpoint comes every cycle: what the recorder was too late for has no number.
    const bool comes_every_cycle = type.topic == Topic::setpoint && !is_first;
    const std::uint64_t never_sent =
        comes_every_cycle ? count_between(channel.cycle_last, heading->stamp.cycle) : 0;
    const std::uint64_t lost = count_between(last->second, heading->stamp.seq);
    channel.missing = total_of(channel.missing, std::max(never_sent, lost));
    channel.cycle_last = heading->stamp.cycle;
    last->second = heading->stamp.seq;
  }

  // Most of a log are setpoints: they are decoded once.
  std::optional<Heading> heading_of_setpoint(const LogEvent& event) {
    setpoint_ = decode<setpoint_t>(event.bytes);
    if (!setpoint_) return std::nullopt;
    return Heading{{setpoint_->utime, setpoint_->cycle, setpoint_->seq}, setpoint_->channel};
  }

  LogContents& contents_;
  std::map<const ChannelContents*, std::int64_t> last_seq_;
  std::optional<setpoint_t> setpoint_;
};

ContentsReading::ContentsReading() : count_(std::make_unique<Count>(contents_)) {}

ContentsReading::~ContentsReading() = default;

const setpoint_t* ContentsReading::take(const LogEvent& event) {
  if (event.is_in_file()) checks_.take(event);
  const auto size = static_cast<std::int64_t>(event.whole.size());
  bytes_ = event.offset + size;
  const setpoint_t* setpoint = count_->add(event);
  if (setpoint != nullptr) setpoint_bytes_ += size;
  return setpoint;
}

std::int64_t ContentsReading::usable_bytes() const {
  constexpr std::int64_t first_check_within = 1 << 20;  // of setpoints, in a log that has any
  if (checks_.has_checks()) return checks_.sound_bytes();
  return setpoint_bytes_ > first_check_within ? bytes_ : 0;
}

LogContents ContentsReading::finish(const LogReader& reader) {
  contents_.bytes = reader.bytes_read();
  contents_.damage = reader.damage();
  contents_.coverage = checks_.coverage(contents_.bytes);
  add_faults(contents_);
  return std::move(contents_);
}

bool LogContents::is_cut() const {
  const bool ends_within = std::ranges::any_of(
      damage, [](const Damage& place) { return place.kind == DamageKind::cut; });
  return ends_within || (coverage.has_checks && coverage.end == LogEnd::goes_on);
}

bool LogContents::is_sound() const {
  return damage.empty() && std::all_of(channels.begin(), channels.end(), [](const auto& entry) {
           return entry.second.undecodable == 0;
         });
}

Expected<LogContents, LogError> read_contents(const std::filesystem::path& file) {
  auto reader = LogReader::open(file);
  if (!reader) return Unexpected<LogError>(reader.error());
  ContentsReading reading;
  while (const auto event = reader->next()) reading.take(*event);
  return reading.finish(*reader);
}

const ChannelDescription* description_of(const LogContents& contents, int channel) {
  if (!contents.description) return nullptr;
  const auto& channels = contents.description->channels;
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const ChannelDescription& c) { return c.id == channel; });
  return found == channels.end() ? nullptr : &*found;
}

std::vector<AxisDescription> axes_of(const LogContents& contents, int channel, int axis_count) {
  const ChannelDescription* described = description_of(contents, channel);
  std::vector<AxisDescription> axes;
  if (described != nullptr) axes = described->axes;
  const std::size_t count = checked_size(std::max(0, axis_count));
  while (axes.size() < count) {
    const std::string name = "A" + std::to_string(axes.size() + 1);
    axes.push_back({name, name, false});
  }
  axes.resize(count);
  return axes;
}

}  // namespace stanok::recording

#include "recording/read/event_walk.h"

#include <algorithm>

#include "base/place.h"
#include "channels/contract/texts.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode.h"

namespace stanok::recording {

Expected<EventWalk, LogError> EventWalk::open(const std::filesystem::path& file) {
  auto reader = LogReader::open(file);
  if (!reader) return Unexpected<LogError>(reader.error());
  return EventWalk(std::move(*reader));
}

std::optional<NamedEvent> EventWalk::next() {
  const auto must_read = [&] {
    return waiting_.empty() || (waiting_.size() <= waiting_max && waits_for_name(waiting_.front()));
  };
  while (must_read() && read_message()) {
  }
  if (waiting_.empty()) return std::nullopt;
  NamedEvent event{.event = waiting_.front(), .file = file_of(waiting_.front())};
  waiting_.pop_front();
  return event;
}

bool EventWalk::read_message() {
  const auto message = reader_.next();
  if (!message) return false;
  const std::string_view topic = topic_of(message->channel);
  if (topic == name_of(Topic::event)) {
    if (const auto event = decode<event_t>(message->bytes)) waiting_.push_back(*event);
  } else if (topic == name_of(Topic::state)) {
    if (const auto state = decode<channel_state_t>(message->bytes)) take(*state);
  } else if (topic == name_of(Topic::program_read)) {
    if (const auto read = decode<program_read_t>(message->bytes)) take(*read);
  }
  return true;
}

// An operator asks for a program; a program asks for a file of its own, each of which has one
// number however often it is asked for.
void EventWalk::take(const program_read_t& read) {
  if (read.found == 0) return;
  const std::string name(text_of(read.name));
  const std::string from(text_of(read.from));
  const std::string path(text_of(read.path));
  if (from.empty()) {
    std::erase_if(programs_, [&](const auto& known) { return known->names.front() == name; });
    programs_.push_back(std::make_shared<Files>(Files{.names = {name}, .paths = {path}}));
    return;
  }
  const auto asking = std::find_if(programs_.rbegin(), programs_.rend(), [&](const auto& program) {
    return std::ranges::count(program->paths, from) > 0;
  });
  if (asking == programs_.rend() || std::ranges::count((*asking)->paths, path) > 0) return;
  (*asking)->names.push_back(name);
  (*asking)->paths.push_back(path);
}

void EventWalk::take(const channel_state_t& state) {
  if (state.run == 0) return;
  latest_run_[state.channel] = state.run;
  const std::string program(text_of(state.program));
  if (program.empty() || files_.contains({state.channel, state.run})) return;
  files_[{state.channel, state.run}] = files_of_program(program);
}

std::shared_ptr<const EventWalk::Files> EventWalk::files_of_program(const std::string& name) const {
  const auto found = std::find_if(programs_.rbegin(), programs_.rend(), [&](const auto& program) {
    return channels::FileName(program->names.front()).view() == name;  // cut as in a state
  });
  return found == programs_.rend() ? nullptr : *found;
}

bool EventWalk::waits_for_name(const event_t& event) const {
  if (event.line == 0 || event.run == 0) return false;
  if (files_.contains({event.channel, event.run})) return false;
  const auto latest = latest_run_.find(event.channel);
  return latest == latest_run_.end() || latest->second <= event.run;
}

std::string EventWalk::file_of(const event_t& event) const {
  if (event.line == 0) return "";
  const auto files = files_.find({event.channel, event.run});
  if (files == files_.end() || files->second == nullptr || event.file < 0) return "";
  const auto number = checked_size(event.file);
  return number < files->second->names.size() ? files->second->names[number] : "";
}

}  // namespace stanok::recording

#include "daemon/desk/program_queue.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "daemon/host/durable_file.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

constexpr DurableKind queue_kind{.name = "queue", .version = 2};
// Ids that one daemon may give without a word to the disk, and when there are more of them again.
constexpr std::uint64_t ids_reserved = 100;
constexpr std::uint64_t ids_left_min = 50;

CommandResult refused(std::string why, int channel) {
  return Unexpected<Failure>(Failure{FailureKind::refused, "E9022", std::move(why), channel, {}});
}

std::string text_of(const Failure& failure) {
  return failure.code.empty() ? failure.message : failure.code + " " + failure.message;
}

// What ends a queue, in words; empty: nothing of that kind.
std::string_view end_by(OperatorAction action) {
  switch (action) {
    case OperatorAction::machine_estop:
      return "STOP ALL";
    case OperatorAction::machine_off:
      return "the machine was switched off";
    case OperatorAction::program_stop:
      return "a program was stopped";
    case OperatorAction::program_reset:
      return "reset";
    case OperatorAction::program_load:
    case OperatorAction::program_search:
      return "another program was loaded";
    case OperatorAction::mdi:
      return "an MDI line was executed";
    default:
      return {};
  }
}

auto entry_with(auto& entries, std::uint64_t id) {
  return std::find_if(entries.begin(), entries.end(),
                      [&](const auto& entry) { return entry.id == id; });
}

}  // namespace

ProgramQueue::ProgramQueue(RunningMachine& machine, CommandDesk& desk,
                           const ChannelControl& control, NotesOfChannels& notes,
                           std::filesystem::path file)
    : machine_(machine), desk_(desk), control_(control), notes_(notes), file_(std::move(file)) {
  for (const auto& channel : machine_.file().machine.channels) lines_[channel.id];
  read();
  last_id_ = reserved_id_;
  reserve_ids();
  if (const auto fault = write_durably(file_, queue_kind, text()))
    spdlog::warn("the queues of programs cannot be saved: {}", *fault);
  for (const auto& [id, line] : lines_) changed(id);
}

void ProgramQueue::read() {
  const auto kept = read_durably(file_, queue_kind);
  if (!kept) spdlog::warn("the queues of programs are empty: {}", kept.error());
  if (!kept || !*kept) return;
  if (!(*kept)->warning.empty()) spdlog::warn("{}", (*kept)->warning);
  (*kept)->version == 1 ? take_over_version_1((*kept)->text) : take_over((*kept)->text);
}

// First the id up to which all may have been given. Then a line for each program: the channel, its
// id, its name, between blanks.
void ProgramQueue::take_over(const std::string& text) {
  std::istringstream lines(text);
  lines >> reserved_id_;
  int channel = 0;
  Entry entry;
  while (lines >> channel >> entry.id && std::getline(lines >> std::ws, entry.program))
    append(channel, entry);
}

// The channel and the name.
void ProgramQueue::take_over_version_1(const std::string& text) {
  std::istringstream lines(text);
  int channel = 0;
  Entry entry;
  while (lines >> channel && std::getline(lines >> std::ws, entry.program)) {
    entry.id = ++reserved_id_;
    append(channel, entry);
  }
}

void ProgramQueue::append(int channel, Entry entry) {
  const auto line = lines_.find(channel);
  if (line == lines_.end()) return;
  reserved_id_ = std::max(reserved_id_, entry.id);
  line->second.entries.push_back(std::move(entry));
}

// Well before they are given, so that the previous copy of the file has them, too.
void ProgramQueue::reserve_ids() {
  if (last_id_ + ids_left_min > reserved_id_) reserved_id_ = last_id_ + ids_reserved;
}

std::string ProgramQueue::text() const {
  std::string text = std::to_string(reserved_id_) + "\n";
  for (const auto& [channel, line] : lines_)
    for (const Entry& entry : line.entries)
      text += std::to_string(channel) + " " + std::to_string(entry.id) + " " + entry.program + "\n";
  return text;
}

json ProgramQueue::shown(int channel, const Line& line) const {
  json programs = json::array();
  for (const Entry& entry : line.entries)
    programs.push_back({{"id", entry.id}, {"program", entry.program}});
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? json(nullptr) : json(text);
  };
  return {{"channel", channel},
          {"started", line.is_started},
          {"started_by", line.is_started ? text_or_null(line.starter.peer) : json(nullptr)},
          {"stopped_by", text_or_null(line.stopped_by)},
          {"under_way", line.under_way == 0 ? json(nullptr) : json(line.under_way)},
          {"programs", std::move(programs)}};
}

json ProgramQueue::list(int channel) const {
  json queues = json::array();
  for (const auto& [id, line] : lines_)
    if (channel == 0 || channel == id) queues.push_back(shown(id, line));
  return {{"queues", std::move(queues)}};
}

void ProgramQueue::changed(int channel) {
  Line& line = lines_[channel];
  notes_[channel].queue = {line.entries.size(), line.is_started, ++line.version};
}

// A queue that is started has something to begin.
void ProgramQueue::end_if_empty(Line& line) {
  if (line.entries.empty()) line.is_started = false;
}

void ProgramQueue::add(const json& parameters, int channel, Answer answer) {
  Line& line = lines_[channel];
  auto program = parameters["program"].get<std::string>();
  if (program.find_first_of("\r\n") != std::string::npos)
    return answer(refused("a program cannot have this name", channel));
  if (line.entries.size() >= programs_max) return answer(refused("the queue is full", channel));
  line.entries.push_back({++last_id_, std::move(program)});
  keep({channel, last_id_, std::move(answer)});
}

void ProgramQueue::remove(const json& parameters, int channel, Answer answer) {
  Line& line = lines_[channel];
  const auto entry = entry_with(line.entries, parameters["id"].get<std::uint64_t>());
  if (entry == line.entries.end()) return answer(refused("the queue has no such entry", channel));
  if (entry->id == line.under_way) return answer(refused("this program is running", channel));
  line.entries.erase(entry);
  end_if_empty(line);
  keep({channel, 0, std::move(answer)});
}

// What is under way stays the first one.
void ProgramQueue::move(const json& parameters, int channel, Answer answer) {
  Line& line = lines_[channel];
  const auto entry = entry_with(line.entries, parameters["id"].get<std::uint64_t>());
  if (entry == line.entries.end()) return answer(refused("the queue has no such entry", channel));
  const std::size_t place = parameters["place"].get<std::size_t>();
  if (line.under_way != 0 && (entry->id == line.under_way || place == 1))
    return answer(refused("the first program is running", channel));
  Entry moved = std::move(*entry);
  line.entries.erase(entry);
  const std::size_t before = std::min(place - 1, line.entries.size());
  line.entries.insert(line.entries.begin() + static_cast<std::ptrdiff_t>(before), std::move(moved));
  keep({channel, 0, std::move(answer)});
}

CommandResult ProgramQueue::start(int channel, Starter starter) {
  Line& line = lines_[channel];
  if (line.entries.empty()) return refused("the queue is empty", channel);
  if (const auto failure = control_.obstacle(OperatorAction::program_run, channel, starter.session))
    return Unexpected<Failure>(*failure);
  Line tried = line;
  tried.starter = std::move(starter);
  const std::string why = obstacle(channel, tried);
  if (!why.empty()) return refused(why, channel);
  line.starter = std::move(tried.starter);
  line.is_started = true;
  line.stopped_by.clear();
  changed(channel);
  return list(channel);
}

CommandResult ProgramQueue::stop(int channel, const std::string& peer) {
  halt(channel, peer);
  return list(channel);
}

void ProgramQueue::halt(int channel, const std::string& why) {
  Line& line = lines_[channel];
  if (!line.is_started) return;
  line.is_started = false;
  line.stopped_by = why;
  spdlog::info("the queue of channel {} has stopped: {}", channel, why);
  changed(channel);
}

void ProgramQueue::note(const channels::OperatorEvent& accepted) {
  for (const auto& [channel, line] : lines_)
    if (accepted.channel == 0 || accepted.channel == channel) note(channel, accepted);
}

void ProgramQueue::note(int channel, const channels::OperatorEvent& accepted) {
  Line& line = lines_[channel];
  const OperatorAction action = accepted.action();
  if (const auto end = end_by(action); !end.empty()) return halt(channel, std::string(end));
  if (action == OperatorAction::program_run) {
    const bool is_own = line.under_way != 0 && !std::exchange(line.is_accepted, true);
    if (!is_own) halt(channel, "another program was started");
  }
  // Who lets a held program go on knows of the hold.
  const bool goes_on =
      action == OperatorAction::program_start || action == OperatorAction::program_resume;
  if (goes_on && line.under_way != 0 && line.is_accepted)
    line.starter.asked_at.stops_before =
        std::max(line.starter.asked_at.stops_before, accepted.stops_before);
  else if (action == OperatorAction::program_start)
    halt(channel, "another program was started");
}

void ProgramQueue::tick() {
  files_.tick();
  for (auto& [channel, line] : lines_) {
    if (!line.is_started) continue;
    if (const std::string why = obstacle(channel, line); !why.empty())
      halt(channel, why);
    else if (line.under_way == 0)
      begin_next(channel, line);
  }
  if (is_to_be_written_ && !is_being_written_) write();
}

// Why nothing may begin.
std::string ProgramQueue::obstacle(int channel, const Line& line) {
  const int holder = control_.session_with(channel);
  if (holder != 0 && holder != line.starter.session)
    return control_.holder(channel) + " has taken control of the channel";
  const channels::CycleOutput output = machine_.newest_output();
  for (const channels::ChannelOutput& one : output.of_channels()) {
    if (one.state == channels::ChannelState::alarm)
      return "channel " + std::to_string(one.id) + " has an alarm";
    if (one.id == channel && one.running && line.under_way == 0)
      return "a program that is not in the queue is running";
  }
  return {};
}

// Behind any stop that was taken since an operator let the queue or its program go on, the cycle
// refuses it.
void ProgramQueue::begin_next(int channel, Line& line) {
  const Entry& first = line.entries.front();
  channels::OperatorEvent event;
  event.command = channels::commands::ProgramRun{
      .program = channels::ShortText(std::string_view(first.program))};
  event.channel = channel;
  event.stops_before = line.starter.asked_at.stops_before;
  event.seen_cycle = std::exchange(line.starter.asked_at.cycle, -1);
  line.under_way = first.id;
  line.is_accepted = false;
  spdlog::info("the queue of channel {}, started by {}, begins {}", channel, line.starter.peer,
               first.program);
  changed(channel);
  desk_.submit(event, WaitFor::end_of_run,
               [this, channel](const CommandResult& outcome) { ended(channel, outcome); });
}

void ProgramQueue::ended(int channel, const CommandResult& outcome) {
  Line& line = lines_[channel];
  const std::uint64_t id = std::exchange(line.under_way, 0);
  if (!outcome) {
    halt(channel, text_of(outcome.error()));
    return changed(channel);
  }
  std::erase_if(line.entries, [&](const Entry& entry) { return entry.id == id; });
  end_if_empty(line);
  keep({channel, 0, nullptr});
}

void ProgramQueue::keep(Change change) {
  changed(change.channel);
  is_to_be_written_ = true;
  if (change.answer) waiting_.push_back(std::move(change));
}

// Who is told that a program was not added adds it again.
void ProgramQueue::withdraw(const Change& change) {
  Line& line = lines_[change.channel];
  const auto entry = entry_with(line.entries, change.added);
  if (entry == line.entries.end() || entry->id == line.under_way) return;
  line.entries.erase(entry);
  end_if_empty(line);
  changed(change.channel);
}

void ProgramQueue::write() {
  is_to_be_written_ = false;
  is_being_written_ = true;
  reserve_ids();
  files_.submit(
      0,
      [file = file_, text = text()](const std::stop_token&) -> CommandResult {
        if (const auto fault = write_durably(file, queue_kind, text))
          return Unexpected<Failure>(Failure{FailureKind::refused, "E9023", *fault, 0, {}});
        return json();
      },
      [this, waiting = std::exchange(waiting_, {})](const CommandResult& outcome) {
        is_being_written_ = false;
        if (!outcome) spdlog::warn("{}", text_of(outcome.error()));
        for (const Change& change : waiting) {
          if (!outcome) withdraw(change);
          change.answer(outcome ? CommandResult(list(change.channel)) : outcome);
        }
      });
}

}  // namespace stanok::daemon

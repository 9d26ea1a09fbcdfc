#include "runtime/run_stream.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <stanok_messages/program_chunk_t.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/place.h"
#include "config/files/tables_file.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "recording/format/encode_input_record.h"

namespace stanok::runtime {
namespace {

using recording::decode;
using recording::name_of;
using recording::text_of;
using recording::Topic;

constexpr std::int64_t first_cycle_of_a_machine = 1;
constexpr std::size_t setpoints_of_part = 256;
constexpr std::size_t parts_max = 128;  // 30 MB
constexpr auto look_again = std::chrono::milliseconds(1);

// Texts that come in pieces.
class Texts {
 public:
  struct Whole {
    BeginningText text;
    std::uint64_t hash = 0;
  };

  // The text that is whole with this piece.
  [[nodiscard]] std::optional<Whole> add(const program_chunk_t& chunk) {
    const std::string name(text_of(chunk.name));
    std::string& text = parts_[name];
    if (chunk.offset == 0) text.clear();
    if (static_cast<std::int64_t>(text.size()) != chunk.offset) return std::nullopt;  // one lacks
    const auto length = std::clamp<std::int64_t>(chunk.length, 0, sizeof chunk.text);
    text.append(reinterpret_cast<const char*>(chunk.text), checked_size(length));
    if (static_cast<std::int64_t>(text.size()) < chunk.size) return std::nullopt;
    const auto hash = static_cast<std::uint64_t>(chunk.hash);
    if (recording::text_hash(text) != hash) return std::nullopt;
    Whole whole{{static_cast<recording::TextKind>(chunk.kind), name, std::move(text)}, hash};
    parts_.erase(name);
    return whole;
  }

 private:
  std::map<std::string, std::string> parts_;
};

std::string why_it_is_no_run(const recording::LogContents& contents) {
  if (!contents.coverage.faults.empty()) {
    return "the log is damaged at byte " + std::to_string(contents.coverage.faults.front().offset) +
           ", in the part with the machine and the setup of its run; no part of it can be replayed";
  }
  if (contents.is_cut())
    return "the log is cut before the machine and the setup of its run are complete; no part of it "
           "can be replayed";
  return "the log does not begin with the machine and the setup of its run; it is a later part of "
         "a recording, or of another version";
}

RunBeginning beginning_of(std::vector<config::SourceFile> sources, const std::string& tables,
                          RunSetup setup) {
  RunBeginning beginning{config::read_machine_sources(std::move(sources)), std::move(setup)};
  channels::MachineConfig& machine = beginning.machine.machine;
  machine.tables =
      config::read_tables_text(tables, "tables at start", config::names_of_axes(machine));
  machine.unnamed_tools = beginning.setup.unnamed_tools;
  for (channels::AxisConfig& axis : machine.axes) {
    const auto start = beginning.setup.starts.find(axis.name);
    if (start != beginning.setup.starts.end()) axis.start = start->second;
  }
  return beginning;
}

template <class Record>
void move_behind(std::vector<Record>& front, std::vector<Record>& back) {
  std::ranges::move(back, std::back_inserter(front));
  back.clear();
}

recording::LogReader opened(const std::filesystem::path& log) {
  auto reader = recording::LogReader::open(log);
  if (!reader) throw std::runtime_error(reader.error().text);
  return std::move(*reader);
}

// What was read and belongs to no part yet.
class Reading {
 public:
  explicit Reading(RecordedFiles& files) : files_(files) {}

  void take(const recording::LogEvent& event) {
    const setpoint_t* setpoint = contents_.take(event);
    if (contents_.is_damaged()) return;
    setpoint != nullptr ? unchecked_.setpoints.push_back(*setpoint) : take_other(event);
    const std::int64_t end = event.offset + static_cast<std::int64_t>(event.whole.size());
    if (contents_.usable_bytes() < end) return;
    believe();
    part_.bytes_read = end;
    part_.is_checked = contents_.has_checks();
  }

  [[nodiscard]] bool has_part() const { return part_.setpoints.size() >= setpoints_of_part; }
  [[nodiscard]] LogPart take_part() { return std::exchange(part_, {}); }
  [[nodiscard]] recording::LogContents finish(const recording::LogReader& reader) {
    recording::LogContents contents = contents_.finish(reader);
    if (!contents.coverage.has_checks) believe();
    return contents;
  }

 private:
  void take_other(const recording::LogEvent& event) {
    const std::string_view topic = recording::topic_of(event.channel);
    if (topic == name_of(Topic::input)) {
      if (const auto message = decode<input_t>(event.bytes))
        unchecked_.inputs.push_back(recording::from_input(*message));
    } else if (topic == name_of(Topic::arrival)) {
      if (const auto message = decode<arrival_t>(event.bytes))
        unchecked_.arrivals.push_back(
            {message->cycle, message->channel, recording::from_arrival(*message)});
    } else if (topic == name_of(Topic::feedback)) {
      if (const auto message = decode<feedback_t>(event.bytes))
        unchecked_.feedback.push_back(
            {message->cycle, message->channel, message->axis, recording::from_feedback(*message)});
    } else if (topic == name_of(Topic::program)) {
      if (const auto message = decode<program_chunk_t>(event.bytes)) chunks_.push_back(*message);
    } else if (topic == name_of(Topic::program_read)) {
      if (const auto message = decode<program_read_t>(event.bytes)) reads_.push_back(*message);
    }
  }

  // What was read is as it was written.
  void believe() {
    for (const program_chunk_t& chunk : chunks_) {
      auto whole = texts_.add(chunk);
      if (!whole) continue;
      if (whole->text.kind == recording::TextKind::program) {
        files_.add_text(whole->hash, std::move(whole->text.text));
      } else {
        part_.texts.push_back(std::move(whole->text));
      }
    }
    for (const program_read_t& read : reads_) files_.add(read);
    chunks_.clear();
    reads_.clear();
    move_behind(part_.inputs, unchecked_.inputs);
    move_behind(part_.feedback, unchecked_.feedback);
    move_behind(part_.arrivals, unchecked_.arrivals);
    move_behind(part_.setpoints, unchecked_.setpoints);
  }

  RecordedFiles& files_;
  recording::ContentsReading contents_;
  Texts texts_;
  LogPart unchecked_;
  std::vector<program_chunk_t> chunks_;
  std::vector<program_read_t> reads_;
  LogPart part_;
};

}  // namespace

RunStream::RunStream(const std::filesystem::path& log)
    : reader_(opened(log)),
      files_(std::make_shared<RecordedFiles>()),
      thread_([this](const std::stop_token& stop) {
        try {
          read(stop);
        } catch (...) {
          end(std::current_exception());
        }
      }) {}

RunStream::~RunStream() {
  thread_.request_stop();
  changed_.notify_all();
}

void RunStream::read(const std::stop_token& stop) {
  Reading reading(*files_);
  while (const auto event = reader_.next()) {
    reading.take(*event);
    if (reading.has_part()) put(reading.take_part(), stop);
    if (stop.stop_requested()) break;
  }
  contents_ = reading.finish(reader_);
  put(reading.take_part(), stop);
  end(nullptr);
}

void RunStream::put(LogPart part, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (is_wanted_ && parts_.size() >= parts_max && !files_->is_awaited() &&
         !stop.stop_requested())
    changed_.wait_for(lock, look_again);
  if (!is_wanted_) return;
  parts_.push_back(std::move(part));
  changed_.notify_all();
}

void RunStream::end(std::exception_ptr fault) {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    fault_ = std::move(fault);
  }
  files_->finish();
  changed_.notify_all();
}

// It stands in the first part: no setpoint comes before it.
RunBeginning RunStream::beginning() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !parts_.empty() || is_over_; });
  if (fault_) std::rethrow_exception(fault_);
  std::vector<config::SourceFile> sources;
  std::string tables;
  std::optional<RunSetup> setup;
  for (BeginningText& text : parts_.front().texts) {
    if (text.kind == recording::TextKind::tables) {
      tables = std::move(text.text);
    } else if (text.kind == recording::TextKind::initial_state) {
      setup = setup_of(text.text);
    } else {
      sources.push_back({text.name, std::move(text.text)});
    }
  }
  if (sources.empty() || !setup) {
    is_wanted_ = false;
    changed_.notify_all();
    changed_.wait(lock, [&] { return is_over_; });
    throw std::runtime_error(why_it_is_no_run(contents_));
  }
  const std::vector<setpoint_t>& setpoints = parts_.front().setpoints;
  if (!setpoints.empty() && setpoints.front().cycle > first_cycle_of_a_machine) {
    throw std::runtime_error("the log begins at cycle " + std::to_string(setpoints.front().cycle) +
                             " of its machine; only a recording from the first cycle on can be "
                             "replayed; this one can be shown, plotted and exported");
  }
  lock.unlock();
  return beginning_of(std::move(sources), tables, std::move(*setup));
}

std::optional<LogPart> RunStream::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !parts_.empty() || is_over_; });
  if (parts_.empty()) {
    if (fault_) std::rethrow_exception(fault_);
    return std::nullopt;
  }
  LogPart part = std::move(parts_.front());
  parts_.pop_front();
  changed_.notify_all();
  return part;
}

recording::LogContents RunStream::contents() {
  std::unique_lock lock(mutex_);
  is_wanted_ = false;
  parts_.clear();
  changed_.notify_all();
  changed_.wait(lock, [&] { return is_over_; });
  if (fault_) std::rethrow_exception(fault_);
  return std::move(contents_);
}

}  // namespace stanok::runtime

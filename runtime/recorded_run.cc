#include "runtime/recorded_run.h"

#include <algorithm>
#include <stanok_messages/program_chunk_t.hpp>
#include <stdexcept>

#include "base/place.h"
#include "base/utf8.h"
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

// Texts that come in pieces.
constexpr std::int64_t first_cycle_of_a_machine = 1;

class Texts {
 public:
  struct Whole {
    recording::TextKind kind;
    std::string name;
    std::uint64_t hash;
    std::string text;
  };

  void add(const program_chunk_t& chunk) {
    const std::string name(text_of(chunk.name));
    std::string& text = parts_[name];
    if (chunk.offset == 0) text.clear();
    if (static_cast<std::int64_t>(text.size()) != chunk.offset) return;  // a piece is missing
    const auto length = std::clamp<std::int64_t>(chunk.length, 0, sizeof chunk.text);
    text.append(reinterpret_cast<const char*>(chunk.text), checked_size(length));
    if (static_cast<std::int64_t>(text.size()) < chunk.size) return;
    const auto hash = static_cast<std::uint64_t>(chunk.hash);
    if (recording::text_hash(text) != hash) return;
    whole_.push_back({static_cast<recording::TextKind>(chunk.kind), name, hash, std::move(text)});
    parts_.erase(name);
  }
  [[nodiscard]] std::vector<Whole>& whole() { return whole_; }

 private:
  std::map<std::string, std::string> parts_;
  std::vector<Whole> whole_;
};

template <class Record>
void sort_by_cycle(std::vector<Record>& records) {
  std::ranges::stable_sort(records, {}, &Record::cycle);
}

void take(const channels::InputRecord& input, RecordedRun& run) {
  if (!std::holds_alternative<channels::LostInputs>(input.content)) {
    run.inputs.push_back(input);
  } else {
    run.lost_cycle = std::min(run.lost_cycle.value_or(input.cycle), input.cycle);
  }
}

void take(const recording::LogEvent& event, Texts& texts, RecordedRun& run) {
  const std::string_view topic = recording::topic_of(event.channel);
  if (topic == name_of(Topic::input)) {
    if (const auto message = decode<input_t>(event.bytes))
      take(recording::from_input(*message), run);
  } else if (topic == name_of(Topic::arrival)) {
    if (const auto message = decode<arrival_t>(event.bytes))
      run.arrivals.push_back({message->cycle, message->channel, recording::from_arrival(*message)});
  } else if (topic == name_of(Topic::feedback)) {
    if (const auto message = decode<feedback_t>(event.bytes)) {
      run.feedback.push_back(
          {message->cycle, message->channel, message->axis, recording::from_feedback(*message)});
    }
  } else if (topic == name_of(Topic::setpoint) && !run.first_cycle) {
    if (const auto message = decode<setpoint_t>(event.bytes)) run.first_cycle = message->cycle;
  } else if (topic == name_of(Topic::program)) {
    if (const auto message = decode<program_chunk_t>(event.bytes)) texts.add(*message);
  } else if (topic == name_of(Topic::program_read)) {
    if (const auto message = decode<program_read_t>(event.bytes)) run.files.add(*message);
  }
}

std::string why_it_is_no_run(const recording::LogContents& contents) {
  if (!contents.coverage.faults.empty()) {
    return "the log is damaged at byte " + std::to_string(contents.coverage.faults.front().offset) +
           ", where the machine and the setup of its run stand; nothing of it can be repeated";
  }
  if (contents.is_cut())
    return "the log is cut before the machine and the setup of its run are complete; nothing of it "
           "can be repeated";
  return "the log does not begin with the machine and the setup of its run; it is a later part of "
         "a recording, or of another version";
}

void take_texts(Texts& texts, RecordedRun& run) {
  std::vector<config::SourceFile> sources;
  std::string tables;
  bool has_setup = false;
  for (Texts::Whole& whole : texts.whole()) {
    switch (whole.kind) {
      case recording::TextKind::program:
        run.files.add_text(whole.hash, std::move(whole.text));
        break;
      case recording::TextKind::tables:
        tables = std::move(whole.text);
        break;
      case recording::TextKind::machine_file:
      case recording::TextKind::scheme:
        sources.push_back({whole.name, std::move(whole.text)});
        break;
      case recording::TextKind::initial_state:
        run.setup = setup_of(whole.text);
        has_setup = true;
        break;
    }
  }
  if (sources.empty() || !has_setup) throw std::runtime_error(why_it_is_no_run(run.contents));
  run.machine = config::read_machine_sources(std::move(sources));
  channels::MachineConfig& machine = run.machine.machine;
  machine.tables =
      config::read_tables_text(tables, "tables at start", config::names_of_axes(machine));
  machine.unnamed_tools = run.setup.unnamed_tools;
  for (channels::AxisConfig& axis : machine.axes) {
    const auto start = run.setup.starts.find(axis.name);
    if (start != run.setup.starts.end()) axis.start = start->second;
  }
}

}  // namespace

void RecordedFiles::add(const program_read_t& read) {
  answers_[{std::string(text_of(read.name)), std::string(text_of(read.from))}].push_back(
      {read.found != 0, static_cast<std::uint64_t>(read.hash), std::string(text_of(read.path))});
}

Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> RecordedFiles::read(
    std::string_view name, std::string_view from) const {
  const auto answers = answers_.find({valid_utf8(name), valid_utf8(from)});  // as a log has them
  const bool is_known = answers != answers_.end() && !answers->second.empty();
  const Answer answer = is_known ? answers->second.front() : Answer{};
  if (is_known) answers->second.pop_front();
  const auto text = texts_.find(answer.hash);
  if (!answer.found || text == texts_.end()) {
    Diagnostic fault;
    fault.code = "E7001";
    fault.message = "the file was not found: " + std::string(name);
    return Unexpected<Diagnostic>(std::move(fault));
  }
  auto source = std::make_shared<lang::SourceText>();
  source->name = std::string(name);
  source->path = answer.path;
  source->text = text->second;
  return std::shared_ptr<const lang::SourceText>(std::move(source));
}

std::int64_t usable_bytes(const recording::LogContents& contents) {
  return contents.coverage.has_checks ? contents.coverage.sound_bytes : contents.bytes;
}

std::unique_ptr<RecordedRun> read_run(const std::filesystem::path& log) {
  auto contents = recording::read_contents(log);
  if (!contents) throw std::runtime_error(contents.error().text);
  auto reader = recording::LogReader::open(log);
  if (!reader) throw std::runtime_error(reader.error().text);
  auto run = std::make_unique<RecordedRun>();
  run->contents = std::move(*contents);
  Texts texts;
  const std::int64_t end = usable_bytes(run->contents);
  for (auto event = reader->next(); event && event->offset < end; event = reader->next())
    take(*event, texts, *run);
  take_texts(texts, *run);
  if (run->first_cycle.value_or(0) > first_cycle_of_a_machine) {
    throw std::runtime_error("the log begins at cycle " + std::to_string(*run->first_cycle) +
                             " of its machine; only a recording from the first cycle on can be "
                             "repeated, this one can be shown, plotted and exported");
  }
  sort_by_cycle(run->inputs);
  sort_by_cycle(run->feedback);
  sort_by_cycle(run->arrivals);
  return run;
}

}  // namespace stanok::runtime

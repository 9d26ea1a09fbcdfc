// The stream of messages of one machine: what is sent when, numbered and stamped, to all sinks.
//
// LOG_META and LOG_TYPES come first and every 60 s of machine time; SETPOINT every cycle for every
// channel with axes; STATE of every channel 20 times a second; WORKPIECE when a program announces
// one, TOOL when another one is put to work, TOOL_ROW then and when a value of it is written, PATH
// when a preview is given, all every 60 s from then on; SITUATION when another one is in effect and
// every second; events, inputs and texts as they come. Time
// stamps are cycle x cycle time, so that equal runs give equal bytes. For one thread (publisher or
// `simulate`), never for the real-time cycle.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "channels/contract/input_change.h"
#include "channels/contract/output.h"
#include "channels/contract/reports.h"
#include "channels/machine/machine.h"
#include "recording/format/encode_inputs.h"
#include "recording/format/log_description.h"
#include "recording/format/path_preview.h"
#include "recording/stream/message_sender.h"
#include "recording/stream/message_sink.h"

namespace stanok::recording {

enum class TextKind : std::int8_t { program, machine_file, scheme, tables, initial_state };

// A text that the outcome depends on.
struct TextRecord {
  std::int64_t cycle = 0;
  std::int32_t channel = 0;  // 0: the machine
  std::uint32_t run = 0;     // program run that reads it
  std::uint16_t file = 0;    // index by which setpoints name it
  TextKind kind = TextKind::program;
  std::string_view name;
  std::string_view text;
};

class MessageStream {
 public:
  // The situation whose number an output shows.
  using Situations = std::function<channels::SituationReport(const channels::ChannelOutput&)>;

  // The sinks outlive the stream.
  MessageStream(LogDescription description, std::vector<MessageSink*> sinks);

  void cycle(const channels::CycleOutput& output);
  void event(const channels::Event& event);
  void input(const channels::InputRecord& record);
  void input(const channels::InputChange& change);
  void text(const TextRecord& record);
  // The text itself is sent when it is new.
  void program_read(const ProgramRead& read, std::int64_t cycle);

  // Sent in parts from now on, then every 60 s, until there is another one of its channel.
  void path(PathPreview preview);

  // Whom to ask for situations; none are sent before. Lives as long as outputs come.
  void ask_for_situations(Situations situations) { situations_ = std::move(situations); }

  // Whether announcements of workpieces are sent; what was announced comes as soon as they are.
  void allow_workpieces(bool allowed);

  [[nodiscard]] const LogDescription& description() const { return description_; }

 private:
  void send_meta_when_due(std::int64_t cycle);
  void state_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void drives_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void process_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void force_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void tool_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void tool_row_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void situation_when_due(std::int64_t cycle, const channels::ChannelOutput& output);
  void path_when_due(std::int64_t cycle, int channel);
  void workpiece_when_due(std::int64_t cycle, const channels::ChannelOutput& output);

  LogDescription description_;
  MessageSender sender_;
  struct ShownWorkpiece {
    std::uint32_t announcements = 0;
    std::int64_t cycle = 0;  // of the latest message
  };
  PerChannel<ShownWorkpiece> workpieces_{};
  struct ShownTool {
    channels::ToolAtWork tool;
    std::int64_t cycle = -1;  // of the latest message; -1: none yet
  };
  PerChannel<ShownTool> tools_{};
  struct ShownToolRow {
    channels::ToolRow row;
    std::int64_t cycle = 0;  // of the latest message
  };
  PerChannel<ShownToolRow> tool_rows_{};
  struct ShownSituation {
    std::uint32_t number = 0;
    std::int64_t cycle = -1;  // of the latest message; -1: none yet
  };
  PerChannel<ShownSituation> shown_situations_{};
  Situations situations_;
  bool workpieces_allowed_ = true;
  struct ShownPath {
    PathPreview preview;
    int number = 0;
    std::size_t next = 0;         // point; the first of the next message
    std::int64_t next_cycle = 0;  // when that is due
  };
  PerChannel<ShownPath> paths_{};
  std::set<std::uint64_t> sent_texts_;  // hashes
  struct Periods {                      // in cycles
    std::int64_t meta;
    std::int64_t state;
    std::int64_t situation;
    std::int64_t path;  // between two parts of a preview
  };
  Periods periods_;
  std::int64_t next_meta_cycle_;
};

}  // namespace stanok::recording

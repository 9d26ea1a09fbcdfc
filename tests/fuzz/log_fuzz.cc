// libFuzzer target: any bytes as a log, and as what a sound log of every message was damaged with.
// Every byte is of an event or of a damage that is told, and the contents are read without a fault.
#include <string>
#include <vector>

#include "recording/read/log_contents.h"
#include "stanok_messages/arrival_t.hpp"
#include "stanok_messages/channel_state_t.hpp"
#include "stanok_messages/drive_status_t.hpp"
#include "stanok_messages/event_t.hpp"
#include "stanok_messages/feedback_t.hpp"
#include "stanok_messages/force_status_t.hpp"
#include "stanok_messages/input_t.hpp"
#include "stanok_messages/log_meta_t.hpp"
#include "stanok_messages/log_types_t.hpp"
#include "stanok_messages/path_t.hpp"
#include "stanok_messages/process_status_t.hpp"
#include "stanok_messages/program_chunk_t.hpp"
#include "stanok_messages/program_read_t.hpp"
#include "stanok_messages/setpoint_t.hpp"
#include "stanok_messages/situation_t.hpp"
#include "stanok_messages/tool_row_t.hpp"
#include "stanok_messages/tool_t.hpp"
#include "stanok_messages/workpiece_t.hpp"
#include "tests/fuzz/memory_file.h"

using namespace stanok;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t header_bytes = 28;

void append_big_endian(Bytes& log, std::uint64_t value, int bytes) {
  for (int k = bytes - 1; k >= 0; --k) log.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

// An event as LCM writes it: sync word, number, time, lengths, name, message.
template <class Message>
void append_event(Bytes& log, const std::string& topic) {
  const Message message{};
  Bytes coded(static_cast<std::size_t>(message.getEncodedSize()));
  if (message.encode(coded.data(), 0, static_cast<int>(coded.size())) < 0) std::abort();
  const std::string channel = "STANOK_M_CH1_" + topic;
  append_big_endian(log, 0xEDA1DA01U, 4);
  append_big_endian(log, 0, 8);
  append_big_endian(log, 0, 8);
  append_big_endian(log, channel.size(), 4);
  append_big_endian(log, coded.size(), 4);
  log.insert(log.end(), channel.begin(), channel.end());
  log.insert(log.end(), coded.begin(), coded.end());
}

const Bytes& sound_log() {
  static const Bytes log = [] {
    Bytes made;
    append_event<log_meta_t>(made, "LOG_META");
    append_event<setpoint_t>(made, "SETPOINT");
    append_event<channel_state_t>(made, "STATE");
    append_event<drive_status_t>(made, "DRIVE");
    append_event<process_status_t>(made, "PROCESS");
    append_event<force_status_t>(made, "FORCE");
    append_event<event_t>(made, "EVENT");
    append_event<input_t>(made, "INPUT");
    append_event<arrival_t>(made, "ARRIVAL");
    append_event<feedback_t>(made, "FEEDBACK");
    append_event<program_chunk_t>(made, "PROGRAM");
    append_event<program_read_t>(made, "PROGRAM_READ");
    append_event<workpiece_t>(made, "WORKPIECE");
    append_event<tool_t>(made, "TOOL");
    append_event<tool_row_t>(made, "TOOL_ROW");
    append_event<situation_t>(made, "SITUATION");
    append_event<log_types_t>(made, "LOG_TYPES");
    append_event<path_t>(made, "PATH");
    return made;
  }();
  return log;
}

void read(const Bytes& bytes) {
  const fuzz::MemoryFile file(bytes.data(), bytes.size());
  auto reader = recording::LogReader::open(file.path());
  if (!reader) std::abort();
  std::size_t accounted = 0;
  while (const auto event = reader->next())
    accounted += header_bytes + event->channel.size() + event->bytes.size();
  for (const recording::Damage& damage : reader->damage())
    accounted += static_cast<std::size_t>(damage.bytes);
  if (accounted != bytes.size()) std::abort();
  const auto contents = recording::read_contents(file.path());
  if (!contents) std::abort();
  static_cast<void>(recording::axes_of(*contents, 1, 8));
}

// Two bytes say how many are cut off; then triples of a place and what is changed there.
Bytes damaged(const std::uint8_t* bytes, std::size_t size) {
  Bytes log = sound_log();
  if (size < 2) return log;
  log.resize(log.size() - (std::size_t{bytes[0]} << 8 | bytes[1]) % log.size());
  for (std::size_t k = 2; k + 2 < size; k += 3) {
    const std::size_t place = (std::size_t{bytes[k]} << 8 | bytes[k + 1]) % log.size();
    log[place] ^= bytes[k + 2];
  }
  return log;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  read(Bytes(bytes, bytes + size));
  read(damaged(bytes, size));
  return 0;
}

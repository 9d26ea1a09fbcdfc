// What recording costs: one cycle of one five-axis channel, encoded and written to a log, and read.
#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>

#include "recording/format/decode.h"
#include "recording/log/log_reader.h"
#include "recording/log/log_writer.h"
#include "recording/stream/message_stream.h"

namespace stanok::recording {
namespace {

LogDescription five_axes() {
  LogDescription description;
  description.machine = "benchmark";
  description.channels.push_back(
      {1, {{"X", "X"}, {"Y", "Y"}, {"Z", "Z"}, {"B", "B", true}, {"C", "C", true}}});
  return description;
}

channels::CycleOutput moving_output() {
  channels::CycleOutput output;
  output.channel_count = 1;
  channels::ChannelOutput& channel = output.channels[0];
  channel.id = 1;
  channel.axis_count = 5;
  for (std::size_t k = 0; k < 5; ++k) {
    channel.axes[k].position = 0.1 * static_cast<double>(k + 1);
    channel.axes[k].velocity = 11.0;
  }
  return output;
}

// A log that goes with the benchmark.
class LogFile {
 public:
  LogFile() = default;
  ~LogFile() { std::filesystem::remove(path_); }
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / "stanok_recording_benchmark.lcm";
};

void encode_setpoint(benchmark::State& state) {
  const channels::CycleOutput output = moving_output();
  std::array<std::uint8_t, 1024> buffer{};
  for ([[maybe_unused]] auto _ : state) {
    const setpoint_t message = to_setpoint(output.channels[0], {});
    benchmark::DoNotOptimize(message.encode(buffer.data(), 0, static_cast<int>(buffer.size())));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(encode_setpoint);

// Encoded, framed, buffered and handed to the operating system; SETPOINT and every 50th STATE.
void write_cycle(benchmark::State& state) {
  const LogFile file;
  auto writer = LogWriter::open(file.path());
  if (!writer) {
    state.SkipWithError(writer.error().text.c_str());
    return;
  }
  MessageStream stream(five_axes(), {writer->get()});
  channels::CycleOutput output = moving_output();
  for ([[maybe_unused]] auto _ : state) {
    stream.cycle(output);
    ++output.cycle;
  }
  state.SetBytesProcessed((*writer)->status().bytes);
  state.counters["bytes_per_cycle"] =
      static_cast<double>((*writer)->status().bytes) / static_cast<double>(state.iterations());
}
BENCHMARK(write_cycle)->Iterations(200'000);

void read_event(benchmark::State& state) {
  const LogFile file;
  if (auto writer = LogWriter::open(file.path()); writer) {
    MessageStream stream(five_axes(), {writer->get()});
    channels::CycleOutput output = moving_output();
    for (; output.cycle < 10'000; ++output.cycle) stream.cycle(output);
  }
  auto reader = LogReader::open(file.path());
  for ([[maybe_unused]] auto _ : state) {
    if (!reader) {
      state.SkipWithError(reader.error().text.c_str());
      break;
    }
    const auto event = reader->next();
    if (event) {
      benchmark::DoNotOptimize(decode<setpoint_t>(event->bytes));
    } else {
      reader = LogReader::open(file.path());
    }
  }
}
BENCHMARK(read_event);

}  // namespace
}  // namespace stanok::recording

#include "runtime/trace_writer.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace stanok::runtime {
namespace {

const channels::ChannelConfig& channel_config(const channels::MachineConfig& machine, int id) {
  const auto found = std::find_if(machine.channels.begin(), machine.channels.end(),
                                  [id](const channels::ChannelConfig& c) { return c.id == id; });
  if (found == machine.channels.end()) {
    throw std::invalid_argument("no channel " + std::to_string(id) + " in " + machine.file);
  }
  return *found;
}

std::vector<std::string> lower_words(const channels::ChannelConfig& channel) {
  std::vector<std::string> words = channel.words;
  for (std::string& word : words) {
    std::transform(word.begin(), word.end(), word.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
  }
  return words;
}

const channels::ChannelOutput* output_of(const channels::CycleOutput& output, int channel) {
  for (int k = 0; k < output.channel_count; ++k) {
    const auto& candidate = output.channels[static_cast<std::size_t>(k)];
    if (candidate.id == channel) return &candidate;
  }
  return nullptr;
}

void write_header(std::FILE* stream, const char* leading, const std::vector<std::string>& words) {
  std::fputs(leading, stream);
  for (const char* prefix : {"", "v", "a", "j"}) {
    for (const std::string& word : words) std::fprintf(stream, ",%s%s", prefix, word.c_str());
  }
  std::fputc('\n', stream);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : stream_(std::fopen(path.c_str(), "w")) {
  if (stream_ == nullptr) throw std::system_error(errno, std::generic_category(), path);
}

TipTrace::TipTrace(const channels::MachineConfig& machine, int channel, std::string path)
    : channel_(channel),
      cycle_s_(machine.cycle_us * 1e-6),
      path_(std::move(path)),
      words_(lower_words(channel_config(machine, channel))) {}

void TipTrace::begin_run(std::uint32_t run) {
  run_ = run;
  moved_ = false;
  ++runs_;
  file_ = std::make_unique<OutputFile>(runs_ == 1 ? path_ : path_ + "." + std::to_string(runs_));
  write_header(file_->stream(), "t,line,feed", words_);
}

void TipTrace::observe(const channels::CycleOutput& output) {
  const channels::ChannelOutput* channel = output_of(output, channel_);
  if (channel == nullptr) return;
  const bool runs = channel->running;
  if (runs && (file_ == nullptr || channel->run != run_)) begin_run(channel->run);
  if (runs && channel->moving && !moved_) {
    moved_ = true;
    if (const auto* rest = output_of(before_, channel_)) write_row(before_, *rest);
  }
  if (runs && moved_) write_row(output, *channel);
  if (!moved_ || !runs) before_ = output;
}

void TipTrace::write_row(const channels::CycleOutput& output,
                         const channels::ChannelOutput& channel) {
  std::FILE* stream = file_->stream();
  std::fprintf(stream, "%.16e,%u,%.16e", static_cast<double>(output.cycle) * cycle_s_,
               channel.tag.line, channel.feed_commanded);
  const auto count = static_cast<std::size_t>(channel.axis_count);
  for (std::size_t k = 0; k < count; ++k) std::fprintf(stream, ",%.16e", channel.point_W[k].value);
  for (std::size_t k = 0; k < count; ++k) std::fprintf(stream, ",%.16e", channel.point_W[k].first);
  for (std::size_t k = 0; k < count; ++k) {
    std::fprintf(stream, ",%.16e", channel.point_W[k].second);
  }
  for (std::size_t k = 0; k < count; ++k) std::fprintf(stream, ",%.16e", channel.point_W[k].third);
  std::fputc('\n', stream);
}

AxisTrace::AxisTrace(const channels::MachineConfig& machine, int channel, const std::string& path)
    : channel_(channel), cycle_s_(machine.cycle_us * 1e-6), file_(path) {
  const auto& config = channel_config(machine, channel);
  std::fputs("#", file_.stream());
  for (std::size_t k = 0; k < config.axes.size(); ++k) {
    const auto& axis = machine.axes[static_cast<std::size_t>(config.axes[k])];
    std::fprintf(file_.stream(), " %s=%s", config.words[k].c_str(), axis.name.c_str());
  }
  std::fputc('\n', file_.stream());
  write_header(file_.stream(), "t,line", lower_words(config));
}

void AxisTrace::observe(const channels::CycleOutput& output) {
  const channels::ChannelOutput* channel = output_of(output, channel_);
  if (channel == nullptr) return;
  std::fprintf(file_.stream(), "%.16e,%u", static_cast<double>(output.cycle) * cycle_s_,
               channel->running ? channel->tag.line : 0U);
  using Field = double channels::AxisSetpoint::*;
  for (const Field field : {&channels::AxisSetpoint::position, &channels::AxisSetpoint::velocity,
                            &channels::AxisSetpoint::acceleration, &channels::AxisSetpoint::jerk}) {
    for (int k = 0; k < channel->axis_count; ++k) {
      std::fprintf(file_.stream(), ",%.16e", channel->axes[static_cast<std::size_t>(k)].*field);
    }
  }
  std::fputc('\n', file_.stream());
}

}  // namespace stanok::runtime

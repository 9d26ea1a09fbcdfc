#include "runtime/trace_writer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "base/place.h"

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
  stands_ = false;
  standing_rows_.clear();
  ++runs_;
  file_ = std::make_unique<OutputFile>(runs_ == 1 ? path_ : path_ + "." + std::to_string(runs_));
  write_header(file_->stream(), "t,line,feed", words_);
}

void TipTrace::observe(const channels::CycleOutput& output) {
  const channels::ChannelOutput* channel = output.of_channel(channel_);
  if (channel == nullptr) return;
  const bool runs = channel->running;
  if (runs && (file_ == nullptr || channel->run != run_)) begin_run(channel->run);
  if (runs && channel->moving && !moved_) {
    moved_ = true;
    if (const auto* rest = before_.of_channel(channel_)) write(row(before_, *rest));
  }
  if (!moved_ || !runs) before_ = output;
  if (!runs || !moved_) return;
  if (!channel->moving && stands_) {
    standing_rows_ += row(output, *channel);
    return;
  }
  write(standing_rows_ + row(output, *channel));
  standing_rows_.clear();
  stands_ = !channel->moving;
}

std::string TipTrace::row(const channels::CycleOutput& output,
                          const channels::ChannelOutput& channel) const {
  constexpr std::size_t number_max = 32;  // characters
  std::array<char, number_max> number{};
  std::string text;
  const auto append = [&](const char* format, auto value) {
    const int length = std::snprintf(number.data(), number.size(), format, value);
    text.append(number.data(), checked_size(length));
  };
  append("%.16e", static_cast<double>(output.cycle) * cycle_s_);
  append(",%u", channel.tag.line);
  append(",%.16e", channel.feed_commanded);
  using Field = double kinematics::Jet::*;
  for (const Field field : {&kinematics::Jet::value, &kinematics::Jet::first,
                            &kinematics::Jet::second, &kinematics::Jet::third}) {
    for (int k = 0; k < channel.axis_count; ++k) {
      append(",%.16e", channel.point_W[k].*field);
    }
  }
  text += '\n';
  return text;
}

void TipTrace::write(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), file_->stream());
}

AxisTrace::AxisTrace(const channels::MachineConfig& machine, int channel, const std::string& path)
    : channel_(channel), cycle_s_(machine.cycle_us * 1e-6), file_(path) {
  const auto& config = channel_config(machine, channel);
  std::fputs("#", file_.stream());
  for (std::size_t k = 0; k < config.axes.size(); ++k) {
    const auto& axis = machine.axes[config.axes[k]];
    std::fprintf(file_.stream(), " %s=%s", config.words[k].c_str(), axis.name.c_str());
  }
  std::fputc('\n', file_.stream());
  write_header(file_.stream(), "t,line", lower_words(config));
}

void AxisTrace::observe(const channels::CycleOutput& output) {
  const channels::ChannelOutput* channel = output.of_channel(channel_);
  if (channel == nullptr) return;
  std::fprintf(file_.stream(), "%.16e,%u", static_cast<double>(output.cycle) * cycle_s_,
               channel->running ? channel->tag.line : 0U);
  using Field = double channels::AxisSetpoint::*;
  for (const Field field : {&channels::AxisSetpoint::position, &channels::AxisSetpoint::velocity,
                            &channels::AxisSetpoint::acceleration, &channels::AxisSetpoint::jerk}) {
    for (int k = 0; k < channel->axis_count; ++k) {
      std::fprintf(file_.stream(), ",%.16e", channel->axes[k].*field);
    }
  }
  std::fputc('\n', file_.stream());
}

}  // namespace stanok::runtime

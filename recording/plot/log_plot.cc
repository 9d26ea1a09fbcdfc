#include "recording/plot/log_plot.h"

#include <cerrno>
#include <fstream>

#include "recording/plot/channel_plot.h"
#include "recording/plot/gnuplot.h"
#include "recording/plot/plot_script.h"

namespace stanok::recording {
namespace {

std::optional<LogError> write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return std::nullopt;
  return log_error("cannot write " + file.string(), errno);
}

}  // namespace

Expected<std::vector<std::string>, LogError> plot_channel(const std::filesystem::path& file,
                                                          const LogContents& contents, int channel,
                                                          const std::filesystem::path& directory) {
  const auto plot = gather_plot(file, contents, channel);
  if (!plot) return Unexpected<LogError>(plot.error());
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return Unexpected<LogError>(log_error("cannot make " + directory.string(), error.value()));
  }
  const PlotScript script = plot_script(*plot);
  const auto script_file = directory / ("ch" + std::to_string(channel) + ".gnuplot");
  if (const auto failure = write_file(script_file, script.text)) {
    return Unexpected<LogError>(*failure);
  }
  if (const auto failure = run_gnuplot(script_file)) return Unexpected<LogError>(*failure);
  std::vector<std::string> pictures;
  pictures.reserve(script.pictures.size());
  for (const std::string& picture : script.pictures) {
    pictures.push_back((directory / picture).string());
  }
  return pictures;
}

}  // namespace stanok::recording

// The gnuplot script that draws one channel, with its data in it.
#pragma once

#include <string>
#include <vector>

#include "recording/plot/channel_plot.h"

namespace stanok::recording {

struct PlotScript {
  std::string text;
  std::vector<std::string> pictures;  // files that it writes, in its directory
};

[[nodiscard]] PlotScript plot_script(const ChannelPlot& plot);

}  // namespace stanok::recording

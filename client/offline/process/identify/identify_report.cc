#include "client/offline/process/identify/identify_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include "client/offline/process/identify/power_picture.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

std::string figures_text(const jobs::Figures& figures) {
  TextTable table{{"quantity", "value", "from", "to", "unit"}};
  for (const jobs::Figure& figure : figures) {
    const auto number = [&](double value) { return fmt::format("{:.{}f}", value, figure.digits); };
    const process::Estimate read = figure.read();
    table.add_row({std::string(figure.title), number(read.value), number(read.low),
                   number(read.high), std::string(figure.unit)});
  }
  return table.text(Terminal(STDOUT_FILENO)) + "intervals hold the value with 95 % probability\n";
}

std::string idle_text(const std::optional<jobs::IdlePower>& idle) {
  if (!idle) return "";
  return fmt::format("idle power {:.1f} W at {:.0f} rev/min; ", idle->power_w, idle->rev_per_min);
}

}  // namespace

std::string to_text(const jobs::Identification& found) {
  const process::FitVerdict& verdict = found.verdict;
  std::string text;
  if (!verdict.reason.empty()) text = verdict.reason + "\n" + verdict.remedy + "\n";
  if (verdict.state == process::FitState::widened)
    text += "the intervals are widened by what this may do to the figures\n";
  if (!verdict.is_refused()) text += figures_text(found.figures) + idle_text(found.idle);
  return text +
         fmt::format("{} readings, noise {:.1f} % of the cutting power, {:.1f} W left (rms)\n",
                     found.readings, 100.0 * found.noise, found.residual_w);
}

void draw_picture(const jobs::Identification& found, const std::filesystem::path& file) {
  draw_power_picture(found.power, file);
}

}  // namespace stanok::client

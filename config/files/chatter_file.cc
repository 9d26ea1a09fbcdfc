#include "config/files/chatter_file.h"

#include "config/text/flat_file.h"

namespace stanok::config {
namespace {

using process::CutKind;
using process::CuttingProcess;
using process::VibrationMode;

constexpr double n_per_mm_of_n_per_um = 1000.0;

struct ChatterFile {
  std::string kind = "milling";
  std::string sense = "down";
  double width = 1.0;
  CuttingProcess process{};
  Subtables modes_x = nullptr;
  Subtables modes_y = nullptr;
};

const Keys<ChatterFile>& chatter_keys() {
  using F = ChatterFile;
  using P = CuttingProcess;
  static const Keys<ChatterFile> keys = {
      {"kind", at<&F::kind>, required, "", "the cut", one_of({"milling", "turning"})},
      {"force", at<&F::process, &P::force_n_per_mm2>, required, "N/mm2",
       "specific cutting force: tangential; turning: along the thickness of the chip",
       from(1.0, 1e5)},
      {"radial_ratio", at<&F::process, &P::radial_ratio>, optional, "",
       "milling: radial force as a part of the tangential one", from(0.0, 5.0)},
      {"teeth", at<&F::process, &P::teeth>, optional, "",
       "milling: teeth of the tool, evenly spaced", from(1, 100)},
      {"sense", at<&F::sense>, optional, "", "milling: up, or down (climb)",
       one_of({"up", "down"})},
      {"width", at<&F::width>, optional, "", "milling: width of cut as a part of the diameter",
       from(0.001, 1.0)},
      {"mode_x", at<&F::modes_x>, optional, "",
       "vibrations along the feed; turning: along the thickness of the chip"},
      {"mode_y", at<&F::modes_y>, optional, "", "milling: vibrations across the feed"},
  };
  return keys;
}

const Keys<VibrationMode>& mode_keys() {
  static const Keys<VibrationMode> keys = {
      {"frequency", at<&VibrationMode::frequency_hz>, required, "Hz", "natural frequency",
       from(1.0, 1e5)},
      {"damping", at<&VibrationMode::damping>, required, "",
       "damping ratio; 0.03 is usual, 3 % is written so", from(1e-4, 0.7)},
      {"stiffness", at<&VibrationMode::stiffness_n_per_mm>, required, "N/um", "modal stiffness",
       from(1e-3, 1e5)},
  };
  return keys;
}

std::vector<VibrationMode> read_modes(Subtables tables, const Scope& scope) {
  std::vector<VibrationMode> modes;
  if (tables == nullptr) return modes;
  for (const toml::node& node : *tables) {
    VibrationMode mode;
    read_table(*node.as_table(), mode_keys(), mode, scope);
    mode.stiffness_n_per_mm *= n_per_mm_of_n_per_um;
    modes.push_back(mode);
  }
  return modes;
}

void check_modes(const toml::table& table, const CuttingProcess& process, const Scope& scope) {
  if (process.kind == CutKind::turning && !process.modes_y.empty()) {
    scope.fault(place_of(table, "mode_y"),
                "a turning cut has vibrations along the thickness of the chip only; give them as "
                "[[mode_x]]");
  }
  const std::size_t count = process.modes_x.size() + process.modes_y.size();
  if (count > VibrationMode::count_max) {
    scope.fault(table.source(),
                "there are " + std::to_string(count) + " modes; give the " +
                    std::to_string(VibrationMode::count_max) +
                    " that matter most, those of the least stiffness times damping");
  }
  if (count == 0) scope.fault(table.source(), "at least one [[mode_x]] or [[mode_y]] is needed");
}

}  // namespace

CuttingProcess read_chatter_file(const std::filesystem::path& file) {
  ChatterFile content;
  CuttingProcess& process = content.process;
  read_flat_file(file, chatter_keys(), "cut", content,
                 [&](const toml::table& table, const Scope& scope) {
                   process.kind = content.kind == "turning" ? CutKind::turning : CutKind::milling;
                   process.modes_x = read_modes(content.modes_x, scope.inner("[[mode_x]]"));
                   process.modes_y = read_modes(content.modes_y, scope.inner("[[mode_y]]"));
                   scope.faults.throw_if_any();
                   check_modes(table, process, scope);
                 });
  process::engage(process,
                  content.sense == "up" ? process::MillingSense::up : process::MillingSense::down,
                  content.width);
  return process;
}

std::vector<KeyRow> chatter_key_rows() {
  return describe(chatter_keys());
}

std::vector<KeyRow> vibration_mode_key_rows() {
  return describe(mode_keys());
}

}  // namespace stanok::config

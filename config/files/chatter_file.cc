#include "config/files/chatter_file.h"

#include <numbers>

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
  double helix_deg = 0.0;
  CuttingProcess process{};
  Subtables modes_x = nullptr;
  Subtables modes_y = nullptr;
};

const Keys<ChatterFile>& chatter_keys() {
  using F = ChatterFile;
  using P = CuttingProcess;
  using G = process::GrindingContact;
  static const Keys<ChatterFile> keys = {
      {"kind", at<&F::kind>, required, "", "the cut", one_of({"milling", "turning", "grinding"})},
      {"force", at<&F::process, &P::force_n_per_mm2>, required, "N/mm2",
       "specific cutting force: tangential; turning: along the chip thickness; grinding: normal "
       "force per unit of width and layer",
       from(1.0, 1e5)},
      {"radial_ratio", at<&F::process, &P::radial_ratio>, optional, "",
       "milling: radial force as a fraction of the tangential force", from(0.0, 5.0)},
      {"teeth", at<&F::process, &P::teeth>, optional, "",
       "milling: number of teeth of the tool, evenly spaced", from(1, 100)},
      {"sense", at<&F::sense>, optional, "", "milling: up (conventional) or down (climb)",
       one_of({"up", "down"})},
      {"width", at<&F::width>, optional, "", "milling: width of cut as a fraction of the diameter",
       from(0.001, 1.0)},
      {"helix", at<&F::helix_deg>, optional, "deg", "milling, forces along a program: helix angle",
       from(0.0, 70.0)},
      {"edge_force", at<&F::process, &P::edge_n_per_mm>, optional, "N/mm",
       "milling, forces along a program: tangential edge force at zero chip thickness",
       from(0.0, 1e4)},
      {"edge_force_radial", at<&F::process, &P::edge_radial_n_per_mm>, optional, "N/mm",
       "radial edge force at zero chip thickness", from(0.0, 1e4)},
      {"part_radius", at<&F::process, &P::grinding, &G::part_radius_mm>, optional, "mm",
       "grinding, required: radius of the part", from(0.1, 1e4), "none"},
      {"wheel_radius", at<&F::process, &P::grinding, &G::wheel_radius_mm>, optional, "mm",
       "grinding, required: radius of the wheel", from(0.1, 1e4), "none"},
      {"wheel_speed", at<&F::process, &P::grinding, &G::wheel_rev_per_min>, optional, "rev/min",
       "grinding, required: speed of the wheel", from(1.0, 1e6), "none"},
      {"contact_length", at<&F::process, &P::grinding, &G::length_mm>, optional, "mm",
       "grinding: contact length of wheel and part; shorter waves are smoothed out",
       from(0.0, 100.0)},
      {"contact_stiffness", at<&F::process, &P::grinding, &G::stiffness_n_per_mm2>, optional,
       "N/mm2", "grinding: contact stiffness per unit of width; 0: rigid", from(0.0, 1e7)},
      {"grinding_ratio", at<&F::process, &P::grinding, &G::grinding_ratio>, optional, "",
       "grinding ratio: volume removed from the part per volume lost by the wheel; 0: the wheel "
       "does not wear",
       from(0.0, 1e6)},
      {"mode_x", at<&F::modes_x>, optional, "",
       "vibrations along the feed; turning: along the chip thickness; grinding: along the infeed"},
      {"mode_y", at<&F::modes_y>, optional, "", "milling: vibrations across the feed"},
  };
  return keys;
}

const Keys<VibrationMode>& mode_keys() {
  static const Keys<VibrationMode> keys = {
      {"frequency", at<&VibrationMode::frequency_hz>, required, "Hz", "natural frequency",
       from(1.0, 1e5)},
      {"damping", at<&VibrationMode::damping>, required, "", "damping ratio; 0.03 (3 %) is usual",
       from(1e-4, 0.7)},
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

CutKind kind_named(const std::string& name) {
  if (name == "turning") return CutKind::turning;
  return name == "grinding" ? CutKind::grinding : CutKind::milling;
}

void check_grinding(const toml::table& table, const CuttingProcess& process, const Scope& scope) {
  if (process.kind != CutKind::grinding) return;
  for (const char* const key : {"part_radius", "wheel_radius", "wheel_speed"}) {
    if (!table.contains(key))
      scope.fault(table.source(), std::string(key) + " is missing; grinding needs it");
  }
}

void check_modes(const toml::table& table, const CuttingProcess& process, const Scope& scope) {
  if (process.kind != CutKind::milling && !process.modes_y.empty()) {
    scope.fault(
        place_of(table, "mode_y"),
        process.kind == CutKind::turning
            ? "a turning cut has vibrations only along the chip thickness; give them as [[mode_x]]"
            : "grinding has vibrations only along the infeed; give them as [[mode_x]]");
  }
  const std::size_t count = process.modes_x.size() + process.modes_y.size();
  if (count > VibrationMode::count_max) {
    scope.fault(table.source(),
                "there are " + std::to_string(count) + " modes; give the " +
                    std::to_string(VibrationMode::count_max) +
                    " that matter most: those with the smallest product of stiffness and damping");
  }
  if (count == 0) scope.fault(table.source(), "at least one [[mode_x]] or [[mode_y]] is needed");
}

}  // namespace

CuttingProcess read_chatter_file(const std::filesystem::path& file) {
  ChatterFile content;
  CuttingProcess& process = content.process;
  read_flat_file(file, chatter_keys(), "cut", content,
                 [&](const toml::table& table, const Scope& scope) {
                   process.kind = kind_named(content.kind);
                   process.modes_x = read_modes(content.modes_x, scope.inner("[[mode_x]]"));
                   process.modes_y = read_modes(content.modes_y, scope.inner("[[mode_y]]"));
                   scope.faults.throw_if_any();
                   check_modes(table, process, scope);
                   check_grinding(table, process, scope);
                 });
  process.helix_rad = content.helix_deg * std::numbers::pi / 180.0;
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

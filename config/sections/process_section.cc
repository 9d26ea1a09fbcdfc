#include "config/sections/process_section.h"

#include <algorithm>

namespace stanok::config {
namespace {

using process::ForceControlConfig;

struct ProcessFile {
  ForceControlConfig control;
  Integers channels;
  std::string on_sensor_fault = "hold";
};

const Keys<ProcessFile>& process_keys() {
  using F = ProcessFile;
  using C = ForceControlConfig;
  static const Keys<F> keys = {
      {"channels", at<&F::channels>, optional, "",
       "ids of the channels, lathes or grinders, whose master spindle has a power sensor for force "
       "control",
       any, "all lathes and grinders with axes and a spindle"},
      {"feed_min", at<&F::control, &C::feed_min>, optional, "mm/s",
       "lowest feed of force control; 0: a twentieth of the programmed feed", not_negative},
      {"feed_max", at<&F::control, &C::feed_max>, optional, "mm/s",
       "highest feed of force control; 0: the programmed feed", not_negative},
      {"efficiency", at<&F::control, &C::efficiency>, optional, "",
       "efficiency of the spindle drive: cutting power over electrical power above idle",
       from(0.1, 1.0)},
      {"power_lag", at<&F::control, &C::power_lag_s>, optional, "s",
       "lag of the power sensor, with half a poll of its bus", positive},
      {"power_min", at<&F::control, &C::power_min_w>, optional, "W",
       "below this power of the setpoint, which the sensor cannot measure, the feed controller "
       "holds its feed",
       not_negative},
      {"air_part", at<&F::control, &C::air_part>, optional, "",
       "below this fraction of the commanded power the tool counts as out of the cut",
       from(0.01, 0.9)},
      {"power_answer", at<&F::control, &C::power_answer_s>, optional, "s",
       "time that the power takes to show a change of the feed, beyond a revolution and three lags",
       from(0.0, 10.0)},
      {"air_time", at<&F::control, &C::air_time_s>, optional, "s",
       "longest air cut at working feed; a force that is missing for longer, in the air or at "
       "feed_max, is reported (W615)",
       positive},
      {"lighter_max", at<&F::control, &C::lighter_max>, optional, "",
       "part by which the cut may become lighter than it was, or than the programmed feed means: "
       "the feed rises no further where the power shows more of it, since a sensor that loses gain "
       "shows the same (W616); 1: any",
       from(0.0, 1.0)},
      {"feed_step", at<&F::control, &C::feed_step>, optional, "",
       "part by which the feed may rise above the last feed to which the power has answered",
       from(0.02, 0.5)},
      {"question", at<&F::control, &C::asks_downwards>, optional, "",
       "once a minute of steady cut the feed is lowered by feed_step for a moment, to see whether "
       "the power answers; false where that would mark the surface"},
      {"gaps_per_turn", at<&F::control, &C::gaps_per_turn>, optional, "",
       "for interrupted cuts: evenly spaced gaps of the workpiece, or teeth of the tool, per "
       "revolution of the spindle; 0: the control finds their number",
       from(0, 8)},
      {"idle_settle", at<&F::control, &C::idle_settle_s>, optional, "s",
       "time at speed before the idle power is taken", not_negative},
      {"idle_capture", at<&F::control, &C::idle_capture_s>, optional, "s",
       "time over which the idle power is averaged", positive},
      {"idle_coulomb_part", at<&F::control, &C::idle_coulomb_part>, optional, "",
       "fraction of the idle power that grows with the speed; the rest grows with its square",
       from(0.0, 1.0)},
      {"gain", at<&F::control, &C::gain>, optional, "",
       "gain of the feed controller times the dead time of chip and sensor", from(0.01, 1.0)},
      {"feed_exponent", at<&F::control, &C::feed_exponent>, optional, "",
       "y of the cutting force, P_z = C t S^y", from(0.3, 1.5)},
      {"feed_lag", at<&F::control, &C::feed_lag_s>, optional, "s",
       "lag of the feed drives, for oscillations of the force", not_negative},
      {"on_sensor_fault", at<&F::on_sensor_fault>, optional, "",
       "reaction of the feed when the power cannot be trusted", one_of({"hold", "feed_min"})},
      {"vibration_level", at<&F::control, &C::vibration_level_um>, optional, "um",
       "permitted vibration; 0: vibration has no effect", not_negative},
      {"vibration_release", at<&F::control, &C::vibration_release>, optional, "",
       "fraction of the level below which the vibration has no effect again", from(0.1, 1.0)},
      {"reduced_mass", at<&F::control, &C::reduced_mass_kg>, optional, "kg",
       "mass of the oscillating system", not_negative},
      {"oscillation_frequency", at<&F::control, &C::oscillation_hz>, optional, "Hz",
       "frequency of the force oscillation that the control forms from the vibration",
       not_negative},
      {"oscillation_reserve", at<&F::control, &C::oscillation_reserve>, optional, "",
       "amplitude of that oscillation divided by the smallest one that quenches the vibration",
       from(1.0, 3.0)},
  };
  return keys;
}

struct CuttingFile {
  CuttingConfig cutting;
  Subtables stock = nullptr;
};

const Keys<CuttingFile>& cutting_keys() {
  using F = CuttingFile;
  using C = CuttingConfig;
  static const Keys<F> keys = {
      {"channel", at<&F::cutting, &C::channel>, optional, "", "channel whose tool cuts",
       from(1, 99)},
      {"specific_force", at<&F::cutting, &C::specific_force_n>, optional, "N",
       "C of P_z = C t S^y (HB / hardness)^e: depth 1 mm, feed 1 mm per revolution", positive},
      {"feed_exponent", at<&F::cutting, &C::feed_exponent>, optional, "", "y", from(0.3, 1.5)},
      {"hardness", at<&F::cutting, &C::hardness_hb>, optional, "HB",
       "hardness for which specific_force is valid", positive},
      {"hardness_exponent", at<&F::cutting, &C::hardness_exponent>, optional, "", "e",
       not_negative},
      {"efficiency", at<&F::cutting, &C::efficiency>, optional, "",
       "efficiency of the spindle drive", from(0.1, 1.0)},
      {"power_lag", at<&F::cutting, &C::power_lag_s>, optional, "s", "lag of the power sensor",
       not_negative},
      {"sample_ms", at<&F::cutting, &C::sample_ms>, optional, "ms",
       "how often the sensors are read where the drives are ideal", from(1, 1000)},
      {"vibration", at<&F::cutting, &C::vibration_um>, optional, "um",
       "amplitude of the self-oscillation in the cut; 0: none", not_negative},
      {"vibration_frequency", at<&F::cutting, &C::vibration_hz>, optional, "Hz",
       "frequency of the self-oscillation", from(20.0, 400.0)},
      {"vibration_mass", at<&F::cutting, &C::vibration_mass_kg>, optional, "kg",
       "reduced mass of the self-oscillation", positive},
      {"stock", at<&F::stock>, required, "", "sections of the workpiece, starting at its face"},
  };
  return keys;
}

const Keys<StockSection>& stock_keys() {
  static const Keys<StockSection> keys = {
      {"z", at<&StockSection::z_mm>, required, "mm",
       "where the section begins, in the coordinates of the program; it ends at the next one"},
      {"radius", at<&StockSection::radius_mm>, required, "mm",
       "radius of the workpiece in this section", positive},
      {"hardness", at<&StockSection::hardness_hb>, optional, "HB", "hardness of the material",
       positive},
  };
  return keys;
}

void mark_channels(const toml::table& table, const Integers& wanted,
                   channels::MachineConfig& machine, const Scope& scope) {
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (std::ranges::find(machine.channels, wanted[i], &channels::ChannelConfig::id) !=
        machine.channels.end())
      continue;
    scope.fault(place_of(table, "channels", i),
                "there is no channel " + std::to_string(wanted[i]) + "; name a [[channel]]");
  }
  for (channels::ChannelConfig& channel : machine.channels) {
    const auto named = std::ranges::find(wanted, channel.id);
    const bool is_wanted = wanted.empty() || named != wanted.end();
    const bool has_radius = channel.kind != lang::ChannelKind::mill;
    if (named != wanted.end() && !has_radius) {
      scope.fault(place_of(table, "channels", static_cast<std::size_t>(named - wanted.begin())),
                  "channel " + std::to_string(channel.id) +
                      " is a mill; force control takes the cutting radius from the X axis, which "
                      "holds on lathes and grinders only");
    }
    channel.force_control =
        is_wanted && has_radius && !channel.axes.empty() && !channel.spindles.empty();
  }
}

}  // namespace

ProcessConfig read_process(const toml::table& table, channels::MachineConfig& machine,
                           const Scope& scope) {
  ProcessFile file;
  read_table(table, process_keys(), file, scope);
  ForceControlConfig& control = file.control;
  if (control.feed_max > 0.0 && control.feed_min > control.feed_max) {
    scope.fault(place_of(table, "feed_min"),
                "feed_min exceeds feed_max, " + number_text(control.feed_max));
  }
  if (file.on_sensor_fault == "feed_min") control.on_sensor_fault = process::SensorFault::feed_min;
  mark_channels(table, file.channels, machine, scope);
  return {.control = control};
}

CuttingConfig read_cutting(const toml::table& table, const channels::MachineConfig& machine,
                           const Scope& scope) {
  CuttingFile file;
  read_table(table, cutting_keys(), file, scope);
  CuttingConfig& cutting = file.cutting;
  const auto channel =
      std::ranges::find(machine.channels, cutting.channel, &channels::ChannelConfig::id);
  if (channel == machine.channels.end() || channel->spindles.empty()) {
    scope.fault(place_of(table, "channel"),
                "channel " + std::to_string(cutting.channel) + " has no spindle that could cut");
  }
  if (file.stock == nullptr) return cutting;
  for (const toml::node& node : *file.stock) {
    const toml::table& row = *node.as_table();
    StockSection section{.hardness_hb = cutting.hardness_hb};
    read_table(row, stock_keys(), section, scope.inner("stock"));
    if (!cutting.stock.empty() && section.z_mm >= cutting.stock.back().z_mm) {
      scope.fault(
          place_of(row, "z"),
          "sections go from the face to smaller z; this one is not below the previous one, " +
              number_text(cutting.stock.back().z_mm));
    }
    cutting.stock.push_back(section);
  }
  return cutting;
}

std::vector<KeyRow> process_key_rows() {
  return describe(process_keys());
}
std::vector<KeyRow> cutting_key_rows() {
  return describe(cutting_keys());
}
std::vector<KeyRow> stock_key_rows() {
  return describe(stock_keys());
}

}  // namespace stanok::config

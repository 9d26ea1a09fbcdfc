#include "daemon/start/kept_state.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "config/files/positions_file.h"
#include "config/files/tables_file.h"
#include "daemon/host/state_directory.h"
#include "runtime/axis_positions.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr DurableKind tables_kind{.name = "tables", .version = 1};
constexpr DurableKind positions_kind{.name = "positions", .version = 1};
constexpr std::int64_t moving_period_us = 10'000'000;

fs::path tables_file(const fs::path& directory) {
  return directory / "tables.toml";
}

fs::path positions_file(const fs::path& directory) {
  return directory / "positions.toml";
}

std::optional<std::string> read_text(const fs::path& file, const DurableKind& kind) {
  auto kept = read_durably(file, kind);
  if (!kept) throw StateDirectoryError(kept.error());
  if (!*kept) return std::nullopt;
  if (!(*kept)->warning.empty()) spdlog::warn("{}", (*kept)->warning);
  return std::move((*kept)->text);
}

// Names and shapes are those of the machine's file, all else is as it was kept.
channels::ToolEdge with_shape_of(const channels::ToolEdge& file, channels::ToolEdge kept) {
  kept.name = file.name;
  kept.kind = file.kind;
  kept.corner_radius = file.corner_radius;
  kept.flute_length = file.flute_length;
  kept.shank_diameter = file.shank_diameter;
  kept.holder_diameter = file.holder_diameter;
  kept.holder_length = file.holder_length;
  kept.point_angle = file.point_angle;
  kept.taper_angle = file.taper_angle;
  return kept;
}

// A tool that only the file names is new.
void take_tools_of_file(const channels::TablesConfig& file, channels::TablesConfig& kept) {
  for (const channels::ToolEdge& tool : file.tools) {
    const auto same = std::ranges::find_if(kept.tools, [&](const channels::ToolEdge& other) {
      return other.number == tool.number && other.edge == tool.edge;
    });
    if (same == kept.tools.end()) {
      kept.tools.push_back(tool);
    } else {
      *same = with_shape_of(tool, *same);
    }
  }
}

bool is_within(double position, const channels::AxisConfig& axis) {
  return position >= axis.limits.position_min && position <= axis.limits.position_max;
}

void start_where_kept(const channels::AxisRow& kept, channels::MachineConfig& machine) {
  for (channels::AxisConfig& axis : machine.axes) {
    const auto position = kept.find(axis.name);
    if (position == kept.end()) continue;
    if (is_within(position->second, axis)) {
      axis.start = position->second;
    } else {
      spdlog::warn("axis {} was at {}, which is not between its limits; it starts at {}", axis.name,
                   position->second, axis.start);
    }
  }
}

std::string positions_text(const channels::MachineConfig& machine,
                           const std::vector<double>& positions) {
  channels::AxisRow row;
  for (std::size_t k = 0; k < positions.size(); ++k) row[machine.axes[k].name] = positions[k];
  return config::to_positions_text(row);
}

bool is_any_moving(const channels::CycleOutput& output) {
  return std::ranges::any_of(output.of_channels(), &channels::ChannelOutput::moving);
}

}  // namespace

void load_state(const fs::path& directory, channels::MachineConfig& machine) {
  if (const auto text = read_text(tables_file(directory), tables_kind)) {
    auto kept =
        config::read_tables_text(*text, tables_file(directory), config::names_of_axes(machine));
    take_tools_of_file(machine.tables, kept);
    machine.tables = std::move(kept);
  }
  if (const auto text = read_text(positions_file(directory), positions_kind))
    start_where_kept(config::read_positions_text(*text, positions_file(directory)), machine);
}

PositionSnapshot::PositionSnapshot(const channels::MachineConfig& machine) : machine_(machine) {
  std::vector<double> starts;
  starts.reserve(machine.axes.size());
  for (const channels::AxisConfig& axis : machine.axes) starts.push_back(axis.start);
  kept_ = positions_text(machine, starts);
}

std::string PositionSnapshot::operator()(const channels::CycleOutput& newest) {
  const std::int64_t since_us = (newest.cycle - kept_cycle_) * machine_.cycle_us;
  if (newest.channel_count == 0 || (is_any_moving(newest) && since_us < moving_period_us))
    return kept_;
  kept_ = positions_text(machine_, runtime::positions_of_axes(machine_, newest));
  kept_cycle_ = newest.cycle;
  return kept_;
}

KeptState::KeptState(const fs::path& directory, RunningMachine& machine,
                     const StateKeeper::OnFault& on_fault)
    : positions_(machine.file().machine),
      table_keeper_(
          tables_file(directory), tables_kind,
          [&machine] { return config::to_toml(machine.tables()); }, on_fault),
      position_keeper_(
          positions_file(directory), positions_kind,
          [this, &machine] { return positions_(machine.newest_output()); }, on_fault) {}

}  // namespace stanok::daemon

#include "runtime/workpiece/workpiece_feed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recording/format/log_description.h"
#include "runtime/workpiece/stl_files.h"

namespace stanok::runtime {
namespace {

using simulation::Vector;

constexpr double standing_rev_per_min = 1.0;
constexpr int type_of_file = 2;  // of #workpiece

// The axis that the main spindle of a lathe becomes: it turns the part, not the tool.
int turning_axis(const channels::MachineConfig& machine, const channels::ChannelConfig& channel) {
  if (channel.kind != lang::ChannelKind::lathe) return -1;
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    const std::string& name = machine.axes[channel.axes[k]].name;
    const bool is_spindle = std::ranges::any_of(
        machine.spindles,
        [&](const channels::SpindleConfig& spindle) { return spindle.axis == name; });
    if (is_spindle) return static_cast<int>(k);
  }
  return -1;
}

simulation::BlankKind kind_of(int type) {
  if (type == 0) return simulation::BlankKind::box;
  return type == 1 ? simulation::BlankKind::cylinder : simulation::BlankKind::unknown;
}

simulation::Blank blank_of(int type, const double* size, const double* zero, double resolution) {
  simulation::Blank blank;
  blank.kind = kind_of(type);
  blank.size = Vector::Map(size);
  blank.zero = Vector::Map(zero);
  blank.resolution = resolution;
  return blank;
}

// What the messages of a blank from a file lack.
constexpr const char* not_in_messages =
    "the blank is an STL file, which logs and messages do not contain: use `stanok simulate` to "
    "cut the program, or see the page of the daemon";

// The STL file of a blank as it was when the program was loaded.
void read_solid(const channels::Workpiece& workpiece, simulation::Blank& blank) {
  auto bytes = bytes_of_stl(std::string(workpiece.file.view()));
  if (!bytes) {
    blank.unknown_because = bytes.error();
    return;
  }
  if (recording::text_hash(*bytes) != workpiece.shape.fingerprint) {
    blank.unknown_because =
        fmt::format("{} has changed since the program was loaded; load the program again",
                    workpiece.file.view());
    return;
  }
  auto solid = simulation::solid_of_stl(*bytes);
  if (!solid) {
    blank.unknown_because = solid.error().text;
    return;
  }
  blank.kind = simulation::BlankKind::solid;
  blank.scale = workpiece.shape.scale;
  blank.solid = std::make_shared<const simulation::Solid>(std::move(*solid));
}

// As fine as the blank wants to be, or as fits; sizes that are none stay as they are.
simulation::Blank fitting(simulation::Blank blank, std::uint64_t memory_max) {
  constexpr double coarser = 1.25;
  for (auto grid = grid_of(blank, memory_max); !grid && grid.error().code == "E9203";
       grid = grid_of(blank, memory_max))
    blank.resolution *= coarser;
  return blank;
}

bool turns(const channels::ChannelOutput& output) {
  return std::ranges::any_of(output.process.spindles, [](const channels::SpindleSetpoint& spindle) {
    return spindle.id != 0 && std::abs(spindle.rev_per_min) >= standing_rev_per_min;
  });
}

}  // namespace

simulation::ChannelGeometry geometry_of(const channels::MachineConfig& machine,
                                        const channels::ChannelConfig& channel) {
  simulation::ChannelGeometry geometry;
  for (const kinematics::SchemeConfig& scheme : channel.schemes)
    geometry.schemes.emplace(scheme.id, kinematics::make_scheme(scheme));
  geometry.turning_axis = turning_axis(machine, channel);
  return geometry;
}

simulation::ToolRecord record_of(const channels::ToolRow& row) {
  simulation::ToolRecord record;
  simulation::ToolShape& shape = record.shape;
  shape.kind = simulation::tool_kind_named(row.kind.view()).value_or(simulation::ToolKind::flat);
  shape.radius = row.radius + row.wear_radius;
  shape.corner_radius = row.corner_radius;
  shape.flute_length = row.flute_length;
  shape.overhang = row.overhang;
  shape.shank_diameter = row.shank_diameter;
  shape.holder_diameter = row.holder_diameter;
  shape.holder_length = row.holder_length;
  shape.length = row.length;
  shape.point_angle = row.point_angle;
  shape.taper_angle = row.taper_angle;
  shape.orientation = row.orientation;
  shape.angle_front = row.angle_front;
  shape.angle_back = row.angle_back;
  record.mount.nose_to_tip =
      -Vector(row.length_x + row.wear_length_x, row.length_y, row.length + row.wear_length);
  return record;
}

simulation::Pose pose_of(const kinematics::Frame& frame) {
  simulation::Pose pose = simulation::Pose::Identity();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    pose.linear().row(row) = Vector::Map(frame.rotation.rows()[k].data());
    if (frame.geometry[k] < 0) continue;
    pose.translation()[row] = frame.offset[frame.geometry[k]];
  }
  return pose;
}

simulation::ToolRecords tools_of(const channels::TablesConfig& tables) {
  simulation::ToolRecords records;
  for (const channels::ToolEdge& edge : tables.tools)
    records[{edge.number, edge.edge}] = record_of(channels::row_of(edge));
  return records;
}

simulation::Sample sample_of(const channels::ChannelOutput& output, double time_s) {
  simulation::Sample sample;
  sample.time_s = time_s;
  for (std::size_t k = 0; k < output.axes.size(); ++k) sample.axes_M[k] = output.axes[k].position;
  sample.scheme = output.scheme;
  sample.tool = output.tool.number;
  sample.edge = output.tool.edge;
  sample.rapid = output.moving && output.feed_commanded == 0.0;
  sample.spindle_turns = turns(output);
  sample.origin = {output.id, output.tag.run, output.tag.block, output.tag.line, output.tag.file};
  return sample;
}

simulation::Sample sample_of(const setpoint_t& setpoint, double time_s,
                             const channels::ToolAtWork& tool, double spindle_rev_per_min) {
  constexpr unsigned flag_moving = 1U;
  simulation::Sample sample;
  sample.time_s = time_s;
  std::ranges::copy(setpoint.position, sample.axes_M.begin());
  sample.scheme = setpoint.scheme;
  sample.tool = tool.number;
  sample.edge = tool.edge;
  const bool moving = (static_cast<unsigned>(setpoint.flags) & flag_moving) != 0;
  sample.rapid = moving && setpoint.feed_commanded == 0.0;
  sample.spindle_turns = std::abs(spindle_rev_per_min) >= standing_rev_per_min;
  sample.origin = {setpoint.channel, static_cast<std::uint32_t>(setpoint.run),
                   static_cast<std::uint64_t>(setpoint.block),
                   static_cast<std::uint32_t>(setpoint.line),
                   static_cast<std::uint16_t>(setpoint.file)};
  return sample;
}

WorkpieceNews news_of(const channels::Workpiece& workpiece) {
  WorkpieceNews news{workpiece.announcements, workpiece.shapes, {}, {}};
  const auto& shape = workpiece.shape;
  news.blank.blank =
      blank_of(shape.type, shape.size_mm.data(), shape.zero_mm.data(), shape.screen_resolution_mm);
  if (shape.type == type_of_file) read_solid(workpiece, news.blank.blank);
  news.blank.program_in_base = pose_of(workpiece.frame);
  news.placement = {Vector::Map(workpiece.position.position_mm.data()),
                    Vector::Map(workpiece.position.angles_deg.data())};
  return news;
}

WorkpieceNews news_of(const workpiece_t& message) {
  WorkpieceNews news{static_cast<std::uint32_t>(message.announcements),
                     static_cast<std::uint32_t>(message.shapes),
                     {},
                     {}};
  news.blank.blank = blank_of(message.shape, message.size, message.zero, message.screen_resolution);
  if (message.shape == type_of_file) news.blank.blank.unknown_because = not_in_messages;
  for (Eigen::Index row = 0; row < 3; ++row)
    news.blank.program_in_base.linear().row(row) = Vector::Map(message.rotation + 3 * row);
  news.blank.program_in_base.translation() = Vector::Map(message.offset);
  news.placement = {Vector::Map(message.position), Vector::Map(message.angles)};
  return news;
}

ChannelFeed::ChannelFeed(const channels::MachineConfig& machine,
                         const channels::ChannelConfig& channel, std::uint64_t memory_max,
                         simulation::WorkpieceFollower::Complaint complain)
    : channel_(channel.id),
      tables_(machine.tables),
      memory_max_(memory_max),
      follower_(geometry_of(machine, channel), tools_of(machine.tables), memory_max,
                std::move(complain)) {}

void ChannelFeed::take_real_tools(const std::vector<config::RealTool>& tools) {
  const auto put = [](double real, double& value) {
    if (real != config::RealTool::as_table) value = real;
  };
  for (const config::RealTool& real : tools) {
    for (channels::ToolEdge edge : tables_.tools) {
      if (edge.number != real.number || edge.edge != real.edge) continue;
      if (real.radius != config::RealTool::as_table) edge.wear_radius = 0.0;
      if (real.length != config::RealTool::as_table) edge.wear_length = 0.0;
      if (real.length_x != config::RealTool::as_table) edge.wear_length_x = 0.0;
      put(real.length, edge.length);
      put(real.length_x, edge.length_x);
      put(real.length_y, edge.length_y);
      put(real.radius, edge.radius);
      follower_.change_tool(real.number, real.edge, record_of(channels::row_of(edge)));
      real_tools_.emplace_back(real.number, real.edge);
    }
  }
}

void ChannelFeed::hear_of_tool(const channels::ToolRow& row) {
  if (row == tool_row_) return;
  tool_row_ = row;
  if (std::ranges::find(real_tools_, std::pair{row.number, row.edge}) != real_tools_.end()) return;
  if (row.number != 0) follower_.change_tool(row.number, row.edge, record_of(row));
}

void ChannelFeed::take(const simulation::Sample& sample, const channels::ToolRow& tool,
                       const channels::Workpiece& workpiece) {
  hear_of_tool(tool);
  if (!has_heard(workpiece.announcements)) hear(news_of(workpiece), sample);
  follow(sample);
}

void ChannelFeed::hear(const WorkpieceNews& news, const simulation::Sample& now) {
  const std::uint32_t all = news.announcements - announcements_;
  const std::uint32_t shapes = news.shapes - shapes_;
  announcements_ = news.announcements;
  shapes_ = news.shapes;
  if (shapes != 0) {
    simulation::Announcement announcement = news.blank;
    if (takes_what_fits_) announcement.blank = fitting(announcement.blank, memory_max_);
    follower_.announce(announcement, now);
  }
  if (all > shapes) follower_.place(news.placement, now);
}

}  // namespace stanok::runtime

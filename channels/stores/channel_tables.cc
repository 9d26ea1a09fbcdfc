#include "channels/stores/channel_tables.h"

#include "kinematics/carried_point.h"

namespace stanok::channels {
namespace {

kinematics::FirstAngle first_angle(lang::FirstRotary wanted) {
  switch (wanted) {
    case lang::FirstRotary::positive:
      return kinematics::FirstAngle::positive;
    case lang::FirstRotary::negative:
      return kinematics::FirstAngle::negative;
    case lang::FirstRotary::nearest:
      break;
  }
  return kinematics::FirstAngle::any;
}

lang::Alignment::Outcome alignment_outcome(kinematics::DirectionChoice::Outcome outcome) {
  using From = kinematics::DirectionChoice::Outcome;
  using To = lang::Alignment::Outcome;
  switch (outcome) {
    case From::found:
      return To::found;
    case From::out_of_reach:
      return To::out_of_reach;
    case From::beyond_limit:
      return To::beyond_limit;
    case From::wrong_sign:
      return To::wrong_sign;
    case From::no_rotary_axes:
      break;
  }
  return To::no_rotary_axes;
}

}  // namespace

kinematics::ToolRow row_of(const lang::ToolLength& length) {
  using Row = lang::ToolLength::Row;
  kinematics::ToolRow row;
  if (length.row == Row::none) return row;
  return {.tool = length.tool,
          .edge = length.edge,
          .sign = length.row == Row::subtracted ? -1 : 1,
          .version = length.version};
}

ChannelTables::ChannelTables(LiveTables& live, const MachineConfig& machine,
                             const ChannelConfig& channel, Ring<kinematics::LengthChange>* lengths)
    : live_(live), view_(live), lengths_to_come_(lengths), channel_(channel.id) {
  for (const int axis : channel.axes) {
    const AxisConfig& config = machine.axes[axis];
    axis_names_.push_back(config.name);
    travel_.push_back({config.limits.position_min, config.limits.position_max});
  }
}

void ChannelTables::advance_to(std::uint64_t version) {
  view_.advance_to(version);
  if (lengths_to_come_ == nullptr) return;
  Ring<kinematics::LengthChange>& lengths = *lengths_to_come_;
  while (!lengths.empty() && lengths.front().version <= view_.version()) {
    length_changes_.note(lengths.front());
    lengths.pop_front();
  }
}

lang::ToolLength ChannelTables::in_force(const lang::ToolLength& length) const {
  const kinematics::ToolRow row = row_of(length);
  if (!length_changes_.concern(row)) return length;
  lang::ToolLength now = length;
  now.offset_mm = components(vector3(length.offset_mm) + length_changes_.since(row));
  now.version = view_.version();
  return now;
}

void ChannelTables::set_scheme(const kinematics::Scheme& scheme) {
  scheme_ = &scheme;
  reading_ = {};
  const lang::AxisValues per_mm = kinematics::reading_per_mm(scheme.config());
  for (std::size_t k = 0; k < axis_names_.size(); ++k) {
    if (!scheme.takes_part(static_cast<int>(k))) continue;
    reading_.zero[k] = scheme.config().zero[k];
    reading_.per_mm[k] = per_mm[k];
  }
  axes_of_scheme_ = static_cast<lang::AxisSet>(scheme.participants());
}

// Angles of B are those of the axes without the zero of the scheme.
lang::Alignment ChannelTables::alignment(const lang::AlignmentWish& wish) const {
  lang::Alignment answer;
  if (scheme_ == nullptr) return answer;
  kinematics::DirectionWish asked;
  asked.tool_B = vector3(wish.tool_B);
  asked.from_B = {wish.from_B};
  asked.first = first_angle(wish.first);
  for (std::size_t k = 0; k < travel_.size(); ++k) {
    asked.travel[k] = {travel_[k].min_deg - reading_.zero[k],
                       travel_[k].max_deg - reading_.zero[k]};
  }
  const kinematics::DirectionChoice choice = kinematics::choose_direction(*scheme_, asked);
  answer.outcome = alignment_outcome(choice.outcome);
  if (answer.outcome == lang::Alignment::Outcome::no_rotary_axes) return answer;
  answer.angles_B = wish.from_B;
  for (std::size_t k = 0; k < choice.axes.size(); ++k) {
    answer.axes = static_cast<lang::AxisSet>(answer.axes | choice.axes[k].bit());
    answer.angles_B[choice.axes[k]] = choice.angles_deg[k];
  }
  answer.nearest_B = components(choice.nearest_B);
  answer.off_deg = choice.off_deg;
  if (!choice.axis.exists()) return answer;
  answer.axis = choice.axis;
  answer.needed_deg = choice.needed_deg + reading_.zero[choice.axis];
  answer.limit_deg = choice.limit_deg + reading_.zero[choice.axis];
  return answer;
}

lang::AxisSet ChannelTables::leading_axes() const {
  return scheme_ == nullptr ? Tables::leading_axes()
                            : static_cast<lang::AxisSet>(scheme_->leading_axes());
}

std::optional<lang::AxisValues> ChannelTables::carried_by_table(
    const lang::AxisValues& point_B, const lang::AxisValues& position_B) const {
  if (scheme_ == nullptr) return std::nullopt;
  return kinematics::carried_point(*scheme_, point_B, position_B);
}

std::array<lang::Direction, 3> ChannelTables::spindle_axes(
    const lang::AxisValues& position_B) const {
  if (scheme_ == nullptr) return Tables::spindle_axes(position_B);
  const auto axes = scheme_->spindle_axes({position_B});
  return {components(axes[0]), components(axes[1]), components(axes[2])};
}

std::optional<lang::AxisValues> ChannelTables::work_offset(int number) const {
  lang::AxisValues values{};
  for (std::size_t k = 0; k < axis_names_.size(); ++k) {
    const auto value = view_.offset(number, axis_names_[k]);
    if (!value) return std::nullopt;
    values[k] = *value;
  }
  return values;
}

// Beside the axes of its row, under the word of G10 L2.
double ChannelTables::work_offset_rotation(int number) const {
  return view_.offset(number, std::string("R")).value_or(0.0);
}

lang::AxisValues ChannelTables::reference_point(int which) const {
  lang::AxisValues point{};
  for (std::size_t k = 0; k < axis_names_.size(); ++k)
    point[k] = live_.reference_point(channel_, which, axis_names_[k]);
  return point;
}

void ChannelTables::store_reference_point(int which, const lang::AxisValues& point_M) {
  for (std::size_t k = 0; k < axis_names_.size(); ++k)
    live_.store_reference_point(channel_, which, axis_names_[k], point_M[k]);
}

std::optional<lang::Tool> ChannelTables::tool(int number) const {
  return tool_edge(number, 1);
}

std::optional<lang::Tool> ChannelTables::tool_edge(int number, int edge_number) const {
  const auto edge = view_.tool(number, edge_number);
  if (!edge) return std::nullopt;
  lang::Tool tool;
  tool.number = number;
  tool.length_mm = {edge->length_x + edge->wear_length_x, edge->length_y,
                    edge->length + edge->wear_length};
  tool.radius_mm = edge->radius + edge->wear_radius;
  tool.overhang_mm = edge->overhang;
  tool.wear_mm = {edge->wear_length_x, 0.0, edge->wear_length};
  tool.orientation = edge->orientation;
  return tool;
}

}  // namespace stanok::channels

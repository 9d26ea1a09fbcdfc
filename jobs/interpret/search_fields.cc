// The record about a block search.
#include <algorithm>

#include "jobs/interpret/axis_fields.h"
#include "jobs/interpret/feed_law_fields.h"
#include "jobs/interpret/record_fields.h"

namespace stanok::jobs {
namespace {

FieldList spindles_found(const lang::SearchState& state) {
  return field_list(state.spindles, [&](const auto& of_spindle) {
    const auto& [id, spindle] = of_spindle;
    const auto speed = state.speeds.find(id);
    return Fields{{"spindle", count_field(id)},
                  {"action", text_field(spindle_action_names[spindle.action])},
                  {"speed_rev_per_min", speed == state.speeds.end() ? 0.0 : speed->second}};
  });
}

FieldList omissions_found(const lang::SearchState& state) {
  return field_list(state.omissions, [](const auto& omission) {
    return Fields{{"what", text_field(omission.what)},
                  {"count", count_field(omission.count)},
                  {"first_line", count_field(omission.first.line)}};
  });
}

}  // namespace

Fields search_fields(const lang::SearchState& state, const lang::Origin& target,
                     const Words& words) {
  Fields fields{{"line", count_field(target.line)},
                {"kind", "search"},
                {"file", count_field(target.file)},
                {"calculated", state.calculated}};
  if (!state.calculated) return fields;
  motion::Point position{};
  std::copy(state.position_W.begin(), state.position_W.end(), position.begin());
  const auto add = [&](const char* name, FieldValue value) {
    fields.push_back({name, std::move(value)});
  };
  add("position", axis_fields(words, position));
  add("work_offset", count_field(state.frame.work_offset));
  add("tool", count_field(state.tool));
  add("tool_prepared", count_field(state.tool_prepared));
  add("length", number_list(state.length.offset_mm));
  add("spindles", spindles_found(state));
  add("mist", state.coolant.mist);
  add("flood", state.coolant.flood);
  add("feed_law", feed_law_fields(state.feed_law));
  add("not_executed", omissions_found(state));
  return fields;
}

}  // namespace stanok::jobs

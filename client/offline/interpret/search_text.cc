// The line about a block search.
#include <algorithm>

#include "client/offline/interpret/feed_law_text.h"
#include "client/offline/interpret/record_parts.h"
#include "client/offline/interpret/record_text.h"

namespace stanok::client {
namespace {

void append_spindles(std::string& text, const lang::SearchState& state) {
  text += R"(,"spindles":[)";
  const char* comma = "";
  for (const auto& [id, spindle] : state.spindles) {
    const auto speed = state.speeds.find(id);
    append(text, R"({}{{"spindle":{},"action":"{}","speed_rev_per_min":{}}})", comma, id,
           spindle_action_names[spindle.action], speed == state.speeds.end() ? 0.0 : speed->second);
    comma = ",";
  }
  text += ']';
}

void append_omissions(std::string& text, const lang::SearchState& state) {
  text += R"(,"not_executed":[)";
  const char* comma = "";
  for (const auto& omission : state.omissions) {
    append(text, R"({}{{"what":"{}","count":{},"first_line":{}}})", comma, omission.what,
           omission.count, omission.first.line);
    comma = ",";
  }
  text += ']';
}

}  // namespace

void append_search(std::string& text, const lang::SearchState& state, const lang::Origin& target,
                   const Words& words) {
  append(text, R"({{"line":{},"kind":"search","file":{},"calculated":{})", target.line, target.file,
         state.calculated);
  if (state.calculated) {
    motion::Point position{};
    std::copy(state.position_W.begin(), state.position_W.end(), position.begin());
    text += R"(,"position":)";
    append_axes(text, words, position);
    append(text, R"(,"work_offset":{},"tool":{},"tool_prepared":{},"length":[{}])",
           state.frame.work_offset, state.tool, state.tool_prepared,
           fmt::join(state.length.offset_mm, ","));
    append_spindles(text, state);
    append(text, R"(,"mist":{},"flood":{})", state.coolant.mist, state.coolant.flood);
    text += R"(,"feed_law":)";
    append_feed_law(text, state.feed_law);
    append_omissions(text, state);
  }
  text += "}\n";
}

}  // namespace stanok::client

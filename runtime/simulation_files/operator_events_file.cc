#include "runtime/simulation_files/operator_events_file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "protocol/contract/json_rpc.h"
#include "protocol/contract/machine_request.h"
#include "runtime/operator_request.h"

namespace stanok::runtime {
namespace {

using nlohmann::json;

TimedEvent event_of_line(const json& line) {
  const std::string name = line.at("method").get<std::string>();
  const protocol::Method* method = protocol::find_method(name);
  if (method == nullptr || method->action.empty()) {
    throw std::invalid_argument("'" + name + "' is no method that enters the cycle");
  }
  const json parameters = line.contains("params") ? line.at("params") : json::object();
  const auto checked = protocol::checked_parameters(*method, parameters);
  if (!checked) throw std::invalid_argument(checked.error().message);
  const auto event = operator_event(protocol::machine_request(*method, *checked));
  if (!event) throw std::invalid_argument("'" + name + "' is not supported in a simulation");
  return {.cycle = line.at("cycle").get<std::int64_t>(), .event = *event};
}

}  // namespace

TimedEvent timed_event(std::string_view text) {
  const json event = protocol::json_from_text(text);
  if (event.is_discarded()) throw std::invalid_argument("the line is not a JSON text");
  return event_of_line(event);
}

void sort_events(std::vector<TimedEvent>& events) {
  std::ranges::stable_sort(events, {}, &TimedEvent::cycle);
}

std::vector<TimedEvent> read_operator_events(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<TimedEvent> events;
  std::string text;
  for (int line = 1; std::getline(file, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      events.push_back(timed_event(text));
    } catch (const std::exception& reason) {
      throw std::runtime_error(path + ":" + std::to_string(line) + ": " + reason.what());
    }
  }
  sort_events(events);
  return events;
}

}  // namespace stanok::runtime

// Logs for Python: what is in them, and their setpoints and events, some at a time.
//
// A cursor reads the file once from its begin and holds a window of it and what was asked for: how
// long the log is does not matter.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "jobs/logs/log_fields.h"
#include "jobs/logs/situation_fields.h"
#include "protocol/contract/fields_json.h"
#include "protocol/contract/json_text.h"
#include "python/native/bindings.h"
#include "python/native/faults.h"
#include "python/native/setpoint_columns.h"
#include "recording/format/decode.h"
#include "recording/format/encode.h"
#include "recording/read/event_walk.h"
#include "recording/read/log_contents.h"
#include "recording/read/situation_walk.h"

namespace stanok::python {
namespace {

namespace py = pybind11;
using nlohmann::ordered_json;

template <class Value>
Value value_or_raise(Expected<Value, recording::LogError> result) {
  if (result) return std::move(*result);
  raise("LogError", ordered_json::array({fault_json("", result.error().text)}));
}

// A file that was read once, to know what is in it.
struct Log {
  std::filesystem::path file;
  recording::LogContents contents;
};
using LogHandle = std::shared_ptr<const Log>;

LogHandle open_log(const std::filesystem::path& file) {
  Expected<recording::LogContents, recording::LogError> contents =
      Unexpected<recording::LogError>(recording::LogError{});
  {
    const py::gil_scoped_release others_run;
    contents = recording::read_contents(file);
  }
  return std::make_shared<const Log>(
      Log{.file = file, .contents = value_or_raise(std::move(contents))});
}

ordered_json axes_json(const Log& log, int channel) {
  ordered_json list = ordered_json::array();
  const auto* const described = recording::description_of(log.contents, channel);
  if (described == nullptr) return list;
  for (const recording::AxisDescription& axis : described->axes)
    list.push_back({axis.name, axis.word, axis.rotary ? "deg" : "mm"});
  return list;
}

// As `stanok log info --json`, and the axes of each channel with setpoints.
std::string contents_text(const Log& log) {
  ordered_json json = {{"info", protocol::fields_json(jobs::log_fields(log.contents))},
                       {"axes", ordered_json::object()}};
  for (const auto& [channel, name] : log.contents.setpoint_channels)
    json["axes"][std::to_string(channel)] = axes_json(log, channel);
  json["sound"] = log.contents.is_sound();
  json["cut"] = log.contents.is_cut();
  return protocol::json_text(json);
}

class SetpointCursor {
 public:
  SetpointCursor(LogHandle log, int channel, const std::vector<std::string>& columns)
      : log_(std::move(log)),
        columns_(columns),
        reader_(value_or_raise(recording::LogReader::open(log_->file))) {
    const auto name = log_->contents.setpoint_channels.find(channel);
    if (name == log_->contents.setpoint_channels.end()) {
      std::string known;
      for (const auto& [number, unused] : log_->contents.setpoint_channels)
        known += (known.empty() ? "" : ", ") + std::to_string(number);
      throw std::invalid_argument("the log has no setpoints of channel " + std::to_string(channel) +
                                  "; it has those of " + (known.empty() ? "none" : known));
    }
    name_ = name->second;
  }

  // The next `rows` at most; no array at the end of the log.
  [[nodiscard]] py::dict next(std::int64_t rows) {
    {
      const py::gil_scoped_release others_run;
      while (columns_.rows() < rows) {
        const auto event = reader_.next();
        if (!event) break;
        if (event->channel != name_) continue;
        const auto message = recording::decode<setpoint_t>(event->bytes);
        if (!message) continue;
        const std::int64_t since_first = message->utime - log_->contents.utime_first;
        columns_.add(*message, static_cast<double>(since_first) * 1e-6);
      }
    }
    return columns_.rows() == 0 ? py::dict() : columns_.take();
  }

 private:
  LogHandle log_;
  SetpointColumns columns_;
  recording::LogReader reader_;
  std::string name_;
};

class EventCursor {
 public:
  explicit EventCursor(LogHandle log)
      : log_(std::move(log)), events_(value_or_raise(recording::EventWalk::open(log_->file))) {}

  // The next `count` at most, as a list of JSON.
  [[nodiscard]] std::string next(std::int64_t count) {
    const py::gil_scoped_release others_run;
    ordered_json list = ordered_json::array();
    while (static_cast<std::int64_t>(list.size()) < count) {
      const auto named = events_.next();
      if (!named) break;
      list.push_back(json_of(*named));
    }
    return protocol::json_text(list);
  }

 private:
  [[nodiscard]] ordered_json json_of(const recording::NamedEvent& named) const {
    const event_t& event = named.event;
    const std::int64_t since_first = event.utime - log_->contents.utime_first;
    return {{"cycle", event.cycle},
            {"time_s", static_cast<double>(since_first) * 1e-6},
            {"channel", event.channel},
            {"code", std::string(recording::text_of(event.code))},
            {"text", std::string(recording::text_of(event.text))},
            {"file", named.file},
            {"line", event.line}};
  }

  LogHandle log_;
  recording::EventWalk events_;
};

class SituationCursor {
 public:
  SituationCursor(LogHandle log, int channel)
      : log_(std::move(log)),
        situations_(value_or_raise(recording::SituationWalk::open(log_->file, channel))) {}

  // The next `count` at most, as a list of JSON.
  [[nodiscard]] std::string next(std::int64_t count) {
    const py::gil_scoped_release others_run;
    ordered_json list = ordered_json::array();
    while (static_cast<std::int64_t>(list.size()) < count) {
      const auto situation = situations_.next();
      if (!situation) break;
      list.push_back(protocol::fields_json(jobs::situation_fields(*situation, log_->contents)));
    }
    return protocol::json_text(list);
  }

 private:
  LogHandle log_;
  recording::SituationWalk situations_;
};

}  // namespace

void bind_logs(py::module_& module) {
  py::class_<Log, std::shared_ptr<Log>>(module, "Log")
      .def(py::init([](const std::filesystem::path& file) {
             return std::const_pointer_cast<Log>(open_log(file));
           }),
           py::arg("file"))
      .def("contents", &contents_text);
  py::class_<SetpointCursor>(module, "SetpointCursor")
      .def(py::init<std::shared_ptr<Log>, int, std::vector<std::string>>(), py::arg("log"),
           py::arg("channel"), py::arg("columns"))
      .def("next", &SetpointCursor::next, py::arg("rows"));
  py::class_<EventCursor>(module, "EventCursor")
      .def(py::init<std::shared_ptr<Log>>(), py::arg("log"))
      .def("next", &EventCursor::next, py::arg("count"));
  py::class_<SituationCursor>(module, "SituationCursor")
      .def(py::init<std::shared_ptr<Log>, int>(), py::arg("log"), py::arg("channel"))
      .def("next", &SituationCursor::next, py::arg("count"));
}

}  // namespace stanok::python

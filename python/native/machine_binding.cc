// Machine files for Python.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "protocol/contract/json_text.h"
#include "protocol/contract/version.h"
#include "python/native/bindings.h"
#include "python/native/machine_handle.h"

namespace stanok::python {
namespace {

namespace py = pybind11;
using nlohmann::ordered_json;

ordered_json channel_json(const channels::MachineConfig& machine,
                          const channels::ChannelConfig& channel) {
  ordered_json json = {{"id", channel.id}, {"name", channel.name}, {"words", channel.words}};
  json["axes"] = ordered_json::array();
  json["units"] = ordered_json::array();
  for (const int axis : channel.axes) {
    json["axes"].push_back(machine.axes[axis].name);
    json["units"].push_back(machine.axes[axis].rotary ? "deg" : "mm");
  }
  json["scheme"] = channel.scheme;
  json["schemes"] = ordered_json::array();
  for (const kinematics::SchemeConfig& scheme : channel.schemes)
    json["schemes"].push_back({{"id", scheme.id}, {"type", scheme.type}, {"file", scheme.file}});
  return json;
}

ordered_json axis_json(const channels::AxisConfig& axis) {
  return {{"name", axis.name},
          {"unit", axis.rotary ? "deg" : "mm"},
          {"position_min", axis.limits.position_min},
          {"position_max", axis.limits.position_max},
          {"velocity_max", axis.limits.velocity_max},
          {"acceleration_max", axis.limits.acceleration_max},
          {"jerk_max", axis.limits.jerk_max},
          {"stop_limits", axis.limits.stop_limits}};
}

std::string description(const config::MachineFile& file) {
  const channels::MachineConfig& machine = file.machine;
  ordered_json json = {{"name", machine.name}, {"cycle_s", machine.cycle_us * 1e-6}};
  json["channels"] = ordered_json::array();
  for (const auto& channel : machine.channels)
    json["channels"].push_back(channel_json(machine, channel));
  json["axes"] = ordered_json::array();
  for (const auto& axis : machine.axes) json["axes"].push_back(axis_json(axis));
  return protocol::json_text(json);
}

}  // namespace

const channels::ChannelConfig& channel_of(const config::MachineFile& machine, int channel) {
  std::string known;
  for (const channels::ChannelConfig& one : machine.machine.channels) {
    if (one.id == channel) return one;
    known += (known.empty() ? "" : ", ") + std::to_string(one.id);
  }
  throw std::invalid_argument("machine " + machine.machine.name + " has no channel " +
                              std::to_string(channel) + "; it has " + known);
}

void bind_machine(py::module_& module) {
  py::class_<config::MachineFile, std::shared_ptr<config::MachineFile>>(module, "Machine")
      .def(py::init([](const std::filesystem::path& path) {
             return std::make_shared<config::MachineFile>(config::read_machine_file(path));
           }),
           py::arg("path"), py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("path", [](const config::MachineFile& file) { return file.path; })
      .def("description", &description);
  module.def("version", [] { return std::string(protocol::version); });
}

}  // namespace stanok::python

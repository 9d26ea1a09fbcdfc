// What `drive list` and `drive status` say.
#include "daemon/report/drive_report.h"

#include "base/enum_names.h"
#include "drives/modbus/exchange_plan.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

constexpr auto bus_names = enum_names<drives::BusKind>({
    {drives::BusKind::none, "none"},
    {drives::BusKind::modbus_tcp, "modbus-tcp"},
    {drives::BusKind::modbus_rtu, "modbus-rtu"},
});

constexpr auto drive_kind_names = enum_names<drives::DriveKind>({
    {drives::DriveKind::position, "position"},
    {drives::DriveKind::velocity, "velocity"},
    {drives::DriveKind::on_off, "on_off"},
});

json counts_of(const drives::ErrorCounts& errors) {
  json counts = json::object();
  for (const auto error : enum_values<drives::ExchangeError>())
    counts[std::string(drives::name_of(error))] = errors[error];
  return counts;
}

json drive_of(const drives::AxisBusStatus& status) {
  const drives::DriveFeedback& feedback = status.feedback;
  return {{"axis", status.axis},
          {"state", drives::name_of(feedback.state)},
          {"in_contact", status.in_contact},
          {"fault_code", feedback.fault_code},
          {"position", feedback.position},
          {"velocity", feedback.velocity},
          {"following_error", feedback.following_error},
          {"power_w", feedback.power_w},
          {"vibration_um", feedback.vibration_um},
          {"vibration_hz", feedback.vibration_hz},
          {"temperature_c", feedback.temperature_c},
          {"referenced", feedback.referenced},
          {"brake_closed", feedback.brake_closed},
          {"home_switch", feedback.home_switch},
          {"limit_negative", feedback.limit_negative},
          {"limit_positive", feedback.limit_positive},
          {"index_position", feedback.index_position},
          {"index_count", feedback.index_count},
          {"losses", feedback.losses},
          {"answers", status.answers},
          {"errors", status.errors},
          {"errors_by_kind", counts_of(status.errors_by_kind)}};
}

json vibration_of(const drives::VibrationStatus& status) {
  return {{"sensor", status.sensor},
          {"amplitude_um", status.level.amplitude_um},
          {"frequency_hz", status.level.frequency_hz},
          {"synchronous_um", status.level.synchronous_um},
          {"samples", status.samples},
          {"lost", status.lost},
          {"errors", status.errors}};
}

}  // namespace

json drive_list(const RunningMachine& machine) {
  const drives::BusConfig& bus = machine.file().bus;
  json list = json::array();
  for (const drives::AxisDriveConfig& drive : drives::drives_of(bus)) {
    list.push_back(
        {{"axis", drive.axis},
         {"unit", drive.unit},
         {"kind", drive_kind_names[drive.kind]},
         {"requests", drives::exchange_plan(drive).size()},
         {"watchdog_ms", drive.watchdog_ms == 0 ? json(nullptr) : json(drive.watchdog_ms)},
         {"absolute_encoder", drive.absolute_encoder},
         {"position_scale", drive.map.position.scale},
         {"velocity_scale", drive.map.velocity.scale}});
  }
  return {{"bus", bus_names[bus.kind]},
          {"poll_ms", bus.poll_ms},
          {"timeout_ms", bus.timeout_ms},
          {"drives", std::move(list)}};
}

json drive_status(RunningMachine& machine) {
  const drives::BusStatus bus = machine.drive_status();
  json axes = json::array();
  for (const drives::AxisBusStatus& axis : bus.axes) axes.push_back(drive_of(axis));
  json vibration = json::array();
  for (const drives::VibrationStatus& sensor : bus.vibration)
    vibration.push_back(vibration_of(sensor));
  return {{"choice", machine.drive_choice()},
          {"endpoint", bus.endpoint.empty() ? json(nullptr) : json(bus.endpoint)},
          {"connected", bus.connected},
          {"connections", bus.connections},
          {"exchanges", bus.exchanges},
          {"errors", counts_of(bus.errors)},
          {"own_fault", bus.own_fault.empty() ? json(nullptr) : json(bus.own_fault.view())},
          {"round_trip_us",
           {{"p50", bus.round_trip.p50_us},
            {"p90", bus.round_trip.p90_us},
            {"p99", bus.round_trip.p99_us},
            {"p999", bus.round_trip.p999_us},
            {"max", bus.round_trip.max_us}}},
          {"vibration", std::move(vibration)},
          {"axes", std::move(axes)}};
}

}  // namespace stanok::daemon

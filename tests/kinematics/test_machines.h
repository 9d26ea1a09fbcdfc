// One machine or more of every type of scheme, complete and with all constants different from
// zero, each with its independent reference; random poses for them.
#pragma once

#include <functional>
#include <ostream>
#include <random>
#include <vector>

#include "kinematics/scheme.h"
#include "tests/kinematics/foreign_schemes.h"
#include "tests/kinematics/reference.h"

namespace stanok::kinematics {

struct TestMachine {
  std::string name;
  SchemeConfig config;  // five axes X Y Z B C
  // Machine axes of a point in PointMode::tip.
  reference::Axes (*tip)(const SchemeConfig&, const reference::Axes&, const reference::Vector&);
  // And in PointMode::axes.
  reference::Axes (*axes)(const SchemeConfig&, const reference::Axes&, const reference::Vector&);
  std::function<std::unique_ptr<const Scheme>(const SchemeConfig&)> make = make_scheme;
  double span_mm = 300.0;  // of the random poses

  [[nodiscard]] std::unique_ptr<const Scheme> scheme() const { return make(config); }
};

inline void PrintTo(const TestMachine& machine, std::ostream* stream) {
  *stream << machine.name;
}

namespace test_machine {

inline SchemeConfig config_of(const std::string& type) {
  SchemeConfig config;
  config.id = 1;
  config.type = type;
  config.axes = {0, 1, 2, 3, 4};
  config.zero = {12.5, -40.25, 7.75, 1.5, -30.0};
  config.linear = {0, 1, 2};
  return config;
}

inline SchemeConfig head_table(const Vector3<double>& head, const Vector3<double>& table) {
  SchemeConfig config = config_of("head_table");
  config.geometry = HeadTable::Geometry{.head_axis = 3,
                                        .table_axis = 4,
                                        .head_vector = head,
                                        .table_vector = table,
                                        .pivot_to_spindle = {0.5, -0.25, -200.0},
                                        .table_centre = {10.0, 20.0, -400.0}};
  return config;
}

// C about Z carries a fork that tilts about an oblique axis.
inline SchemeConfig head_head() {
  SchemeConfig config = config_of("head_head");
  config.geometry = HeadHead::Geometry{.outer_axis = 4,
                                       .inner_axis = 3,
                                       .outer_vector = {0.0, 0.0, 1.0},
                                       .inner_vector = {0.6, 0.8, 0.0},
                                       .pivot_to_pivot = {3.0, -45.0, -120.0},
                                       .pivot_to_spindle = {0.5, 12.0, -180.0}};
  return config;
}

// A trunnion that rocks about X and carries a plate out of square.
inline SchemeConfig table_table() {
  SchemeConfig config = config_of("table_table");
  config.geometry = TableTable::Geometry{.outer_axis = 3,
                                         .inner_axis = 4,
                                         .outer_vector = {1.0, 0.0, 0.0},
                                         .inner_vector = {0.0, 0.28, 0.96},
                                         .table_centre = {-15.0, 30.0, -420.0},
                                         .centre_to_centre = {0.125, -25.0, 55.0}};
  return config;
}

inline SchemeConfig lathe(XReading x_reading, Turret turret) {
  SchemeConfig config = config_of("lathe");
  config.geometry = Lathe::Geometry{.x_reading = x_reading, .turret = turret};
  return config;
}

template <class Type>
std::unique_ptr<const Scheme> make_foreign(const SchemeConfig& config) {
  return std::make_unique<const Type>(config);
}

inline TestMachine turned_machine(const char* name, const SchemeConfig& config) {
  using Map =
      reference::Axes (*)(const SchemeConfig&, const reference::Axes&, const reference::Vector&);
  const Map map = config.type == "polar_face" ? reference::polar_face
                  : config.type == "cylinder" ? reference::cylinder
                                              : static_cast<Map>(reference::lathe);
  return {.name = name, .config = config, .tip = map, .axes = map};
}

}  // namespace test_machine

inline const std::vector<TestMachine>& test_machines() {
  using namespace test_machine;  // NOLINT: the helpers of this list
  using reference::shifted;
  constexpr double half_root = 0.70710678118654752;
  const SchemeConfig rear = lathe(XReading::radius, Turret::rear);
  const SchemeConfig front = lathe(XReading::diameter, Turret::front);
  static const std::vector<TestMachine> all = {
      {"cartesian", config_of("cartesian"), shifted, shifted},
      {"head_table", head_table({0, 1, 0}, {0, 0, 1}), reference::head_table, shifted},
      {"head_table_oblique", head_table({0, half_root, half_root}, {0.48, 0.6, 0.64}),
       reference::head_table, shifted},
      {"head_head", head_head(), reference::head_head, shifted},
      {"table_table", table_table(), reference::table_table, shifted},
      turned_machine("lathe", rear),
      turned_machine("lathe_front_diameter", front),
      turned_machine("polar_face_of_a_mill",
                     face_scheme(config_of("cartesian"), 4, FaceSide::positive)),
      turned_machine("polar_face", face_scheme(rear, 4, FaceSide::positive)),
      turned_machine("polar_face_negative", face_scheme(front, 3, FaceSide::negative)),
      turned_machine("cylinder", cylinder_scheme(rear, 4, 24.5)),
      turned_machine("cylinder_front_diameter", cylinder_scheme(front, 3, 310.0)),
      {"belt_gantry", config_of("belt_gantry"), reference::belt_gantry, reference::belt_gantry,
       make_foreign<BeltGantry>},
      {"linear_delta", config_of("linear_delta"), reference::linear_delta, reference::linear_delta,
       make_foreign<LinearDelta>, 100.0},
  };
  return all;
}

// Random points, tools and frames. Every place of a point may hold a length, an angle of several
// turns, or (polar_face, cylinder) a length where other types have an angle.
class Poses {
 public:
  explicit Poses(const TestMachine& machine, unsigned seed)
      : engine_(seed), millimetres_(-machine.span_mm, machine.span_mm) {}

  AxisVector<double> next() {
    AxisVector<double> pose{};
    for (std::size_t axis = 0; axis < 3; ++axis) pose[axis] = millimetres_(engine_);
    for (std::size_t axis = 3; axis < axes_max; ++axis) pose[axis] = degrees_(engine_);
    return pose;
  }
  ToolVector tool() {
    return {{millimetres_(engine_) / 10.0, millimetres_(engine_) / 10.0, millimetres_(engine_)}};
  }
  Frame frame() {
    Frame frame;
    frame.offset = next();
    const Vector3<double> axis{millimetres_(engine_), millimetres_(engine_), millimetres_(engine_)};
    frame.rotation = Rotation::about(axis, degrees_(engine_));
    return frame;
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> millimetres_;
  std::uniform_real_distribution<double> degrees_{-400.0, 400.0};
};

}  // namespace stanok::kinematics

// Kinematic schemes of a channel on arrays of points.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>

#include "kinematics/scheme.h"
#include "python/native/array_rows.h"
#include "python/native/bindings.h"
#include "python/native/machine_handle.h"

namespace stanok::python {
namespace {

namespace py = pybind11;
using kinematics::AxisVector;
using kinematics::Jet;

// How points are programmed, besides the scheme.
struct Setting {
  bool leads_tip = false;                       // G43.4
  std::array<double, 3> nose_to_tip_mm{};       // of the tool
  std::vector<double> offset;                   // of the workpiece, by axis; empty: zero
  std::vector<std::array<double, 4>> rotation;  // axis and angle in deg, the first one first
};

const kinematics::SchemeConfig& scheme_of(const channels::ChannelConfig& channel, int id) {
  std::string known;
  for (const kinematics::SchemeConfig& scheme : channel.schemes) {
    if (scheme.id == id) return scheme;
    known += (known.empty() ? "" : ", ") + std::to_string(scheme.id);
  }
  throw std::invalid_argument("channel " + std::to_string(channel.id) +
                              " has no kinematic scheme " + std::to_string(id) + "; it has " +
                              known);
}

Rotation rotation_of(const std::vector<std::array<double, 4>>& turns) {
  Rotation rotation;
  for (const auto& [x, y, z, angle_deg] : turns) {
    const Vector3<double> axis(x, y, z);
    if (!(axis.norm() > 0.0)) throw std::invalid_argument("an axis of rotation has no length");
    rotation = Rotation::about(axis, angle_deg) * rotation;
  }
  return rotation;
}

class Kinematics {
 public:
  Kinematics(const config::MachineFile& machine, int channel, int scheme, const Setting& setting)
      : axis_count_(static_cast<int>(channel_of(machine, channel).axes.size())),
        scheme_(kinematics::make_scheme(scheme_of(channel_of(machine, channel), scheme))) {
    if (scheme_ == nullptr) throw std::invalid_argument("the scheme is not valid");
    transform_.scheme = scheme_.get();
    transform_.mode = setting.leads_tip ? kinematics::PointMode::tip : kinematics::PointMode::axes;
    std::ranges::copy(setting.nose_to_tip_mm, transform_.tool.nose_to_tip_mm.begin());
    transform_.frame.geometry = scheme_->config().linear;
    transform_.frame.rotation = rotation_of(setting.rotation);
    if (setting.offset.empty()) return;
    if (static_cast<int>(setting.offset.size()) != axis_count_)
      throw std::invalid_argument("offset must have a value for each axis");
    std::ranges::copy(setting.offset, transform_.frame.offset.begin());
  }

  [[nodiscard]] Matrix forward(const Matrix& axes_M) const {
    expect_columns(axes_M, axis_count_, "axes");
    return mapped(axes_M, [this](const AxisVector<double>& in, AxisVector<double>& out) {
      kinematics::forward(transform_, in, out);
    });
  }

  [[nodiscard]] Matrix inverse(const Matrix& points_W) const {
    expect_columns(points_W, axis_count_, "points");
    return mapped(points_W, [this](const AxisVector<double>& in, AxisVector<double>& out) {
      kinematics::inverse(transform_, in, out);
    });
  }

  // Axes with their derivatives in time from points with theirs.
  [[nodiscard]] py::tuple jets(const Matrix& position, const Matrix& velocity,
                               const Matrix& acceleration, const Matrix& jerk) const {
    const std::array<const Matrix*, 4> given{&position, &velocity, &acceleration, &jerk};
    for (const Matrix* matrix : given) {
      expect_columns(*matrix, axis_count_, "each matrix");
      if (matrix->shape(0) != position.shape(0))
        throw std::invalid_argument("all matrices must have the same number of rows");
    }
    std::array<Matrix, 4> results{matrix_like(position), matrix_like(position),
                                  matrix_like(position), matrix_like(position)};
    {
      const py::gil_scoped_release others_run;
      for (py::ssize_t row = 0; row < position.shape(0); ++row) map_jets(given, results, row);
    }
    return py::make_tuple(results[0], results[1], results[2], results[3]);
  }

  // Axes as bits: those that take part, those that the inverse leaves open by whole turns.
  [[nodiscard]] unsigned taking_part() const { return scheme_->participants(); }
  [[nodiscard]] unsigned winding() const { return scheme_->winding_axes(); }
  [[nodiscard]] std::string type() const { return scheme_->config().type; }

 private:
  template <class Map>
  [[nodiscard]] Matrix mapped(const Matrix& matrix, const Map& map) const {
    Matrix result = matrix_like(matrix);
    const double* const in = matrix.data();
    double* const out = result.mutable_data();
    const py::ssize_t rows = matrix.shape(0);
    const py::gil_scoped_release others_run;
    for (py::ssize_t row = 0; row < rows; ++row) {
      AxisVector<double> given{};
      AxisVector<double> found{};
      std::copy_n(in + row * axis_count_, axis_count_, given.begin());
      map(given, found);
      std::copy_n(found.begin(), axis_count_, out + row * axis_count_);
    }
    return result;
  }

  void map_jets(const std::array<const Matrix*, 4>& given, std::array<Matrix, 4>& results,
                py::ssize_t row) const {
    AxisVector<Jet> point{};
    AxisVector<Jet> axes{};
    for (int k = 0; k < axis_count_; ++k)
      point[k] = {row_of(*given[0], row)[k], row_of(*given[1], row)[k], row_of(*given[2], row)[k],
                  row_of(*given[3], row)[k]};
    kinematics::inverse(transform_, point, axes);
    for (int k = 0; k < axis_count_; ++k) {
      row_of(results[0], row)[k] = axes[k].value;
      row_of(results[1], row)[k] = axes[k].first;
      row_of(results[2], row)[k] = axes[k].second;
      row_of(results[3], row)[k] = axes[k].third;
    }
  }

  int axis_count_;
  std::unique_ptr<const kinematics::Scheme> scheme_;
  kinematics::Transform transform_;
};

}  // namespace

void bind_kinematics(py::module_& module) {
  py::class_<Kinematics>(module, "Kinematics")
      .def(py::init([](const config::MachineFile& machine, int channel, int scheme, bool leads_tip,
                       const std::array<double, 3>& nose_to_tip_mm, std::vector<double> offset,
                       std::vector<std::array<double, 4>> rotation) {
             return std::make_unique<Kinematics>(machine, channel, scheme,
                                                 Setting{.leads_tip = leads_tip,
                                                         .nose_to_tip_mm = nose_to_tip_mm,
                                                         .offset = std::move(offset),
                                                         .rotation = std::move(rotation)});
           }),
           py::arg("machine"), py::arg("channel"), py::arg("scheme"), py::arg("leads_tip"),
           py::arg("nose_to_tip_mm"), py::arg("offset"), py::arg("rotation"))
      .def("forward", &Kinematics::forward, py::arg("axes"))
      .def("inverse", &Kinematics::inverse, py::arg("points"))
      .def("jets", &Kinematics::jets, py::arg("position"), py::arg("velocity"),
           py::arg("acceleration"), py::arg("jerk"))
      .def("taking_part", &Kinematics::taking_part)
      .def("winding", &Kinematics::winding)
      .def("type", &Kinematics::type);
}

}  // namespace stanok::python

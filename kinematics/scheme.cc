// The list of scheme types, and the transform from the workpiece frame to the machine axes.
//
// A new type of scheme is one file pair beside this one and one row in `types`.
#include "kinematics/scheme.h"

#include <algorithm>
#include <string_view>

#include "kinematics/cartesian.h"
#include "kinematics/cylinder.h"
#include "kinematics/head_head.h"
#include "kinematics/head_table.h"
#include "kinematics/lathe.h"
#include "kinematics/polar_face.h"
#include "kinematics/table_table.h"

namespace stanok::kinematics {
namespace {

// Who asks for a scheme of the type: a scheme file, or the channel on a word of the program.
enum class ChosenBy : unsigned char { file, program };

struct SchemeType {
  std::string_view name;
  std::unique_ptr<const Scheme> (*make)(const SchemeConfig&);
  std::string (*defect)(const SchemeConfig&);
  AxisVector<double> (*zero_default)(const SchemeConfig&);
  ChosenBy chosen_by = ChosenBy::file;
};

template <class Type>
std::unique_ptr<const Scheme> make(const SchemeConfig& config) {
  return std::make_unique<const Type>(config);
}

AxisVector<double> no_shift(const SchemeConfig&) {
  return {};
}

constexpr std::array types{
    SchemeType{"cartesian", make<Cartesian>, cartesian_defect, no_shift},
    SchemeType{"lathe", make<Lathe>, lathe_defect, no_shift},
    SchemeType{"head_table", make<HeadTable>, head_table_defect, zero_of_table_base},
    SchemeType{"head_head", make<HeadHead>, head_head_defect, no_shift},
    SchemeType{"table_table", make<TableTable>, table_table_defect, zero_of_table_base},
    SchemeType{"polar_face", make<PolarFace>, turned_workpiece_defect, no_shift, ChosenBy::program},
    SchemeType{"cylinder", make<Cylinder>, cylinder_defect, no_shift, ChosenBy::program},
};

const SchemeType* find_type(std::string_view name) {
  const auto* type = std::ranges::find(types, name, &SchemeType::name);
  return type == types.end() ? nullptr : type;
}

// X, Y and Z out of the axes of a channel; one that is missing is 0.
template <class Scalar>
std::array<Scalar, 3> geometry_of(const Frame& frame, const AxisVector<Scalar>& axes) RT_SAFE {
  std::array<Scalar, 3> point{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (frame.geometry[k] >= 0) point[k] = axes[static_cast<std::size_t>(frame.geometry[k])];
  }
  return point;
}

template <class Scalar>
void set_geometry(const Frame& frame, const std::array<Scalar, 3>& point, AxisVector<Scalar>& axes)
    RT_SAFE {
  for (std::size_t k = 0; k < 3; ++k) {
    if (frame.geometry[k] >= 0) axes[static_cast<std::size_t>(frame.geometry[k])] = point[k];
  }
}

// p_B = rotation * p_W + offset.
template <class Scalar>
AxisVector<Scalar> framed(const Frame& frame, const AxisVector<Scalar>& point_W) RT_SAFE {
  AxisVector<Scalar> point_B = point_W;
  if (!frame.rotation.is_identity()) {
    set_geometry(frame, frame.rotation.turned(geometry_of(frame, point_W)), point_B);
  }
  for (std::size_t axis = 0; axis < axes_max; ++axis) {
    point_B[axis] = point_B[axis] + frame.offset[axis];
  }
  return point_B;
}

template <class Scalar>
void machine_from_workpiece(const Transform& transform, const AxisVector<Scalar>& point_W,
                            AxisVector<Scalar>& axes_M) RT_SAFE {
  if (transform.scheme == nullptr) {
    axes_M = point_W;
    return;
  }
  transform.scheme->inverse(transform.mode, transform.tool, framed(transform.frame, point_W),
                            axes_M);
}

}  // namespace

bool takes_part(const SchemeConfig& config, int axis) {
  return axis >= 0 && std::ranges::find(config.axes, axis) != config.axes.end();
}

Scheme::Scheme(SchemeConfig config) : config_(std::move(config)) {
  for (const int axis : config_.axes) participants_ |= 1U << static_cast<unsigned>(axis);
}

std::unique_ptr<const Scheme> make_scheme(const SchemeConfig& config) {
  const SchemeType* type = find_type(config.type);
  if (type == nullptr || !type->defect(config).empty()) return nullptr;
  return type->make(config);
}

std::string scheme_defect(const SchemeConfig& config) {
  const SchemeType* type = find_type(config.type);
  return type == nullptr ? "unknown type '" + config.type + "'" : type->defect(config);
}

AxisVector<double> zero_default(const SchemeConfig& config) {
  const SchemeType* type = find_type(config.type);
  return type == nullptr ? AxisVector<double>{} : type->zero_default(config);
}

std::vector<std::string> scheme_types() {
  std::vector<std::string> names;
  names.reserve(types.size());
  for (const SchemeType& type : types) names.emplace_back(type.name);
  return names;
}

std::vector<std::string> scheme_types_of_files() {
  std::vector<std::string> names;
  for (const SchemeType& type : types) {
    if (type.chosen_by == ChosenBy::file) names.emplace_back(type.name);
  }
  return names;
}

AxisVector<double> base_from_workpiece(const Frame& frame, const AxisVector<double>& point_W)
    RT_SAFE {
  return framed(frame, point_W);
}

void inverse(const Transform& transform, const AxisVector<Jet>& point_W, AxisVector<Jet>& axes_M)
    RT_SAFE {
  machine_from_workpiece(transform, point_W, axes_M);
}

void inverse(const Transform& transform, const AxisVector<double>& point_W,
             AxisVector<double>& axes_M) RT_SAFE {
  machine_from_workpiece(transform, point_W, axes_M);
}

void forward(const Transform& transform, const AxisVector<double>& axes_M,
             AxisVector<double>& point_W) RT_SAFE {
  if (transform.scheme == nullptr) {
    point_W = axes_M;
    return;
  }
  AxisVector<double> point_B{};
  transform.scheme->forward(transform.mode, transform.tool, axes_M, point_B);
  const Frame& frame = transform.frame;
  for (std::size_t axis = 0; axis < axes_max; ++axis) {
    point_W[axis] = point_B[axis] - frame.offset[axis];
  }
  if (frame.rotation.is_identity()) return;
  set_geometry(frame, frame.rotation.turned_back(geometry_of(frame, point_W)), point_W);
}

}  // namespace stanok::kinematics

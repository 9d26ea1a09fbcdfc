// What is done for all types of schemes, and the transform from the workpiece frame to the machine
// axes.
#include "kinematics/scheme.h"

#include <algorithm>
#include <optional>

#include "kinematics/linear_axes.h"

namespace stanok::kinematics {
namespace {

// What can be done with a config, whose type is known by its name only.
struct Operations {
  std::unique_ptr<const Scheme> (*make)(const SchemeConfig&);
  std::string (*defect)(const SchemeConfig&);
  AxisVector<double> (*zero_default)(const SchemeConfig&);
};

template <class Type>
std::unique_ptr<const Scheme> make(const SchemeConfig& config) {
  return std::make_unique<const Type>(config);
}

template <class Type>
std::string defect(const SchemeConfig& config) {
  if (!std::holds_alternative<typename Type::Geometry>(config.geometry)) {
    return "its geometry is that of another type";
  }
  return Type::defect(config);
}

template <class Type>
AxisVector<double> zero_of(const SchemeConfig& config) {
  return Type::zero_default(config);
}

template <class... Types>
std::vector<TypeOfScheme> described(SchemeTypeList<Types...>) {
  return {{Types::type_name, Types::chosen_by, typename Types::Geometry{}}...};
}

// Nothing for a type that is not in the list.
template <class... Types>
std::optional<Operations> operations(std::string_view name, SchemeTypeList<Types...>) {
  std::optional<Operations> found;
  ((Types::type_name == name ? void(found = Operations{make<Types>, defect<Types>, zero_of<Types>})
                             : void()),
   ...);
  return found;
}

// p_B = rotation * p_W + offset.
template <class Scalar>
AxisVector<Scalar> framed(const Frame& frame, const AxisVector<Scalar>& point_W) RT_SAFE {
  AxisVector<Scalar> point_B = point_W;
  if (!frame.rotation.is_identity()) {
    const LinearAxes linear(frame.geometry);
    linear.set(frame.rotation.turned(linear.of(point_W)), point_B);
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

AxisVector<double> reading_per_mm(const SchemeConfig& config) {
  AxisVector<double> reading;
  reading.fill(1.0);
  if (const auto* lathe = std::get_if<LatheGeometry>(&config.geometry))
    linear_axes(config).set(reading_per_mm(*lathe), reading);
  return reading;
}

bool takes_part(const SchemeConfig& config, int axis) {
  return axis >= 0 && std::ranges::find(config.axes, axis) != config.axes.end();
}

Scheme::Scheme(const SchemeConfig& config) : config_(std::make_unique<const SchemeConfig>(config)) {
  for (const AxisIndex axis : config.axes) participants_ |= axis.bit();
}

Scheme::~Scheme() = default;

std::array<Vector3<double>, 3> Scheme::spindle_axes(const AxisVector<double>&) const RT_SAFE {
  return {Vector3<double>{1.0, 0.0, 0.0}, Vector3<double>{0.0, 1.0, 0.0},
          Vector3<double>{0.0, 0.0, 1.0}};
}

std::unique_ptr<const Scheme> make_scheme(const SchemeConfig& config) {
  const auto type = operations(config.type, SchemeTypes());
  if (!type || !type->defect(config).empty()) return nullptr;
  return type->make(config);
}

std::string scheme_defect(const SchemeConfig& config) {
  const auto type = operations(config.type, SchemeTypes());
  return type ? type->defect(config) : "unknown type '" + config.type + "'";
}

AxisVector<double> zero_default(const SchemeConfig& config) {
  const auto type = operations(config.type, SchemeTypes());
  return type ? type->zero_default(config) : AxisVector<double>{};
}

const std::vector<TypeOfScheme>& scheme_types() {
  static const std::vector<TypeOfScheme> types = described(SchemeTypes());
  return types;
}

const TypeOfScheme* find_scheme_type(std::string_view name) {
  const auto type = std::ranges::find(scheme_types(), name, &TypeOfScheme::name);
  return type == scheme_types().end() ? nullptr : &*type;
}

std::vector<SchemeKey> keys_of(SchemeGeometry& geometry) {
  return std::visit([](auto& own) { return own.keys(); }, geometry);
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

bool operator==(const Transform& a, const Transform& b) RT_SAFE {
  const Vector3<double>& nose_a = a.tool.nose_to_tip_mm;
  const Vector3<double>& nose_b = b.tool.nose_to_tip_mm;
  return a.scheme == b.scheme && a.mode == b.mode && a.row.is_same(b.row) &&
         nose_a.x() == nose_b.x() && nose_a.y() == nose_b.y() && nose_a.z() == nose_b.z() &&
         a.frame == b.frame;
}

Transform with_changes(const Transform& transform, const LengthChanges& changes) RT_SAFE {
  Transform changed = transform;
  changed.tool.nose_to_tip_mm -= changes.since(transform.row);
  return changed;
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
  const LinearAxes linear(frame.geometry);
  linear.set(frame.rotation.turned_back(linear.of(point_W)), point_W);
}

}  // namespace stanok::kinematics

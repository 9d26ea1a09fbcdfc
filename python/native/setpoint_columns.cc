#include "python/native/setpoint_columns.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace stanok::python {
namespace {

namespace py = pybind11;

// The type of the member that a pointer leads to.
template <class Value>
std::type_identity<Value> member_of(Value setpoint_t::*);

// The array takes the memory of the vector over.
template <class Number>
py::array owned(std::vector<Number> values, std::vector<py::ssize_t> shape) {
  auto* const vector = new std::vector<Number>(std::move(values));
  const py::capsule owner(vector,
                          [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
  return py::array_t<Number>(std::move(shape), vector->data(), owner);
}

template <class Number>
py::array array_of(std::vector<Number> values) {
  const auto rows = static_cast<py::ssize_t>(values.size());
  return owned(std::move(values), {rows});
}

template <class Number>
py::array matrix_of(std::vector<Number> values, std::int64_t rows, int width) {
  return owned(std::move(values), {rows, width});
}

}  // namespace

const std::vector<SetpointColumns::ColumnType>& SetpointColumns::types() {
  static const std::vector<ColumnType> list{{"time_s", Time{}},
                                            {"cycle", &setpoint_t::cycle},
                                            {"seq", &setpoint_t::seq},
                                            {"state", &setpoint_t::state},
                                            {"flags", &setpoint_t::flags},
                                            {"run", &setpoint_t::run},
                                            {"file", &setpoint_t::file},
                                            {"line", &setpoint_t::line},
                                            {"block", &setpoint_t::block},
                                            {"scheme", &setpoint_t::scheme},
                                            {"feed_commanded", &setpoint_t::feed_commanded},
                                            {"path_speed", &setpoint_t::path_speed},
                                            {"feed_override", &setpoint_t::feed_override},
                                            {"tip_position", &setpoint_t::tip_position},
                                            {"tip_velocity", &setpoint_t::tip_velocity},
                                            {"position", &setpoint_t::position},
                                            {"velocity", &setpoint_t::velocity},
                                            {"acceleration", &setpoint_t::acceleration},
                                            {"jerk", &setpoint_t::jerk},
                                            {"position_code", &setpoint_t::position_code},
                                            {"velocity_code", &setpoint_t::velocity_code}};
  return list;
}

std::vector<std::string> SetpointColumns::names() {
  std::vector<std::string> list;
  for (const ColumnType& type : types()) list.emplace_back(type.name);
  return list;
}

SetpointColumns::Values SetpointColumns::values_for(const Field& field) {
  return std::visit(
      []<class Kind>(const Kind&) -> Values {
        if constexpr (std::is_same_v<Kind, Time>) {
          return std::vector<double>();
        } else {
          using Member = typename decltype(member_of(Kind{}))::type;
          return std::vector<std::remove_all_extents_t<Member>>();
        }
      },
      field);
}

SetpointColumns::SetpointColumns(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto type = std::ranges::find(types(), name, &ColumnType::name);
    if (type == types().end()) {
      std::string fault = "there is no column '" + name + "' of setpoints; the columns are";
      for (const ColumnType& one : types()) fault.append(" ").append(one.name);
      throw std::invalid_argument(fault);
    }
    const bool is_twice =
        std::ranges::any_of(columns_, [&](const Column& column) { return column.type == &*type; });
    if (!is_twice) columns_.push_back({&*type, values_for(type->field)});
  }
}

void SetpointColumns::add(const setpoint_t& setpoint, double time_s) {
  if (rows_ == 0) axis_count_ = std::clamp<int>(setpoint.axis_count, 0, 8);
  for (Column& column : columns_) append(column, setpoint, time_s);
  ++rows_;
}

void SetpointColumns::append(Column& column, const setpoint_t& setpoint, double time_s) const {
  std::visit(
      [&]<class Kind>(const Kind& field) {
        if constexpr (std::is_same_v<Kind, Time>) {
          std::get<std::vector<double>>(column.values).push_back(time_s);
        } else {
          const auto& member = setpoint.*field;
          using Member = std::remove_cvref_t<decltype(member)>;
          auto& values = std::get<std::vector<std::remove_all_extents_t<Member>>>(column.values);
          if constexpr (std::is_array_v<Member>) {
            values.insert(values.end(), std::begin(member), std::begin(member) + axis_count_);
          } else {
            values.push_back(member);
          }
        }
      },
      column.type->field);
}

py::dict SetpointColumns::take() {
  py::dict arrays;
  for (Column& column : columns_) {
    const bool is_of_axes = std::holds_alternative<AxisField<double>>(column.type->field) ||
                            std::holds_alternative<AxisField<std::int64_t>>(column.type->field);
    const py::str name(std::string(column.type->name));
    std::visit(
        [&](auto& values) {
          auto taken = std::exchange(values, {});
          arrays[name] = is_of_axes ? matrix_of(std::move(taken), rows_, axis_count_)
                                    : array_of(std::move(taken));
        },
        column.values);
  }
  rows_ = 0;
  axis_count_ = 0;
  return arrays;
}

}  // namespace stanok::python

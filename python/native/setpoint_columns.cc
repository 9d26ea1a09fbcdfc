#include "python/native/setpoint_columns.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace stanok::python {
namespace {

namespace py = pybind11;
using recording::SetpointField;

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

std::vector<std::string> SetpointColumns::names() {
  std::vector<std::string> list;
  for (const SetpointField& field : recording::setpoint_fields()) list.emplace_back(field.name);
  return list;
}

SetpointColumns::Values SetpointColumns::values_for(const SetpointField::Source& source) {
  return std::visit(
      []<class Kind>(const Kind&) -> Values {
        return std::vector<typename recording::NumberOfSource<Kind>::Type>();
      },
      source);
}

SetpointColumns::SetpointColumns(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto& fields = recording::setpoint_fields();
    const auto field = std::ranges::find(fields, name, &SetpointField::name);
    if (field == fields.end()) {
      std::string fault = "there is no column '" + name + "' of setpoints; the columns are";
      for (const SetpointField& one : fields) fault.append(" ").append(one.name);
      throw std::invalid_argument(fault);
    }
    const bool is_twice = std::ranges::any_of(
        columns_, [&](const Column& column) { return column.field == &*field; });
    if (!is_twice) columns_.push_back({&*field, values_for(field->source)});
  }
}

void SetpointColumns::add(const setpoint_t& setpoint, double time_s) {
  if (rows_ == 0) axis_count_ = recording::axis_count_of(setpoint);
  for (Column& column : columns_) append(column, setpoint, time_s);
  ++rows_;
}

void SetpointColumns::append(Column& column, const setpoint_t& setpoint, double time_s) const {
  std::visit(
      [&]<class Kind>(const Kind& source) {
        if constexpr (std::is_same_v<Kind, SetpointField::Time>) {
          std::get<std::vector<double>>(column.values).push_back(time_s);
        } else {
          const auto& member = setpoint.*source;
          using Member = std::remove_cvref_t<decltype(member)>;
          auto& values = std::get<std::vector<std::remove_all_extents_t<Member>>>(column.values);
          if constexpr (std::is_array_v<Member>) {
            values.insert(values.end(), std::begin(member), std::begin(member) + axis_count_);
          } else {
            values.push_back(member);
          }
        }
      },
      column.field->source);
}

py::dict SetpointColumns::take() {
  py::dict arrays;
  for (Column& column : columns_) {
    const bool is_of_axes = column.field->is_of_axes();
    const py::str name(std::string(column.field->name));
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

// The list of scheme types. A new type stands here, by its header and its name, and nowhere else.
//
// What a type is: a class derived from FormulaScheme with the members that SchemeType asks for.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kinematics/cartesian.h"
#include "kinematics/cylinder.h"
#include "kinematics/head_head.h"
#include "kinematics/head_table.h"
#include "kinematics/lathe.h"
#include "kinematics/polar_face.h"
#include "kinematics/scheme_key.h"
#include "kinematics/table_table.h"

namespace stanok::kinematics {

template <class Type>
concept SchemeType =
    std::derived_from<Type, Scheme> && std::constructible_from<Type, const SchemeConfig&> &&
    std::default_initializable<typename Type::Geometry> &&
    requires(const SchemeConfig& config, typename Type::Geometry geometry) {
      { Type::type_name } -> std::convertible_to<std::string_view>;
      { Type::chosen_by } -> std::convertible_to<ChosenBy>;
      // The keys of the type in a scheme file.
      { geometry.keys() } -> std::same_as<std::vector<SchemeKey>>;
      // What the config lacks, in words for the installer; empty: nothing.
      { Type::defect(config) } -> std::same_as<std::string>;
      { Type::zero_default(config) } -> std::same_as<AxisVector<double>>;
    };

template <SchemeType... Types>
struct SchemeTypeList {
  using Geometry = std::variant<typename Types::Geometry...>;
};

using SchemeTypes =
    SchemeTypeList<Cartesian, Lathe, HeadTable, HeadHead, TableTable, PolarFace, Cylinder>;

// What one type has and others have not.
using SchemeGeometry = SchemeTypes::Geometry;

}  // namespace stanok::kinematics

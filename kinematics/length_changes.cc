#include "kinematics/length_changes.h"

namespace stanok::kinematics {
namespace {

bool is_later(const LengthChange& change, const ToolRow& row) RT_SAFE {
  return row.sign != 0 && change.tool == row.tool && change.edge == row.edge &&
         change.version > row.version;
}

}  // namespace

bool LengthChanges::concern(const ToolRow& row) const RT_SAFE {
  for (std::size_t k = 0; k < count_; ++k) {
    if (is_later(changes_[k], row)) return true;
  }
  return false;
}

Vector3<double> LengthChanges::since(const ToolRow& row) const RT_SAFE {
  Vector3<double> by = Vector3<double>::Zero();
  for (std::size_t k = 0; k < count_; ++k) {
    if (is_later(changes_[k], row)) by += row.sign * vector3(changes_[k].by_mm);
  }
  return by;
}

}  // namespace stanok::kinematics

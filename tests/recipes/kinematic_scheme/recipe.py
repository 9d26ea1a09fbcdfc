"""A turning center with an inclined Y."""
from pathlib import Path

from recipe import Recipe, after, before, new_file, replaced, words_replaced

HERE = Path(__file__).parent

RECIPE = Recipe("A kinematic scheme", [
    new_file("kinematics/inclined_y.h", HERE),
    new_file("kinematics/inclined_y.cc", HERE),
    before("kinematics/scheme_types.h", '#include "kinematics/lathe.h"', '#include "kinematics/inclined_y.h"'),
    replaced("kinematics/scheme_types.h", """
using SchemeTypes =
    SchemeTypeList<Cartesian, Lathe, HeadTable, HeadHead, TableTable, PolarFace, Cylinder>;
""", """
using SchemeTypes = SchemeTypeList<Cartesian, Lathe, InclinedY, HeadTable, HeadHead, TableTable,
                                   PolarFace, Cylinder>;
"""),
    after("docs/integrator/kinematics.md", """
| [`lathe`](#lathe) | lathe, radius or diameter, turret behind or in front | carried along |
""", """
| [`inclined_y`](#inclined_y) | turning center whose Y slide runs at an angle to Y | carried along |
"""),
    before("docs/integrator/kinematics.md", "### Two chains of rotary axes", """
### `inclined_y`

The Y slide runs at `angle`, from Y towards X, and carries along X. With p = B − nose_to_tip:

    X:       M = p_x − p_y·tan angle + zero
    Y:       M = p_y / cos angle + zero
    others:  as cartesian

X and Y must take part.

"""),
    words_replaced("docs/reference/configuration.md", "cartesian, lathe, head_table, head_head, table_table |",
                   "cartesian, lathe, inclined_y, head_table, head_head, table_table |"),
    before("docs/reference/configuration.md", "### `[[channel.scheme]] of type head_table`", """
### `[[channel.scheme]] of type inclined_y`

| key | kind | unit | default | values | meaning |
|---|---|---|---|---|---|
| `angle` | number | deg | 30 | -60 to 60 | of the Y slide, from Y towards X |

"""),
    after("tests/config/sections/scheme_file_test.cc",
          r'      {"lathe", {{"x_reading", "\"diameter\""}, {"turret", "\"front\""}}},',
          '      {"inclined_y", {{"angle", "25"}}},'),
    before("tests/kinematics/reference.h",
           "// The tool stands on the X axis of the machine, at +r or beyond the centre at -r; the workpiece has",
           """
// X and the Y slide are two directions of the plane that are not square: Cramer's rule says how far
// each of them goes.
inline Axes inclined_y(const SchemeConfig& config, const Axes& point, const Vector& nose_to_tip) {
  const auto& geometry = std::get<InclinedY::Geometry>(config.geometry);
  const auto cross = [](const std::complex<Real>& a, const std::complex<Real>& b) {
    return std::imag(std::conj(a) * b);
  };
  const std::complex<Real> along_x(1, 0);
  const std::complex<Real> along_slide =
      std::polar(Real(1), pi / 2 - geometry.angle_deg * pi / 180);
  const std::size_t x = slot(config.linear[0]);
  const std::size_t y = slot(config.linear[1]);
  const std::complex<Real> tip(point[x] - nose_to_tip[0], point[y] - nose_to_tip[1]);
  Axes axes = shifted(config, point, nose_to_tip);
  axes[x] = cross(tip, along_slide) / cross(along_x, along_slide) + config.zero[x];
  axes[y] = cross(along_x, tip) / cross(along_x, along_slide) + config.zero[y];
  return axes;
}

"""),
    before("tests/kinematics/test_machines.h", """
template <class Type>
std::unique_ptr<const Scheme> make_foreign(const SchemeConfig& config) {
""", """
inline SchemeConfig inclined_y() {
  SchemeConfig config = config_of("inclined_y");
  config.geometry = InclinedY::Geometry{.angle_deg = 25.0};
  return config;
}

"""),
    after("tests/kinematics/test_machines.h", '      turned_machine("lathe_front_diameter", front),',
          '      {"inclined_y", inclined_y(), reference::inclined_y, reference::inclined_y},'),
])

#include "simulation/picture/part_picture.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace stanok::simulation {
namespace {

constexpr int view_width = 760;  // pixels
constexpr int view_height = 560;
constexpr int border = 24;
constexpr int head_height = 64;
constexpr int foot_height = 88;
constexpr double filled = 0.86;  // of a view, by the part
constexpr int sheet_width = 2 * view_width + 3 * border;
constexpr int sheet_height = head_height + 2 * view_height + 3 * border + foot_height;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

std::array<Camera, 4> cameras() {
  return {{{"from the front, right and above", {-0.62, 0.72, -0.55}, Vector::UnitZ()},
           {"from the back, left and above", {0.72, -0.62, -0.55}, Vector::UnitZ()},
           {"from the top", -Vector::UnitZ(), Vector::UnitY()},
           {"from the front", Vector::UnitY(), Vector::UnitZ()}}};
}

struct Projection {
  double width = 0.0;  // mm
  double height = 0.0;
};

Projection projection_of(const Camera& camera, const Vector& size) {
  const Vector seen = camera.axes().cwiseAbs() * size;
  return {seen.x(), seen.y()};
}

double scale_for(const std::array<Camera, 4>& views, const Vector& size) {
  double scale = 1e9;
  for (const Camera& camera : views) {
    const Projection part = projection_of(camera, size);
    scale = std::min({scale, filled * view_width / part.width, filled * view_height / part.height});
  }
  return scale;
}

void write(cairo_t* cairo, double x, double y, double size, const std::string& text,
           double grey = 0.2) {
  cairo_set_source_rgb(cairo, grey, grey, grey);
  cairo_set_font_size(cairo, size);
  cairo_move_to(cairo, x, y);
  cairo_show_text(cairo, text.c_str());
}

// Program axes in the corner of a view; one that points at the eye is left out.
void draw_axes(cairo_t* cairo, const Camera& camera, double x, double y) {
  constexpr double length = 34.0;
  constexpr PerAxis<std::array<double, 3>> colours{
      {{{0.75, 0.15, 0.15}, {0.10, 0.50, 0.15}, {0.15, 0.25, 0.75}}}};
  constexpr PerAxis<const char*> names{"X", "Y", "Z"};
  const Eigen::Matrix3d axes = camera.axes();
  cairo_set_line_width(cairo, 2.0);
  for (int k = 0; k < 3; ++k) {
    const double dx = length * axes(0, k);
    const double dy = -length * axes(1, k);
    if (std::hypot(dx, dy) < length / 4.0) continue;
    const auto& colour = colours[k];
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    cairo_move_to(cairo, x, y);
    cairo_line_to(cairo, x + dx, y + dy);
    cairo_stroke(cairo);
    cairo_set_font_size(cairo, 13.0);
    cairo_move_to(cairo, x + 1.25 * dx - 4.0, y + 1.25 * dy + 4.0);
    cairo_show_text(cairo, names[k]);
  }
}

void draw_ground(cairo_t* cairo, double x, double y) {
  cairo_pattern_t* ground = cairo_pattern_create_linear(0.0, y, 0.0, y + view_height);
  cairo_pattern_add_color_stop_rgb(ground, 0.0, 0.97, 0.975, 0.985);
  cairo_pattern_add_color_stop_rgb(ground, 1.0, 0.86, 0.88, 0.91);
  cairo_set_source(cairo, ground);
  cairo_rectangle(cairo, x, y, view_width, view_height);
  cairo_fill(cairo);
  cairo_pattern_destroy(ground);
}

void draw_marks(cairo_t* cairo, const Camera& camera, const Vector& centre, double scale,
                const std::vector<Vector>& marks, double x, double y) {
  cairo_set_source_rgb(cairo, 0.85, 0.1, 0.1);
  cairo_set_line_width(cairo, 2.0);
  for (const Vector& mark : marks) {
    const Vector seen = camera.axes() * (mark - centre) * scale;
    const double u = x + view_width / 2.0 + seen.x();
    const double v = y + view_height / 2.0 - seen.y();
    if (u < x || v < y || u > x + view_width || v > y + view_height) continue;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, u, v, 7.0, 0.0, 2.0 * std::numbers::pi);
    cairo_stroke(cairo);
  }
}

void paint(cairo_t* cairo, Image& image, double x, double y) {
  const Surface pixels(cairo_image_surface_create_for_data(
                           reinterpret_cast<unsigned char*>(image.pixels.data()),
                           CAIRO_FORMAT_ARGB32, image.width, image.height, 4 * image.width),
                       &cairo_surface_destroy);
  cairo_set_source_surface(cairo, pixels.get(), x, y);
  cairo_paint(cairo);
}

// 1, 2 or 5 times a power of ten, about a fifth of a view.
double bar_length(double pixels_per_mm) {
  const double wanted = view_width / 5.0 / pixels_per_mm;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= wanted) return factor * decade;
  }
  return decade;
}

void draw_bar(cairo_t* cairo, double pixels_per_mm, double x, double y) {
  const double length = bar_length(pixels_per_mm);
  const double width = length * pixels_per_mm;
  for (int part = 0; part < 4; ++part) {
    const double grey = part % 2 == 0 ? 0.15 : 0.95;
    cairo_set_source_rgb(cairo, grey, grey, grey);
    cairo_rectangle(cairo, x + width * part / 4.0, y, width / 4.0, 8.0);
    cairo_fill(cairo);
  }
  cairo_set_source_rgb(cairo, 0.15, 0.15, 0.15);
  cairo_set_line_width(cairo, 1.0);
  cairo_rectangle(cairo, x, y, width, 8.0);
  cairo_stroke(cairo);
  write(cairo, x + width + 10.0, y + 10.0, 15.0, fmt::format("{:g} mm", length));
}

void draw_labels(cairo_t* cairo, const PictureLabels& labels, double scale) {
  write(cairo, border, 42.0, 26.0, labels.title, 0.1);
  const double foot = sheet_height - foot_height + 14.0;
  draw_bar(cairo, scale, border, foot + 4.0);
  double y = foot + 14.0;
  for (const std::string& fact : labels.facts) {
    write(cairo, 0.4 * sheet_width, y, 15.0, fact);
    y += 22.0;
  }
}

cairo_status_t append_bytes(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

Vector size_of(const Grid& grid) {
  Vector size;
  for (int k = 0; k < 3; ++k) size[k] = grid.cell[k] * grid.count[k];
  return size;
}

}  // namespace

std::string view_of_part(const Mesh& mesh, const Blank& blank, const Grid& grid, int width,
                         int height) {
  const Vector size = size_of(grid);
  const Camera camera = cameras().front();
  const Projection part = projection_of(camera, size);
  const double scale = filled * std::min(width / part.width, height / part.height);
  Image image =
      render(lit(mesh, blank, grid), camera, grid.origin + size / 2.0, scale, width, height);
  const Surface pixels(cairo_image_surface_create_for_data(
                           reinterpret_cast<unsigned char*>(image.pixels.data()),
                           CAIRO_FORMAT_ARGB32, image.width, image.height, 4 * image.width),
                       &cairo_surface_destroy);
  std::string bytes;
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(pixels.get(), append_bytes, &bytes);
  return status == CAIRO_STATUS_SUCCESS ? bytes : std::string();
}

std::string draw_part(const Mesh& mesh, const Blank& blank, const Grid& grid,
                      const PictureLabels& labels, const std::filesystem::path& file) {
  const Surface sheet(cairo_image_surface_create(CAIRO_FORMAT_RGB24, sheet_width, sheet_height),
                      &cairo_surface_destroy);
  const Context context(cairo_create(sheet.get()), &cairo_destroy);
  cairo_t* const cairo = context.get();
  cairo_set_source_rgb(cairo, 1.0, 1.0, 1.0);
  cairo_paint(cairo);
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);

  const Vector size = size_of(grid);
  const Vector centre = grid.origin + size / 2.0;
  const LitSurface surface = lit(mesh, blank, grid);
  const auto views = cameras();
  const double scale = scale_for(views, size);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t column = i % 2;
    const std::size_t row = i / 2;
    const double x = border + static_cast<double>(column) * (view_width + border);
    const double y = head_height + static_cast<double>(row) * (view_height + border);
    draw_ground(cairo, x, y);
    Image image = render(surface, views[i], centre, scale, view_width, view_height);
    paint(cairo, image, x, y);
    draw_marks(cairo, views[i], centre, scale, labels.marks, x, y);
    draw_axes(cairo, views[i], x + 52.0, y + view_height - 44.0);
    write(cairo, x + 12.0, y + 24.0, 15.0, views[i].name, 0.35);
  }
  draw_labels(cairo, labels, scale);
  const cairo_status_t status = cairo_surface_write_to_png(sheet.get(), file.c_str());
  if (status == CAIRO_STATUS_SUCCESS) return "";
  return file.string() + ": " + cairo_status_to_string(status);
}

}  // namespace stanok::simulation

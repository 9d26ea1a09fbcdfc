// Distances from a surface that a part is to have, against boxes and spheres whose distance is
// known.
#include "simulation/reference/reference_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

namespace stanok::simulation {
namespace {

using Point = Mesh::Point;

// From the origin to (x, y, z), its triangles counter-clockwise from outside.
std::vector<StlTriangle> box(float x, float y, float z) {
  std::vector<StlTriangle> triangles;
  const auto face = [&](const Point& from, const Point& a, const Point& b) {
    triangles.push_back({from, from + a, from + a + b});
    triangles.push_back({from, from + a + b, from + b});
  };
  const Point X(x, 0, 0);
  const Point Y(0, y, 0);
  const Point Z(0, 0, z);
  const Point none(0, 0, 0);
  face(none, Y, X);
  face(Z, X, Y);
  face(none, X, Z);
  face(Y, Z, X);
  face(none, Z, Y);
  face(X, Y, Z);
  return triangles;
}

// Signed, of the box: outside by the nearest point of it, inside by the nearest face.
double distance_to_box(const Point& size, const Point& p) {
  const Point outside = (p - size).cwiseMax(-p);
  const double way = outside.cwiseMax(0.0F).norm();
  return way > 0.0 ? way : outside.maxCoeff();
}

TEST(ReferenceSurface, DistancesToABoxAreExact) {
  const Point size(30, 20, 10);
  const ReferenceSurface surface(box(size.x(), size.y(), size.z()));
  std::mt19937 random(7);
  std::uniform_real_distribution<float> part(-0.5F, 1.5F);
  for (int k = 0; k < 5000; ++k) {
    const Point place(part(random) * size.x(), part(random) * size.y(), part(random) * size.z());
    EXPECT_NEAR(surface.deviation(place), distance_to_box(size, place), 1e-4) << place.transpose();
  }
  // At edges and corners it is outside whichever triangle is found.
  EXPECT_NEAR(surface.deviation({31, 21, 11}), std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(surface.deviation({29.5F, 19, 5}), -0.5, 1e-6);
  EXPECT_NEAR(surface.deviation({15, 10, 10}), 0.0, 1e-6);
}

// Of 2 x 200 x 100 triangles, which lie within R (1 - cos(pi / 100)) of the sphere.
TEST(ReferenceSurface, DistancesToASphereAreThoseOfItsRadius) {
  constexpr double R = 25.0;
  constexpr int around = 200;
  constexpr int up = 100;
  const auto at = [&](int i, int j) {
    const double a = 2.0 * std::numbers::pi * i / around;
    const double b = std::numbers::pi * j / up;
    return Point(static_cast<float>(R * std::sin(b) * std::cos(a)),
                 static_cast<float>(R * std::sin(b) * std::sin(a)),
                 static_cast<float>(R * std::cos(b)));
  };
  std::vector<StlTriangle> triangles;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < up; ++j) {
      if (j > 0) triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      if (j + 1 < up) triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  const ReferenceSurface surface(triangles);
  const double chord = R * (1.0 - std::cos(std::numbers::pi / up)) * 2.0;
  std::mt19937 random(11);
  std::normal_distribution<double> gauss;
  for (int k = 0; k < 2000; ++k) {
    const Vector direction = Vector(gauss(random), gauss(random), gauss(random)).normalized();
    const double radius = R + 3.0 * std::sin(k);
    const Point place = (radius * direction).cast<float>();
    EXPECT_NEAR(surface.deviation(place), radius - R, chord) << place.transpose();
  }
}

// A file need not be closed to be the surface of a part; a triangle without an area is none.
TEST(ReferenceOfStl, IsThatOfItsTriangles) {
  std::string text = "solid box\n";
  const auto add = [&text](const StlTriangle& triangle) {
    std::ostringstream corners;
    for (const Point& corner : triangle) corners << "vertex " << corner.transpose() << "\n";
    text += "facet normal 0 0 0\nouter loop\n" + corners.str() + "endloop\nendfacet\n";
  };
  std::vector<StlTriangle> open_box = box(3, 2, 1);
  open_box.pop_back();
  for (const StlTriangle& triangle : open_box) add(triangle);
  add({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)});
  const auto surface = reference_of_stl(text + "endsolid\n");
  ASSERT_TRUE(surface) << surface.error();
  EXPECT_NEAR(surface->deviation({1.5F, 1, 3}), 2.0, 1e-6);
}

TEST(ReferenceOfStl, IsRefusedWithTheReason) {
  EXPECT_FALSE(reference_of_stl(""));
  EXPECT_FALSE(reference_of_stl("M30\n"));
  const std::string flat =
      "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\nendloop\n"
      "endfacet\nendsolid\n";
  const auto without_area = reference_of_stl(flat);
  ASSERT_FALSE(without_area);
  EXPECT_NE(without_area.error().find("no triangle with an area"), std::string::npos);
  std::string far = flat;
  far.replace(far.find("1 0 0\nvertex 2 0 0"), 5, "0 1e9 0");
  EXPECT_FALSE(reference_of_stl(far));
}

}  // namespace
}  // namespace stanok::simulation

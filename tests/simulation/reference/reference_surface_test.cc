// Distances from a surface that a part is to have, against boxes and spheres whose distance is
// known.
#include "simulation/reference/reference_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "simulation/picture/stl_file.h"
#include "tests/support/temporary_directory.h"

namespace stanok::simulation {
namespace {

using Point = Mesh::Point;

// From the origin to (x, y, z), its triangles counter-clockwise from outside.
std::vector<Corners> box(float x, float y, float z) {
  std::vector<Corners> triangles;
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
  std::vector<Corners> triangles;
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

TEST(StlReader, ReadsBothForms) {
  const stanok::testing::TemporaryDirectory folder;
  Mesh mesh;
  for (const Corners& corners : box(3, 2, 1)) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const auto binary = folder.path() / "binary.stl";
  ASSERT_EQ(write_stl(mesh, binary, "solid, it says, and is binary"), "");
  const auto read = read_stl(binary);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, box(3, 2, 1));
  const auto text = folder.path() / "text.stl";
  std::ofstream file(text);
  file << "solid box\n";
  for (const Corners& corners : box(3, 2, 1)) {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const Point& corner : corners) file << "vertex " << corner.transpose() << "\n";
    file << "endloop\nendfacet\n";
  }
  file << "endsolid\n";
  file.close();
  const auto read_too = read_stl(text);
  ASSERT_TRUE(read_too) << read_too.error();
  EXPECT_EQ(*read_too, box(3, 2, 1));
}

TEST(StlReader, RefusesWhatIsNone) {
  const stanok::testing::TemporaryDirectory folder;
  const auto file = folder.path() / "none.stl";
  EXPECT_FALSE(read_stl(file));
  for (const char* const text :
       {"", "M30\n", "solid\nvertex 1 2\n", "vertex 0 0 0 vertex 1 0 0 vertex nan 0 0\n",
        "vertex 0 0 0 vertex 1 0 0 vertex 2 0 0\n"}) {
    std::ofstream(file) << text;
    EXPECT_FALSE(read_stl(file)) << text;
  }
  // A binary file that promises more than is taken.
  std::string head(84, ' ');
  const std::uint32_t count = stl_triangles_max + 1;
  head.replace(80, 4, std::string(reinterpret_cast<const char*>(&count), 4));
  std::ofstream(file, std::ios::binary) << head;
  std::filesystem::resize_file(file, 84 + std::uintmax_t{count} * 50);
  const auto large = read_stl(file);
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().find("500000"), std::string::npos) << large.error();
}

}  // namespace
}  // namespace stanok::simulation

// On each face, walked round counter-clockwise from outside, the surface comes in where the walk
// enters the material and goes out where it next leaves it. A cube's edge belongs to two faces: one
// enters where the other leaves, so that the pieces join to closed loops. A neighbour walks the
// common face the other way round and gets the same pieces, turned.
#include "simulation/cube_cases.h"

namespace stanok::simulation {
namespace {

constexpr int corners = 8;
constexpr int edges = 12;
constexpr std::uint8_t no_edge = 255;

unsigned bit(unsigned axis) {
  return 1U << (axis % 3);
}

// The edge between two corners that differ in one bit.
unsigned edge_between(unsigned a, unsigned b) {
  const unsigned axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  const unsigned first = (a & bit(axis + 1)) != 0 ? 1 : 0;
  const unsigned second = (a & bit(axis + 2)) != 0 ? 2 : 0;
  return 4 * axis + first + second;
}

// Corners of a face across `axis`, counter-clockwise from outside.
std::array<unsigned, 4> low_face(unsigned axis) {
  const unsigned u = bit(axis + 1);
  const unsigned v = bit(axis + 2);
  return {0, v, u | v, u};
}

std::array<unsigned, 4> high_face(unsigned axis) {
  const unsigned u = bit(axis + 1);
  const unsigned v = bit(axis + 2);
  const unsigned base = bit(axis);
  return {base, base | u, base | u | v, base | v};
}

// next[e]: to which edge the surface goes on from edge e.
void pair_on_face(const std::array<unsigned, 4>& walk, unsigned inside,
                  std::array<std::uint8_t, edges>& next) {
  const auto is_inside = [&](unsigned i) { return (inside >> walk[i % 4] & 1U) != 0; };
  for (unsigned i = 0; i < 4; ++i) {
    if (is_inside(i) || !is_inside(i + 1)) continue;
    unsigned last = i + 1;
    while (is_inside(last + 1)) ++last;
    const unsigned enters = edge_between(walk[i], walk[(i + 1) % 4]);
    const unsigned leaves = edge_between(walk[last % 4], walk[(last + 1) % 4]);
    next[enters] = static_cast<std::uint8_t>(leaves);
  }
}

std::vector<EdgeTriangle> triangles_of_case(unsigned inside) {
  std::array<std::uint8_t, edges> next{};
  next.fill(no_edge);
  for (unsigned axis = 0; axis < 3; ++axis) {
    pair_on_face(low_face(axis), inside, next);
    pair_on_face(high_face(axis), inside, next);
  }
  std::vector<EdgeTriangle> triangles;
  for (std::uint8_t begin = 0; begin < edges; ++begin) {
    if (next[begin] == no_edge) continue;
    std::uint8_t second = next[begin];
    std::uint8_t third = next[second];
    next[begin] = next[second] = no_edge;
    while (third != begin) {
      triangles.push_back({begin, second, third});
      second = third;
      third = next[third];
      next[second] = no_edge;
    }
  }
  return triangles;
}

std::array<std::vector<EdgeTriangle>, 1U << corners> all_cases() {
  std::array<std::vector<EdgeTriangle>, 1U << corners> cases;
  for (unsigned inside = 0; inside < cases.size(); ++inside)
    cases[inside] = triangles_of_case(inside);
  return cases;
}

}  // namespace

const std::vector<EdgeTriangle>& cube_triangles(unsigned inside) {
  static const auto cases = all_cases();
  return cases[inside];
}

}  // namespace stanok::simulation

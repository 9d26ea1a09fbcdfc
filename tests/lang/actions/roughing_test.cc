// Roughing cycles against the geometry of their contour: what lies within the allowance is not
// touched, and everything else is reached.
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

// A function of the way along Z, by lines and arcs; no undercut.
struct Piece {
  double z0 = 0.0, x0 = 0.0, z1 = 0.0, x1 = 0.0;  // z falls
  bool arc = false;
  double cz = 0.0, cx = 0.0, radius = 0.0;
  bool upper = false;  // of the arc's circle

  [[nodiscard]] double at(double z) const {
    if (arc) {
      const double half = std::sqrt(std::max(radius * radius - (z - cz) * (z - cz), 0.0));
      return upper ? cx + half : cx - half;
    }
    return z0 == z1 ? std::min(x0, x1) : x0 + (x1 - x0) * (z - z0) / (z1 - z0);
  }
};

class RandomProfile {
 public:
  explicit RandomProfile(unsigned seed) : random_(seed) {
    double z = 0.0;
    double x = uniform(5.0, 30.0);
    text = line("N10 G0 X%.6f Z0\n", x);
    const int count = 3 + static_cast<int>(random_() % 6);
    for (int k = 0; k < count; ++k) {
      const double z1 = round6(z - uniform(3.0, 12.0));
      const double x1 = round6(uniform(5.0, 30.0));
      add(k + 1 == count, z, round6(x), z1, x1);
      z = z1;
      x = x1;
    }
  }

  std::vector<Piece> pieces;
  std::string text;

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // The least X of the contour at `z`; nothing outside of it.
  [[nodiscard]] std::optional<double> x_at(double z) const {
    std::optional<double> least;
    for (const Piece& piece : pieces) {
      if (z > piece.z0 + 1e-9 || z < piece.z1 - 1e-9) continue;
      const double x = piece.at(std::clamp(z, piece.z1, piece.z0));
      least = least ? std::min(*least, x) : x;
    }
    return least;
  }

 private:
  static double round6(double value) { return std::round(value * 1e6) / 1e6; }

  template <class... Numbers>
  static std::string line(const char* format, Numbers... numbers) {
    char text[200];
    std::snprintf(text, sizeof text, format, numbers...);
    return text;
  }

  void add(bool last, double z0, double x0, double z1, double x1) {
    Piece piece{z0, x0, z1, x1};
    const std::string number = last ? "N20 " : "";
    const double chord = std::hypot(z1 - z0, x1 - x0);
    const double steep = std::abs(x1 - x0) / std::abs(z1 - z0);
    if (random_() % 2 == 0 || steep > 0.8) {
      text += number + line("G1 X%.6f Z%.6f\n", x1, z1);
    } else {
      // Flat enough to stay a function of Z: the chord spans less than the half circle.
      piece.arc = true;
      piece.radius = chord * uniform(1.5, 3.0);
      piece.upper = random_() % 2 == 0;
      const double height = std::sqrt(piece.radius * piece.radius - chord * chord / 4.0);
      // Left normal of the chord; travel is along -Z, so left is -X.
      const double side = (piece.upper ? height : -height) / chord;
      piece.cz = (z0 + z1) / 2.0 - side * (x1 - x0);
      piece.cx = (x0 + x1) / 2.0 + side * (z1 - z0);
      // Over the top the way is counter-clockwise in (Z, X) when Z falls.
      text += number + line("G%d X%.6f Z%.6f I%.17f K%.17f\n", piece.upper ? 3 : 2, x1, z1,
                            piece.cx - x0, piece.cz - z0);
    }
    pieces.push_back(piece);
  }

  std::mt19937_64 random_;
};

class RoughingTest : public ProgramTest {
 protected:
  RoughingTest() {
    channel.kind = ChannelKind::lathe;
    channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
  }

  // Points of a move, along the first two channel axes X and Z.
  static std::vector<std::array<double, 2>> samples(std::array<double, 2> start, const Move& move) {
    std::vector<std::array<double, 2>> points;
    const std::array<double, 2> end{move.end[0], move.end[1]};
    for (int k = 0; k <= 50; ++k) {
      const double part = k / 50.0;
      std::array<double, 2> p{start[0] + part * (end[0] - start[0]),
                              start[1] + part * (end[1] - start[1])};
      if (move.kind == MoveKind::arc) {
        const double cz = move.centre[0];
        const double cx = move.centre[1];
        const double from = std::atan2(start[0] - cx, start[1] - cz);
        const double to = std::atan2(end[0] - cx, end[1] - cz);
        const double angle = from + part * std::remainder(to - from, 2.0 * std::acos(-1.0));
        const double radius = std::hypot(start[0] - cx, start[1] - cz);
        p = {cx + radius * std::sin(angle), cz + radius * std::cos(angle)};
      }
      points.push_back(p);
    }
    return points;
  }
};

TEST_F(RoughingTest, LeavesTheAllowanceEverywhereAndFollowsIt) {
  for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomProfile profile(seed);
    const double allowance_x = std::round(profile.uniform(0.0, 1.0) * 1e3) / 1e3;
    const double allowance_z = std::round(profile.uniform(-0.3, 0.3) * 1e3) / 1e3;
    char head[200];
    std::snprintf(head, sizeof head,
                  "G8 G94 F100 G0 X32 Z1\nG71 U%.3f R0.5\nG71 P10 Q20 U%.3f W%.3f\n",
                  profile.uniform(0.5, 4.0), allowance_x, allowance_z);
    const auto list = moves(head + profile.text + "M30\n");
    ASSERT_GT(list.size(), 4u);
    std::array<double, 2> at{32.0, 1.0};
    double followed = 0.0;
    for (std::size_t k = 1; k < list.size(); ++k) {
      for (const auto& p : samples(at, list[k])) {
        const auto x = profile.x_at(p[1] - allowance_z);
        if (!x) continue;
        EXPECT_GE(p[0], *x + allowance_x - 1e-6) << "move " << k << " at Z" << p[1];
        const bool on = std::abs(p[0] - *x - allowance_x) < 1e-6;
        if (on && list[k].kind != MoveKind::rapid) followed += 1.0;
      }
      at = {list[k].end[0], list[k].end[1]};
    }
    EXPECT_GE(followed, 50.0 * static_cast<double>(profile.pieces.size()) * 0.9);
    EXPECT_EQ(at[0], 32.0);
    EXPECT_EQ(at[1], 1.0);
  }
}

// Moves of the same contour with its corners written as moves of their own.
TEST_F(RoughingTest, TakesCornersOfTheContour) {
  const auto both = [this](const std::string& contour) {
    std::string text;
    for (const Move& move :
         moves("G8 G94 F100 G0 X32 Z1\nG71 U3 R0.5\nG71 P10 Q20 U0.4 W0.1\n" + contour + "M30\n")) {
      char one[100];
      std::snprintf(one, sizeof one, "%d %.6f %.6f\n", static_cast<int>(move.kind), move.end[0],
                    move.end[1]);
      text += one;
    }
    return text;
  };
  EXPECT_EQ(both("N10 G0 X10 Z1\nG1 Z-20 ,R3\nX20 ,C2\nZ-40\nN20 X32\n"),
            both("N10 G0 X10 Z1\nG1 Z-17\nG2 X13 Z-20 I3 K0\nG1 X18\nX20 Z-22\nZ-40\nN20 X32\n"));
  EXPECT_EQ(error_code("G8 G94 F100 G0 X32 Z1\nG71 U3 R0.5\nG71 P10 Q20 U0.4 W0.1\n"
                       "N10 G0 X10 Z1\nG1 Z-20 ,R30\nN20 X32\nM30\n"),
            "E4068");
}

TEST_F(RoughingTest, CutsNoDeeperThanTheDepthOfCutAtATime) {
  const auto list =
      moves("G8 G94 F100 G0 X20 Z1\nG71 U3 R1\nG71 P1 Q2 U0.5\nN1 G0 X5\nN2 G1 Z-20\nM30\n");
  // Levels 3, 6, ... below X20, down to X5.5.
  std::vector<double> levels;
  for (std::size_t k = 1; k < list.size(); ++k) {
    const bool pass = list[k].kind == MoveKind::line && list[k].end[1] == -20.0;
    if (pass) levels.push_back(list[k].end[0]);
  }
  EXPECT_EQ(levels, (std::vector<double>{17.0, 14.0, 11.0, 8.0, 5.5}));
}

TEST_F(RoughingTest, FacesOnLevelsOfZ) {
  const auto list =
      moves("G8 G94 F100 G0 X20 Z2\nG72 W2 R0.5\nG72 P1 Q2 W0.5\nN1 G0 Z-3\nN2 G1 X5\nM30\n");
  std::vector<double> levels;
  for (const Move& move : list) {
    if (move.kind == MoveKind::line && move.end[0] == 5.0) levels.push_back(move.end[1]);
  }
  EXPECT_EQ(levels, (std::vector<double>{0.0, -2.0, -2.5}));
}

TEST_F(RoughingTest, BoresTowardsLargerDiameters) {
  const auto list = moves(
      "G8 G94 F100 G0 X10 Z1\nG71 U4 R1\nG71 P1 Q3 U-1\nN1 G0 X20\nN2 G1 Z-10\nN3 X9 Z-15\nM30\n");
  for (const Move& move : list) EXPECT_LE(move.end[0], 19.0);
  EXPECT_EQ(list[1].end[0], 14.0);
}

}  // namespace
}  // namespace stanok::lang::testing

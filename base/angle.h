// Sine and cosine of angles in degrees: exact where the drawing is exact (multiples of 30 and 90
// deg), so that a quarter turn is one to the bit.
#pragma once

namespace stanok {

[[nodiscard]] double sine_of_degrees(double angle_deg);
[[nodiscard]] double cosine_of_degrees(double angle_deg);

}  // namespace stanok

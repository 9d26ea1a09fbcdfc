// Numbers as a person writes them: fixed point, in the C locale, whatever the locale is.
#pragma once

#include <string>

namespace stanok::process {

// The shortest text that reads back to the same bits, without an exponent where people would write
// none: "25000000", "0.56", "1e+308".
[[nodiscard]] std::string number_text(double value);

// With at least `decimals` digits behind the point, more where the value has them: "30.0",
// "0.0125".
[[nodiscard]] std::string number_text(double value, int decimals);

// Exactly `decimals` digits behind the point.
[[nodiscard]] std::string rounded_text(double value, int decimals);

}  // namespace stanok::process

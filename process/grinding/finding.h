// What a design or a verification has to say about a cycle: a code of base/catalogue.h and a text.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace stanok::process {

struct Finding {
  std::string code;  // "E9103"; W... for what is only reported
  std::string text;

  [[nodiscard]] bool is_error() const { return code.starts_with('E'); }
};

using Findings = std::vector<Finding>;

[[nodiscard]] inline bool has_errors(const Findings& findings) {
  return std::ranges::any_of(findings, &Finding::is_error);
}

}  // namespace stanok::process

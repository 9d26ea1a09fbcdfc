#include "client/operator/confirmation.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "client/terminal/output.h"
#include "client/terminal/terminal.h"

namespace stanok::client {

bool wants_confirmation(const OperatorCall& call, const protocol::Failure& failure) {
  const bool is_doubt = failure.code == "E6093" || failure.code == "E6095";
  return is_doubt && call.parameters.value("confirmed", 0) == 0 &&
         std::ranges::any_of(call.method->parameters,
                             [](const auto& one) { return one.name == "confirmed"; });
}

bool is_confirmed(const OperatorCall& call, const protocol::Failure& failure) {
  const bool is_at_terminal =
      Terminal(STDIN_FILENO).is_terminal() && Terminal(STDERR_FILENO).is_terminal();
  if (!is_at_terminal || call.form == OutputForm::json) return false;
  write_message(failure.message + ". Really? [y/N] ");
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "Y" || answer == "yes";
}

}  // namespace stanok::client

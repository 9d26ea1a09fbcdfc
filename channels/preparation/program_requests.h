// From a request of the interpreter to the one that the coordinator takes.
#pragma once

#include "channels/messages/request.h"
#include "channels/stores/shared_variables.h"
#include "lang/contract/command.h"

namespace stanok::channels {

// The program has declared the shared variable of a request for one.
[[nodiscard]] Request request_of(const lang::ProgramRequest& request,
                                 const SharedVariables& shared);

// Of a table of the machine; requests::Standstill where it is none of that kind.
[[nodiscard]] Request table_request_of(const lang::ProgramRequest& request);

}  // namespace stanok::channels

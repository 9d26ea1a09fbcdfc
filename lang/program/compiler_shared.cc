// Declarations of shared variables. They live in the machine; a program only names them.
#include "lang/program/compiler.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr double shared_elements_max = 65536.0;

}  // namespace

void Compiler::compile_shared(const DeclaredItem& item, Type type) {
  const auto refuse = [&](std::string message, std::string label) {
    reporter_.error("E3020", item.span, std::move(message), std::move(label));
  };
  if (function_ != nullptr || scopes_.size() > 1) {
    return refuse("a shared variable is declared at file level", "inside braces");
  }
  if (type == Type::axis) return refuse("a shared variable is a num, bool or string", "an axis");
  if (item.initial || item.has_list) {
    return refuse("a shared variable has no initial value", "it is 0 when the machine starts");
  }
  SharedVariable variable;
  variable.name = folded(item.name);
  variable.is_text = type == Type::string;
  variable.is_bool = type == Type::boolean;
  variable.is_array = !item.dimensions.empty();
  variable.place = file_.source.place(item.span);
  std::uint32_t sizes[2] = {1, 0};
  for (std::size_t i = 0; i < item.dimensions.size() && i < 2; ++i) {
    const auto size = constant_of(item.dimensions[i]);
    const bool good = size && size->type == Type::number && is_integer(size->number) &&
                      size->number >= 1.0 && size->number <= shared_elements_max;
    if (!good) return refuse("the size of a shared array is a constant from 1 to 65536", "");
    sizes[i] = static_cast<std::uint32_t>(size->number);
  }
  variable.rows = sizes[0];
  variable.columns = sizes[1];
  Symbol symbol;
  symbol.type.type = type;
  symbol.type.dimensions = static_cast<int>(item.dimensions.size());
  symbol.shared = static_cast<int>(file_.shared.size());
  if (declare(item.name, item.span, std::move(symbol)) != nullptr)
    file_.shared.push_back(std::move(variable));
}

}  // namespace stanok::lang

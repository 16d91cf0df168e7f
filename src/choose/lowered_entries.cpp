// lowered_entries: see lowered_entries.hpp.
#include "choose/lowered_entries.hpp"

#include "lower/network/cheapest.hpp"
#include "lower/network/linearise.hpp"
#include "lower/network/turn_signs.hpp"

namespace elgen {
namespace {

Function lowered(const Expressions& together, const Function& shape, Program& program,
                 Splits splits) {
  Function function = unfilled(shape);
  function.form = Form::closed;
  linearise(cheapest_network(together, function, splits), program, function);
  return function;
}

void append_entry(Function& to, Field& field, const Function& one) {
  const auto offset = static_cast<std::uint32_t>(to.instructions.size());
  for (Instruction i : one.instructions) {
    if (operand_count(i) > 0) i.a += offset;
    if (operand_count(i) > 1) i.b += offset;
    to.instructions.push_back(i);
  }
  to.names.resize(to.instructions.size());
  field.entries.push_back(one.fields[0].entries[0] + offset);
}

}  // namespace

Function lowered_together(const ReadableEntries& entries, const Function& shape, Program& program,
                          Splits splits) {
  Expressions readable;
  Expressions compact;
  for (const auto& entry : entries) {
    const Expressions& read = entry->is_rewritten ? entry->compact : entry->readable;
    readable.values.push_back(copied(readable.graph, read));
    compact.values.push_back(copied(compact.graph, entry->compact));
  }
  Function first = lowered(readable, shape, program, splits);
  Function second = lowered(compact, shape, program, splits);
  const bool is_second = cost(count_operations(second)) < cost(count_operations(first));
  return is_second ? second : first;
}

Function lowered_one_by_one(const ReadableEntries& entries, const Function& shape,
                            Program& program) {
  Function readable{
      .kind = shape.kind, .user = shape.user, .name = shape.name, .form = Form::closed};
  std::size_t next = 0;
  for (const Field& field : shape.fields) {
    Field& filled = readable.fields.emplace_back(Field{field.name, field.rows, field.columns, {}});
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      Function one;
      one.fields = {Field{"", 1, 1, {0}}};
      Network network = make_network(entries[next++]->readable);
      turn_signs(network);
      linearise(network, program, one);
      append_entry(readable, filled, one);
    }
  }
  return readable;
}

}  // namespace elgen

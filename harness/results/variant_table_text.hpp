// variant_table_text.hpp: the table of a sweep's variants as CSV, in full precision, and as Markdown to read.
#pragma once

#include "variant_table.hpp"

#include <string>

namespace twiddle::results
{

// The text of choices.csv: one row a variant and model.
std::string variants_csv(const Sweep &sweep, const VariantTable &table);

// The text of choices.md: one row a variant.
std::string variants_markdown(const Sweep &sweep, const VariantTable &table);

} // namespace twiddle::results

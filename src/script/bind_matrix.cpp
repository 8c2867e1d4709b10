// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "render/plot.hpp"
#include "script/bind.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/numbers.hpp"
#include "script/picture.hpp"

namespace meander::script {
namespace {

std::optional<Numbers> row(const Matrix& matrix, lua_Integer i) {
  if (i < 1 || i > static_cast<lua_Integer>(matrix.rows)) return std::nullopt;
  return Numbers(matrix.cells, matrix.cells->data() + static_cast<std::size_t>(i - 1) * matrix.columns, matrix.columns);
}
Numbers column(const Matrix& matrix, int i) {
  if (i < 1 || i > static_cast<int>(matrix.columns)) fail("there are columns 1 to {}, got {}", matrix.columns, i);
  return Numbers(matrix.cells, matrix.cells->data() + (i - 1), matrix.rows,
                 static_cast<std::ptrdiff_t>(matrix.columns * sizeof(float)));
}
Numbers all(const Matrix& matrix) { return numbers_of(matrix.cells, *matrix.cells); }
int rows(const Matrix& matrix) { return static_cast<int>(matrix.rows); }
int columns(const Matrix& matrix) { return static_cast<int>(matrix.columns); }

std::vector<std::vector<double>> totable(const Matrix& matrix) {
  std::vector<std::vector<double>> list(matrix.rows);
  for (std::size_t i = 0; i < matrix.rows; ++i) {
    const auto begin = matrix.cells->begin() + static_cast<std::ptrdiff_t>(i * matrix.columns);
    list[i].assign(begin, begin + static_cast<std::ptrdiff_t>(matrix.columns));
  }
  return list;
}

std::string text(const Matrix& matrix) { return fmt::format("matrix: {} x {}", matrix.rows, matrix.columns); }

DrawList picture(const Matrix& matrix) { return draw_heat_map(*matrix.cells, rows(matrix), columns(matrix)); }

Matrix make(const std::vector<std::vector<double>>& list) {
  Matrix matrix{nullptr, list.size(), list.empty() ? 0 : list.front().size()};
  auto cells = std::make_shared<std::vector<float>>();
  for (const std::vector<double>& line : list) {
    if (line.size() != matrix.columns)
      fail("rows of equal length expected, got {} and {}", matrix.columns, line.size());
    for (const double value : line) cells->push_back(static_cast<float>(value));
  }
  matrix.cells = std::move(cells);
  return matrix;
}

}  // namespace

void bind_matrix(lua_State* L) {
  Module(L, "meander", "")
      .function<&make>(Doc{.name = "matrix",
                           .text = "A native copy of a list of rows (32-bit numbers).",
                           .args = {{"rows", "lists of equal length"}},
                           .returns = "the copy",
                           .errors = "rows of different length",
                           .example = "print(meander.matrix { {1, 2}, {3, 4} }[2][1])"});
  Type<Matrix>(L, "Rows of native numbers: m[i] is a view of row i, #m their number.")
      .method<&column>(Doc{.name = "column",
                           .text = "A view of a column.",
                           .args = {{"index", "1 first"}},
                           .returns = "the column",
                           .errors = "no such column",
                           .example = "print(meander.matrix({ {1, 2}, {3, 4} }):column(2))"})
      .method<&all>(Doc{.name = "all",
                        .text = "A view of everything, row after row.",
                        .returns = "the numbers",
                        .example = "print(meander.matrix({ {1, 2}, {3, 4} }):all():max())"})
      .method<&totable>(Doc{.name = "totable",
                            .text = "A copy as plain lists.",
                            .returns = "list of rows",
                            .example = "print(#meander.matrix({ {1, 2}, {3, 4} }):totable())"})
      .property<&rows>(PropertyDoc{
          .name = "rows", .text = "How many rows.", .example = "print(meander.matrix({ {1, 2}, {3, 4} }).rows)"})
      .property<&columns>(PropertyDoc{.name = "columns",
                                      .text = "How many columns.",
                                      .example = "print(meander.matrix({ {1, 2}, {3, 4} }).columns)"})
      .length<&rows>()
      .element<&row>()
      .text<&text>()
      .picture<&picture>();
}

}  // namespace meander::script

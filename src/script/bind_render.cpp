// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <lauxlib.h>

#include "render/layers.hpp"
#include "render/picture_file.hpp"
#include "render/plot.hpp"
#include "render/terminal.hpp"
#include "script/any.hpp"
#include "script/bind.hpp"
#include "script/example_text.hpp"
#include "script/file_access.hpp"
#include "script/kit_function.hpp"
#include "script/kit_module.hpp"
#include "script/kit_type.hpp"
#include "script/live_view.hpp"
#include "script/picture.hpp"
#include "script/values.hpp"

namespace meander::script {

struct SaveTable {
  PictureSize size;
  std::vector<Mark> hide;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SaveTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.size, visit);
  visit(Field{"hide", "", "layers to leave out"}, o.hide);
}

struct TextTable {
  TerminalSize size;
  TerminalMode mode = TerminalMode::ascii;
  std::vector<Mark> hide;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, TextTable>
void fields(Options& o, Visitor&& visit) {
  fields(o.size, visit);
  visit(Field{"mode", "", "which characters and colours"}, o.mode);
  visit(Field{"hide", "", "layers to leave out"}, o.hide);
}

struct HistogramTable {
  int bins = 0;
  PlotWords words;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, HistogramTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"bins", "", "number of intervals; 0: by the count of the values", 0, 1000}, o.bins);
  fields(o.words, visit);
}

struct AnimateTable {
  double rate = 20;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, AnimateTable>
void fields(Options& o, Visitor&& visit) {
  visit(Field{"rate", "1/s", "pictures per second, at most", 0.1, 100}, o.rate);
}

namespace {

void save(const Any& what, const OutputFile& file, const SaveTable& options) {
  save_picture(file.path, without(*drawing_of(what.L, what.index), options.hide), options.size);
}

std::string text(const Any& what, const TextTable& options) {
  const DrawList list = without(*drawing_of(what.L, what.index), options.hide);
  return meander::text(terminal_frame(list, options.size, options.mode));
}

DrawList curve(const Drawn& values, const PlotWords& words) { return draw_curve(values.list, words); }
DrawList histogram(const Drawn& values, const HistogramTable& table) {
  return draw_histogram(values.list, table.bins, table.words);
}
DrawList heat_map(const Rows& rows, const PlotWords& words) {
  const Matrix& matrix = rows.matrix;
  return draw_heat_map(*matrix.cells, static_cast<int>(matrix.rows), static_cast<int>(matrix.columns), words);
}

/// The picture that a frame function returned, if it did.
std::shared_ptr<const DrawList> next_picture(const Function& frame, int number) {
  lua_State* L = frame.invoke(1, number);
  std::shared_ptr<const DrawList> picture;
  if (lua_toboolean(L, -1)) picture = drawing_of(L, lua_gettop(L));
  lua_pop(L, 1);
  return picture;
}

void animate(const Function& frame, const AnimateTable& options, const Call& call) {
  std::shared_ptr<const DrawList> shown;
  LiveView view(call, 0, options.rate, [&] { return shown ? std::optional(*shown) : std::nullopt; });
  for (int number = 1;; ++number) {
    call.work().poll();
    const auto picture = next_picture(frame, number);
    if (!picture) break;
    shown = picture;
    view.next(*shown, "Ctrl-C ends");
  }
}

DrawList itself(const DrawList& picture) { return picture; }
std::string words(const DrawList& picture) { return fmt::format("picture: {} items", picture.items.size()); }

void bind_plots(Module& module) {
  module
      .function<&curve>(Doc{.name = "curve",
                            .text = "A picture of numbers over their index; show(numbers) is the same without words.",
                            .args = {{"values", "a list or view of numbers; gaps where they are not finite"},
                                     {"words", "what stands beside it"}},
                            .returns = "the picture, for show and save",
                            .errors = "no finite number",
                            .example = "show(meander.render.curve({3, 1, 2}, { y = 'error [m]' }))"})
      .function<&histogram>(Doc{.name = "histogram",
                                .text = "A picture of how often numbers fall into equal intervals.",
                                .args = {{"values", "a list or view of numbers"}, {"options", "intervals and words"}},
                                .returns = "the picture, for show and save",
                                .errors = "no finite number",
                                .example = "show(meander.render.histogram({1, 2, 2, 3}, { bins = 3 }))"})
      .function<&heat_map>(
          Doc{.name = "heat_map",
              .text = "A picture of a matrix, first row on top; dark is much.",
              .args = {{"matrix", "the numbers, or a list of rows of them"}, {"words", "what stands beside it"}},
              .returns = "the picture, for show and save",
              .errors = "no finite number",
              .example = "show(meander.render.heat_map { {1, 2}, {3, 4} })"});
}

}  // namespace

void bind_render(lua_State* L) {
  Module module(L, "meander.render", "Pictures: files, texts, plots, moving ones.");
  module
      .function<&save>(Doc{
          .name = "save",
          .text = "Writes a picture of anything that show() draws.",
          .args = {{"object", "what to draw"}, {"path", "a .svg or .png file"}, {"options", "size of a .png, layers"}},
          .errors = "something that has no picture; another suffix; the file cannot be written",
          .example = EXAMPLE_SIM "meander.render.save(s, os.tmpname() .. '.png', { width = 400, hide "
                                 "= { 'cone', 'label' } })"})
      .function<&text>(Doc{.name = "text",
                           .text = "The picture as lines of text, for logs and tests.",
                           .args = {{"object", "what to draw"}, {"options", "size, kind of characters, layers"}},
                           .returns = "the lines, each with its line feed",
                           .errors = "something that has no picture",
                           .example = EXAMPLE_SIM "print(meander.render.text(s, { columns = 40, rows = 12 }))"})
      .function<&animate>(
          Doc{.name = "animate",
              .text = "Shows what a function returns, again and again, until it returns nil or false; the last picture "
                      "stays. Without a terminal only that is shown.",
              .args = {{"frame", "function(number) that returns something to see"}, {"options", "how fast"}},
              .errors = "something that has no picture; errors of the function",
              .example = EXAMPLE_SIM "meander.render.animate(function(i) s:step(0.3, 0.2) return i <= 10 and s end)"});
  bind_plots(module);
  Type<DrawList>(L, "Something drawn: show() shows it, meander.render.save writes it.")
      .text<&words>()
      .picture<&itself>();
}

}  // namespace meander::script

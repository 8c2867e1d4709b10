// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <optional>
#include <vector>

#include "render/frame.hpp"
#include "render/viewport.hpp"

namespace meander {

/// [half characters] radius below which a body shows its heading by a character.
inline constexpr double kLeastBody = 4;

/// Writes texts over a frame. A text that would touch an earlier one or cover a higher mark is left out.
class Lettering {
 public:
  /// `shown` is the highest mark in each cell of the frame, `pixels` leads from metres to half characters.
  Lettering(Frame& frame, std::vector<Mark> shown, const Viewport& pixels);

  void write(const DrawText& text);
  /// The arrow of a body that is too small to show one of its own.
  void write(const DrawBody& body);

 private:
  std::optional<int> free_line(Mark mark, int first, int length, int row) const;
  bool crowded(int first, int length, int row) const;
  bool covers(Mark mark, int first, int length, int row) const;
  void put(int column, int row, char32_t code, Color ink, Color halo);
  std::size_t index(int column, int row) const;

  Frame& frame_;
  Viewport pixels_;
  std::vector<Mark> shown_;
  std::vector<bool> taken_;
};

}  // namespace meander

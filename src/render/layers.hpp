// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <utility>
#include <vector>

#include "base/fields.hpp"
#include "render/draw_list.hpp"

namespace meander {

template <>
struct EnumNames<Mark> {
  static constexpr std::pair<Mark, const char*> entries[] = {
      {Mark::ground, "ground"},       {Mark::grid, "grid"},       {Mark::cell, "cell"},   {Mark::bar, "bar"},
      {Mark::sweep, "sweep"},         {Mark::cone, "cone"},       {Mark::place, "place"}, {Mark::light, "light"},
      {Mark::open_door, "open_door"}, {Mark::wall, "wall"},       {Mark::door, "door"},   {Mark::mover, "mover"},
      {Mark::path, "path"},           {Mark::curve, "curve"},     {Mark::echo, "echo"},   {Mark::start, "start"},
      {Mark::goal, "goal"},           {Mark::contact, "contact"}, {Mark::label, "label"}, {Mark::robot, "robot"}};
};

/// The list without the items of some marks: the layers of a picture.
DrawList without(const DrawList& list, const std::vector<Mark>& hidden);

}  // namespace meander

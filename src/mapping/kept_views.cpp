// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/kept_views.hpp"

#include "base/error.hpp"

namespace meander {

const KeptViews::Tile* KeptViews::find(Cell cell) const {
  const Place at = place(cell);
  if (last_ && at == last_place_) return last_;
  const auto found = tiles_.find(at);
  if (found == tiles_.end()) return nullptr;
  last_place_ = at;
  return last_ = &found->second;
}

KeptViews::Tile& KeptViews::tile(Cell cell) {
  const auto [found, is_new] = tiles_.try_emplace(place(cell));
  if (is_new) {
    found->second.opinions.resize(views_);
    bytes_ += sizeof(Tile) + views_ * sizeof(found->second.opinions[0]);
  }
  return found->second;
}

std::int8_t KeptViews::opinion(Cell cell, int view) const {
  const Tile* tile = find(cell);
  if (!tile) return kNone;
  const auto& opinions = tile->opinions[static_cast<std::size_t>(view)];
  return opinions ? (*opinions)[index(cell)] : kNone;
}

std::int32_t KeptViews::sum(Cell cell) const {
  const Tile* tile = find(cell);
  return tile ? tile->sums[index(cell)] : 0;
}

void KeptViews::keep_opinion(Cell cell, int view, std::int8_t opinion) {
  auto& opinions = tile(cell).opinions[static_cast<std::size_t>(view)];
  if (!opinions) {
    opinions = std::make_unique<Opinions>();
    opinions->fill(kNone);
    bytes_ += sizeof(Opinions);
  }
  (*opinions)[index(cell)] = opinion;
}

void KeptViews::check_room() const {
  if (bytes_ >= most_bytes_) fail<Error>("the global map is full: {} bytes of what views said are kept", most_bytes_);
}

void KeptViews::clear() {
  tiles_.clear();
  last_ = nullptr;
  bytes_ = 0;
}

}  // namespace meander

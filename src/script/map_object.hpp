// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/sonar_map.hpp"
#include "script/kit_object.hpp"

namespace meander::script {

template <>
struct ObjectName<SonarMap> {
  static constexpr const char* value = "map";
};
inline std::size_t native_size(const SonarMap& map) { return sizeof(SonarMap) + map.bytes(); }

}  // namespace meander::script

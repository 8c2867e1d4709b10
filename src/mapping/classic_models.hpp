// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/sonar_model.hpp"

namespace meander {

/// The sonar profile of [ME85]: free inside the cone, less so towards its sides and its end; occupied in a shell around
/// the range. Cones are independent. Throws ArgumentError.
SonarModel cone_model(const RingLayout& ring, const ConeModelOptions& options = {});

/// The model of the range_sensor_layer of ROS's navigation, from its published formulas: like that of [ME85], but a
/// shell whose depth grows with the range, and weights that fade around a reliable distance. The defaults of both are
/// the best of 40 draws on rooms that nothing is reported of. Throws ArgumentError.
SonarModel range_layer_model(const RingLayout& ring, const RangeLayerOptions& options = {});

}  // namespace meander

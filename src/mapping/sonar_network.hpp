// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include "mapping/network_score.hpp"
#include "mapping/sonar_features.hpp"
#include "robot/sonar_lessons.hpp"

namespace meander {

/// Where the weights of a network come from, in words, each of one line.
struct Provenance {
  std::string sonar;    ///< the preset or kind of sonar it was trained for
  std::string made_by;  ///< what made it, with the seed
};

/// Throws ArgumentError unless the text is one line without control characters, as names and origins of networks are:
/// others could not be read back.
void check_words(const std::string& what, const std::string& text);

/// A network that reads one kind of sonar ring.
struct SonarNetwork {
  std::string name;  ///< of the kind of features, or of one's own
  RingLayout ring;
  SonarFeatures features;
  Network network;
  double prior = 0;  ///< log-odds of the prior in its training, [CN] eq. (3); 0: balanced
  Provenance provenance;
};

/// The lessons as the network sees them. Throws ArgumentError when their ring is none for networks.
Examples examples_of(const SonarLessons& lessons, const SonarFeatures& features, const Work& work = {});

/// Trains a network of these features from lessons. Throws ArgumentError.
SonarNetwork train_sonar_network(const std::string& name, const SonarFeatures& features, const SonarLessons& lessons,
                                 const SonarLessons& validation, const TrainingOptions& options, const Work& work = {},
                                 const std::function<void(const TrainingEpoch&)>& on_epoch = {});

/// Of any sensor model. Throws ArgumentError when the lessons are of another ring or one of the classes is missing.
NetworkScore model_score(const SonarModel& model, const SonarLessons& lessons, const Work& work = {});

/// The network as a sensor model, exactly or compiled to a lookup table.
SonarModel network_model(const SonarNetwork& network);
SonarModel table_model(const SonarNetwork& network);

/// The shipped one of this name for a preset of the sonar. Throws ArgumentError when there is none for it or for the
/// ring.
SonarNetwork shipped_network(const std::string& name, const std::string& preset, const RingLayout& ring);

}  // namespace meander

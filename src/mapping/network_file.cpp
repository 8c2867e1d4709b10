// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "mapping/network_file.hpp"

#include <charconv>
#include <cmath>

#include "base/atomic_file.hpp"
#include "base/data_folder.hpp"
#include "base/hash.hpp"
#include "base/text_file.hpp"
#include "base/visible_text.hpp"

namespace meander {
namespace {

constexpr const char* kFirstLine = "meander sonar network 1";
constexpr std::size_t kMostText = 16u << 20;

std::string checksum_of(std::string_view text) { return Hash().add(text).hex(); }

/// Takes a text apart, line by line and word by word.
class Lines {
 public:
  Lines(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  template <class... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) const {
    fail<FileError>("{}:{}: {}", path_, line_, fmt::format(format, std::forward<Args>(args)...));
  }

  void next() {
    ++line_;
    if (end_ >= text_.size()) refuse("the file is cut short");
    begin_ = end_;
    end_ = text_.find('\n', begin_);
    if (end_ == std::string::npos) {
      end_ = text_.size();
      refuse("the file is cut short");
    }
    rest_ = std::string_view(text_).substr(begin_, end_ - begin_);
    ++end_;
  }
  /// The next line, which begins with this word.
  void next(std::string_view key) {
    next();
    if (word() != key) refuse("'{}' expected, got '{}'", key, visible(begin_line()));
  }
  std::string_view word() {
    const std::size_t space = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, space);
    rest_.remove_prefix(std::min(space + 1, rest_.size()));
    return word;
  }
  template <class T>
  T number(const char* what) {
    const std::string_view text = word();
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      refuse("{}: number expected, got '{}'", what, visible(text));
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value)) refuse("{}: finite number expected, got '{}'", what, visible(text));
    return value;
  }
  bool flag(const char* what) {
    const int value = number<int>(what);
    if (value != 0 && value != 1) refuse("{}: 0 or 1 expected, got {}", what, value);
    return value == 1;
  }
  std::string_view rest() const { return rest_; }
  void end_of_line() const {
    if (!rest_.empty()) refuse("end of the line expected, got '{}'", visible(rest_));
  }
  std::string_view begin_line() const { return std::string_view(text_).substr(begin_, end_ - 1 - begin_); }
  std::string_view before() const { return std::string_view(text_).substr(0, begin_); }
  bool done() const { return end_ >= text_.size(); }

 private:
  static std::string visible(std::string_view text) { return visible_text(std::string(text.substr(0, 60))); }

  const std::string& text_;
  const std::string& path_;
  std::size_t begin_ = 0, end_ = 0;
  std::string_view rest_;
  int line_ = 0;
};

/// Whatever the called function says is wrong, is so at this line.
template <class Check>
void checked(const Lines& lines, const Check& check) {
  std::string problem;
  try {
    check();
    return;
  } catch (const ArgumentError& error) {
    problem = error.what();
  }
  lines.refuse("{}", problem);
}

/// The rest of the next line.
std::string read_words(Lines& lines, const char* key) {
  lines.next(key);
  const std::string words(lines.rest());
  checked(lines, [&] { check_words(key, words); });
  return words;
}

void read_features(Lines& lines, SonarFeatures& features) {
  lines.next("features");
  features.sonars = lines.number<int>("sonars");
  features.bearing = lines.flag("bearing");
  features.residual = lines.flag("residual");
  features.range_cap = lines.number<double>("range cap");
  features.reach = lines.number<double>("reach");
  features.residual_scale = lines.number<double>("residual scale");
  lines.end_of_line();
  checked(lines, [&] { check_features(features); });
}

void read_ring(Lines& lines, RingLayout& ring) {
  lines.next("ring");
  ring.count = lines.number<int>("count");
  ring.radius = lines.number<double>("radius");
  ring.first = lines.number<double>("first");
  lines.end_of_line();
  checked(lines, [&] { validate(ring, "ring."); });
}

void read_layers(Lines& lines, const SonarFeatures& features, std::vector<int>& layers) {
  lines.next("layers");
  while (!lines.rest().empty() && layers.size() <= kMostLayers) layers.push_back(lines.number<int>("layers"));
  checked(lines, [&] { check_layers(layers); });
  if (layers.front() != features.inputs())
    lines.refuse("another architecture: the features make {} inputs, the layers begin with {}", features.inputs(),
                 layers.front());
}

void read_weights(Lines& lines, Network& network) {
  network.weights.reserve(weight_count(network.layers));
  for (std::size_t l = 1; l < network.layers.size(); ++l)
    for (int unit = 0; unit < network.layers[l]; ++unit) {
      lines.next();
      for (int i = 0; i <= network.layers[l - 1]; ++i) network.weights.push_back(lines.number<float>("weight"));
      lines.end_of_line();
    }
}

}  // namespace

std::string network_text(const SonarNetwork& n) {
  const SonarFeatures& f = n.features;
  check_words("name", n.name);
  check_words("sonar", n.provenance.sonar);
  check_words("made_by", n.provenance.made_by);
  std::string text = fmt::format(
      "{}\nname {}\nfeatures {} {} {} {} {} {}\nring {} {} {}\nsonar {}\nmade_by {}\nlayers {}\nprior {}\n", kFirstLine,
      n.name, f.sonars, int{f.bearing}, int{f.residual}, f.range_cap, f.reach, f.residual_scale, n.ring.count,
      n.ring.radius, n.ring.first, n.provenance.sonar, n.provenance.made_by, fmt::join(n.network.layers, " "), n.prior);
  std::size_t next = 0;
  for (std::size_t l = 1; l < n.network.layers.size(); ++l)
    for (int unit = 0; unit < n.network.layers[l]; ++unit) {
      const auto count = static_cast<std::size_t>(n.network.layers[l - 1] + 1);
      text += fmt::format("{}\n", fmt::join(std::span(n.network.weights).subspan(next, count), " "));
      next += count;
    }
  return text + fmt::format("checksum {}\n", checksum_of(text));
}

SonarNetwork network_from_text(const std::string& text, const std::string& path) {
  Lines lines(text, path);
  lines.next();
  if (lines.rest() != kFirstLine) lines.refuse("no sonar network of this version: '{}' expected", kFirstLine);
  SonarNetwork network;
  network.name = read_words(lines, "name");
  read_features(lines, network.features);
  read_ring(lines, network.ring);
  network.provenance.sonar = read_words(lines, "sonar");
  network.provenance.made_by = read_words(lines, "made_by");
  read_layers(lines, network.features, network.network.layers);
  lines.next("prior");
  network.prior = lines.number<double>("prior");
  lines.end_of_line();
  read_weights(lines, network.network);
  lines.next("checksum");
  if (lines.rest() != checksum_of(lines.before())) lines.refuse("the checksum does not fit: the file is damaged");
  if (!lines.done()) lines.refuse("more text after the checksum");
  return network;
}

SonarNetwork read_network(const std::string& path) {
  return network_from_text(read_text_file(readable_file(path), kMostText), path);
}

void write_network(const SonarNetwork& network, const std::string& path) {
  write_file_atomically(path, network_text(network));
}

}  // namespace meander

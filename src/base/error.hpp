// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace meander {

/// Misuse or unusable input. Reaches a script as a Lua error at the caller's line. Messages say what, where, and what
/// was expected, start in lower case and carry no final stop.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value that the called function cannot take.
class ArgumentError : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read, parsed or written: "path:line:column: what".
class FileError : public Error {
 public:
  using Error::Error;
};

/// A handle whose thing was removed.
class StaleError : public Error {
 public:
  using Error::Error;
};

/// Thrown by a polled stop token. Deliberately no std::exception: nothing but the border to the user may catch it.
struct Cancelled {};

template <class E = ArgumentError, class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
  throw E(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace meander
